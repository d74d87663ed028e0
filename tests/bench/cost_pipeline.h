// A graphics pipeline around one fragment shader, complete enough for a driver to compile it.
//
// Private to shader_cost.c, as spirv_interface.h is. Objects live until the process ends.
#ifndef TSUYA_TESTS_BENCH_COST_PIPELINE_H
#define TSUYA_TESTS_BENCH_COST_PIPELINE_H

#include "spirv_interface.h"

#include <stdarg.h>
#include <stdio.h>

// Prints "shader_cost: <text>." on stderr and ends the process with 1.
static inline void die(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fputs("shader_cost: ", stderr);
    vfprintf(stderr, format, arguments);
    fputs(".\n", stderr);
    va_end(arguments);
    exit(1);
}

// Dies unless the call that did `what` went well.
static inline void check(VkResult result, const char *what)
{
    if (result != VK_SUCCESS) {
        die("%s failed with Vulkan result %d", what, (int)result);
    }
}

static inline VkPipelineLayout make_layout(VkDevice device, const struct fragment_interface *f)
{
    VkDescriptorSetLayout sets[4];
    uint32_t set_count = 0;
    for (int i = 0; i < f->binding_count; i++) {
        set_count = f->bindings[i].set + 1 > set_count ? f->bindings[i].set + 1 : set_count;
    }
    for (uint32_t s = 0; s < set_count; s++) {
        VkDescriptorSetLayoutBinding bindings[MAX_BINDINGS];
        VkDescriptorSetLayoutCreateInfo info = {
            .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, .pBindings = bindings};
        for (int i = 0; i < f->binding_count; i++) {
            if (f->bindings[i].set == s) {
                bindings[info.bindingCount++] = f->bindings[i].layout;
            }
        }
        check(vkCreateDescriptorSetLayout(device, &info, NULL, &sets[s]), "making a set layout");
    }
    const VkPushConstantRange push = {VK_SHADER_STAGE_FRAGMENT_BIT, 0, 128};
    const VkPipelineLayoutCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
        .setLayoutCount = set_count,
        .pSetLayouts = sets,
        .pushConstantRangeCount = f->has_push_constants ? 1 : 0,
        .pPushConstantRanges = &push};
    VkPipelineLayout layout;
    check(vkCreatePipelineLayout(device, &info, NULL, &layout), "making a pipeline layout");
    return layout;
}

static inline VkPipelineShaderStageCreateInfo
make_stage(VkDevice device, VkShaderStageFlagBits stage, const uint32_t *words, size_t count,
           const char *entry)
{
    const VkShaderModuleCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                           .codeSize = count * 4,
                                           .pCode = words};
    VkPipelineShaderStageCreateInfo result = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
        .stage = stage,
        .pName = entry};
    check(vkCreateShaderModule(device, &info, NULL, &result.module), "making a shader module");
    return result;
}

// Compiles the shader `words` of interface `*f` with statistics kept, for RGBA16F targets (integer
// ones for integer outputs), no blending, and dynamic rendering.
static inline VkPipeline make_pipeline(VkDevice device, const struct fragment_interface *f,
                                       const uint32_t *words, size_t count)
{
    static struct vertex_stage vertex;
    vertex_stage_build(&vertex, f);
    const VkPipelineShaderStageCreateInfo stages[2] = {
        make_stage(device, VK_SHADER_STAGE_VERTEX_BIT, vertex.words, vertex.count, "main"),
        make_stage(device, VK_SHADER_STAGE_FRAGMENT_BIT, words, count, f->entry)};

    enum { TARGETS = 8 };
    VkFormat formats[TARGETS];
    VkPipelineColorBlendAttachmentState attachments[TARGETS];
    uint32_t targets = 0;
    for (int i = 0; i < f->output_count; i++) {
        const struct slot *output = &f->outputs[i];
        targets = output->location + 1 > targets ? output->location + 1 : targets;
    }
    if (targets > TARGETS) {
        die("the shader writes more than %d targets", TARGETS);
    }
    for (uint32_t t = 0; t < targets; t++) {
        formats[t] = VK_FORMAT_R16G16B16A16_SFLOAT;
        attachments[t] = (VkPipelineColorBlendAttachmentState){.colorWriteMask = 15};
        for (int i = 0; i < f->output_count; i++) {
            if (f->outputs[i].location == t && f->outputs[i].kind != SLOT_FLOAT) {
                formats[t] = f->outputs[i].kind == SLOT_INT ? VK_FORMAT_R32G32B32A32_SINT
                                                            : VK_FORMAT_R32G32B32A32_UINT;
            }
        }
    }
    const VkPipelineRenderingCreateInfo rendering = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
        .colorAttachmentCount = targets,
        .pColorAttachmentFormats = formats};
    const VkPipelineVertexInputStateCreateInfo input = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    const VkPipelineInputAssemblyStateCreateInfo assembly = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
    const VkViewport viewport = {0, 0, 64, 64, 0, 1};
    const VkRect2D scissor = {{0, 0}, {64, 64}};
    const VkPipelineViewportStateCreateInfo view = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
        .viewportCount = 1,
        .pViewports = &viewport,
        .scissorCount = 1,
        .pScissors = &scissor};
    const VkPipelineRasterizationStateCreateInfo raster = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO, .lineWidth = 1};
    const VkPipelineMultisampleStateCreateInfo samples = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
        .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
    const VkPipelineDepthStencilStateCreateInfo depth = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
    const VkPipelineColorBlendStateCreateInfo blend = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
        .attachmentCount = targets,
        .pAttachments = attachments};
    const VkGraphicsPipelineCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
        .pNext = &rendering,
        .flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR |
                 VK_PIPELINE_CREATE_CAPTURE_INTERNAL_REPRESENTATIONS_BIT_KHR,
        .stageCount = 2,
        .pStages = stages,
        .pVertexInputState = &input,
        .pInputAssemblyState = &assembly,
        .pViewportState = &view,
        .pRasterizationState = &raster,
        .pMultisampleState = &samples,
        .pDepthStencilState = &depth,
        .pColorBlendState = &blend,
        .layout = make_layout(device, f)};
    VkPipeline pipeline;
    check(vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &info, NULL, &pipeline),
          "compiling the pipeline");
    return pipeline;
}

#endif
