#define _POSIX_C_SOURCE 200809L // setenv, strncasecmp
// Static cost of fragment shaders on AMD hardware, without that hardware.
//
//   shader_cost [--family NAME] FILE.spv...
//   shader_cost [--family NAME] --driver
//
// Compiles each SPIR-V fragment shader in a pipeline and prints the driver's own statistics as CSV,
// `file,target,statistic,value`:
//
//   instructions         of the whole shader, as issued
//   latency              estimated clocks of one wave, memory at a fixed latency
//   inverse_throughput   estimated clocks per wave of a full machine: the figure to compare
//   vgprs, sgprs         vector registers, rounded to the allocation step; scalar registers needed
//   code_size            bytes
//   vmem_clauses         groups of texture or buffer fetches
//   fetches              instructions that sample, gather or load from an image; a loop's count
//                        once, compilers unroll loops as short as the models'. Mesa's RADV alone
//                        tells it
//
// The last stage is written to RGBA16F targets without blending. The estimates hold for ratios and
// regressions, not for milliseconds.
//
// --family NAME  compile for this chip (navi21, navi10, gfx1100, vega10, ...) with Mesa's RADV and
//                no device at all; target is NAME. Without it, the first Vulkan device is asked and
//                target is its name.
//
// --driver       print the driver's name and version and nothing else, as "radv Mesa 22.3.6".
//
// Exit: 0 when every file is printed, 1 after a sentence on stderr, 2 on wrong usage.
#include "cost_pipeline.h"

#include <glob.h>
#include <stdio.h>
#include <strings.h>

static const struct {
    const char *driver, *column;
} statistics[] = {
    {"Instructions", "instructions"},
    {"Latency", "latency"},
    {"Inverse Throughput", "inverse_throughput"},
    {"VGPRs", "vgprs"},
    {"Pre-Sched SGPRs", "sgprs"},
    {"Code size", "code_size"},
    {"VMEM Clause", "vmem_clauses"},
};

static void *need(void *memory)
{
    if (!memory) {
        die("out of memory");
    }
    return memory;
}

// The driver reads these when the instance is made.
static void choose_family(const char *family)
{
    setenv("RADV_FORCE_FAMILY", family, 1);
    glob_t found;
    if (glob("/usr/share/vulkan/icd.d/radeon_icd.*json", 0, NULL, &found) == 0) {
        setenv("VK_ICD_FILENAMES", found.gl_pathv[0], 0);
        globfree(&found);
    }
}

static VkPhysicalDevice choose_device(VkInstance instance, const char *family, char *target,
                                      size_t target_size)
{
    VkPhysicalDevice device;
    VkPhysicalDeviceProperties properties;
    uint32_t count = 1;
    const VkResult result = vkEnumeratePhysicalDevices(instance, &count, &device);
    if ((result != VK_SUCCESS && result != VK_INCOMPLETE) || count == 0) {
        die("no Vulkan device%s%s", family ? " for the family " : "", family ? family : "");
    }
    vkGetPhysicalDeviceProperties(device, &properties);
    int matches = !family;
    for (const char *at = properties.deviceName; *at && !matches; at++) {
        matches = strncasecmp(at, family, strlen(family)) == 0;
    }
    if (!matches) {
        die("asked for %s, the driver offers %s", family, properties.deviceName);
    }
    snprintf(target, target_size, "%s", family ? family : properties.deviceName);
    return device;
}

static VkDevice make_device(VkPhysicalDevice physical)
{
    static const char *const extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
    const float priority = 1;
    VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR statistics_feature = {
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR};
    VkPhysicalDeviceVulkan13Features v13 = {
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
        .pNext = &statistics_feature};
    VkPhysicalDeviceFeatures2 features = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2,
                                          .pNext = &v13};
    vkGetPhysicalDeviceFeatures2(physical, &features);
    if (!statistics_feature.pipelineExecutableInfo || !v13.dynamicRendering) {
        die("the driver tells no statistics of its shaders or has no dynamic rendering");
    }
    // Bounds checks on buffers would be counted as work of the shader.
    features.features.robustBufferAccess = VK_FALSE;
    const VkDeviceQueueCreateInfo queue = {.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                           .queueCount = 1,
                                           .pQueuePriorities = &priority};
    const VkDeviceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                     .pNext = &features,
                                     .queueCreateInfoCount = 1,
                                     .pQueueCreateInfos = &queue,
                                     .enabledExtensionCount = 1,
                                     .ppEnabledExtensionNames = &extension};
    VkDevice device;
    check(vkCreateDevice(physical, &info, NULL, &device), "making a device");
    return device;
}

static uint32_t *read_words(const char *path, size_t *count)
{
    FILE *file = fopen(path, "rb");
    if (!file || fseek(file, 0, SEEK_END) != 0) {
        die("cannot open %s", path);
    }
    const long size = ftell(file);
    rewind(file);
    uint32_t *words = need(malloc(size > 0 ? (size_t)size : 1));
    *count = fread(words, 4, size > 0 ? (size_t)size / 4 : 0, file);
    fclose(file);
    return words;
}

// The fragment shader among the pipeline's executables.
static uint32_t find_fragment(VkDevice device, VkPipeline pipeline)
{
    VkPipelineExecutablePropertiesKHR executables[8];
    uint32_t count = 8;
    const PFN_vkGetPipelineExecutablePropertiesKHR get =
        (PFN_vkGetPipelineExecutablePropertiesKHR)vkGetDeviceProcAddr(
            device, "vkGetPipelineExecutablePropertiesKHR");
    const VkPipelineInfoKHR info = {.sType = VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR,
                                    .pipeline = pipeline};
    for (uint32_t i = 0; i < count; i++) {
        executables[i] = (VkPipelineExecutablePropertiesKHR){
            .sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR};
    }
    check(get(device, &info, &count, executables), "listing the executables");
    for (uint32_t i = 0; i < count; i++) {
        if (executables[i].stages & VK_SHADER_STAGE_FRAGMENT_BIT) {
            return i;
        }
    }
    die("the driver kept no fragment shader");
    return 0;
}

// Lines of `text` that fetch from an image.
static unsigned long long count_fetches(const char *text)
{
    static const char *const words[] = {"image_sample", "image_gather", "image_load"};
    unsigned long long count = 0;
    for (size_t w = 0; w < sizeof words / sizeof *words; w++) {
        for (const char *at = strstr(text, words[w]); at; at = strstr(at + 1, words[w])) {
            count++;
        }
    }
    return count;
}

// The driver's last form of the shader before machine code, as text; NULL when it shows none.
static char *read_listing(VkDevice device, const VkPipelineExecutableInfoKHR *info)
{
    VkPipelineExecutableInternalRepresentationKHR forms[16];
    uint32_t count = 16;
    const PFN_vkGetPipelineExecutableInternalRepresentationsKHR get =
        (PFN_vkGetPipelineExecutableInternalRepresentationsKHR)vkGetDeviceProcAddr(
            device, "vkGetPipelineExecutableInternalRepresentationsKHR");
    for (uint32_t i = 0; i < count; i++) {
        forms[i] = (VkPipelineExecutableInternalRepresentationKHR){
            .sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INTERNAL_REPRESENTATION_KHR};
    }
    check(get(device, info, &count, forms), "listing the shader's forms");
    char *text = NULL;
    for (uint32_t i = 0; i < count; i++) {
        if (forms[i].isText && strcmp(forms[i].name, "ACO IR") == 0) {
            text = forms[i].pData = need(calloc(forms[i].dataSize + 1, 1));
        }
    }
    check(get(device, info, &count, forms), "reading the shader's forms");
    return text;
}

static void print_statistics(VkDevice device, VkPipeline pipeline, const char *path,
                             const char *target)
{
    VkPipelineExecutableStatisticKHR values[64];
    uint32_t count = 64;
    const PFN_vkGetPipelineExecutableStatisticsKHR get =
        (PFN_vkGetPipelineExecutableStatisticsKHR)vkGetDeviceProcAddr(
            device, "vkGetPipelineExecutableStatisticsKHR");
    const VkPipelineExecutableInfoKHR info = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR,
        .pipeline = pipeline,
        .executableIndex = find_fragment(device, pipeline)};
    for (uint32_t i = 0; i < count; i++) {
        values[i] = (VkPipelineExecutableStatisticKHR){
            .sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR};
    }
    check(get(device, &info, &count, values), "reading the statistics");
    for (size_t s = 0; s < sizeof statistics / sizeof *statistics; s++) {
        uint32_t i = 0;
        while (i < count && strcmp(values[i].name, statistics[s].driver) != 0) {
            i++;
        }
        if (i == count || values[i].format != VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR) {
            die("%s: the driver does not tell \"%s\"", path, statistics[s].driver);
        }
        printf("%s,%s,%s,%llu\n", path, target, statistics[s].column,
               (unsigned long long)values[i].value.u64);
    }
    char *const listing = read_listing(device, &info);
    if (listing) {
        printf("%s,%s,fetches,%llu\n", path, target, count_fetches(listing));
        free(listing);
    }
}

static void print_driver(VkPhysicalDevice device)
{
    VkPhysicalDeviceDriverProperties driver = {
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
    VkPhysicalDeviceProperties2 properties = {
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &driver};
    vkGetPhysicalDeviceProperties2(device, &properties);
    printf("%s %s\n", driver.driverName, driver.driverInfo);
}

int main(int argc, char **argv)
{
    const char *family = argc > 2 && strcmp(argv[1], "--family") == 0 ? argv[2] : NULL;
    const int first = family ? 3 : 1;
    const int ask_driver = first < argc && strcmp(argv[first], "--driver") == 0;
    if (first >= argc || (argv[first][0] == '-' && !ask_driver) || (ask_driver && first + 1 < argc)) {
        fputs("usage: shader_cost [--family NAME] (FILE.spv... | --driver)\n", stderr);
        return 2;
    }
    if (family) {
        choose_family(family);
    }
    const VkApplicationInfo application = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                           .apiVersion = VK_API_VERSION_1_3};
    const VkInstanceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                       .pApplicationInfo = &application};
    VkInstance instance;
    char target[VK_MAX_PHYSICAL_DEVICE_NAME_SIZE];
    check(vkCreateInstance(&info, NULL, &instance), "making a Vulkan instance");
    const VkPhysicalDevice physical = choose_device(instance, family, target, sizeof target);
    if (ask_driver) {
        print_driver(physical);
        return 0;
    }
    const VkDevice device = make_device(physical);
    puts("file,target,statistic,value");
    for (int i = first; i < argc; i++) {
        static struct fragment_interface fragment;
        size_t count;
        uint32_t *words = read_words(argv[i], &count);
        const char *wrong = spirv_reflect(words, count, &fragment);
        if (wrong || strchr(argv[i], ',')) {
            die("%s: %s", argv[i], wrong ? wrong : "a name with a comma does not fit into CSV");
        }
        const VkPipeline pipeline = make_pipeline(device, &fragment, words, count);
        print_statistics(device, pipeline, argv[i], target);
        vkDestroyPipeline(device, pipeline, NULL);
        free(words);
    }
    // The process ends here; the driver's objects go with it.
    return 0;
}
