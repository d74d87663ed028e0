// Two hosts in one C++11 program, turn by turn: what one does never reaches the other.
#include <tsuya/tsuya.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <vector>

static int failures = 0;

static void expect(bool good, const char *what)
{
    if (!good) {
        std::fprintf(stderr, "not so: %s\n", what);
        failures++;
    }
}

struct Host {
    std::map<void *, std::size_t> blocks;
    std::vector<std::string> lines;
    bool foreign = false; // a block or a size that is not this host's
    const char *snippet = nullptr;
    tsu_context *context = nullptr;
    tsu_set *set = nullptr;
    tsu_shader *shader = nullptr;
};

static void *allocate(void *user, void *pointer, std::size_t old_size, std::size_t size)
{
    Host &host = *static_cast<Host *>(user);
    if (pointer) {
        const auto at = host.blocks.find(pointer);
        if (at == host.blocks.end() || at->second != old_size) {
            host.foreign = true;
            return nullptr;
        }
        host.blocks.erase(at);
    }
    if (size == 0) {
        std::free(pointer);
        return nullptr;
    }
    void *grown = std::realloc(pointer, size);
    if (grown)
        host.blocks[grown] = size;
    return grown;
}

static void log_line(void *user, std::int32_t, std::int32_t, const char *text)
{
    static_cast<Host *>(user)->lines.push_back(text);
}

static std::int32_t read_file(void *user, const char *name, const char **text, std::size_t *size)
{
    const Host &host = *static_cast<Host *>(user);
    if (!host.snippet || std::strcmp(name, "prelude/records.glsl") != 0)
        return 0;
    *text = host.snippet;
    *size = std::strlen(host.snippet);
    return 1;
}

static void open(Host &host)
{
    tsu_context_desc desc;
    tsu_set_desc set_desc;
    expect(tsu_context_desc_init(&desc) == TSU_OK, "the descriptor begins");
    desc.allocate = allocate;
    desc.log = log_line;
    desc.read = read_file;
    desc.allocate_user = desc.log_user = desc.read_user = &host;
    expect(tsu_context_create(&desc, &host.context) == TSU_OK, "a context");
    expect(tsu_set_desc_init(&set_desc) == TSU_OK, "the set's descriptor begins");
    expect(tsu_set_create(host.context, &set_desc, &host.set) == TSU_OK, "a set");
}

static void close(Host &host)
{
    tsu_shader_destroy(host.shader);
    tsu_set_destroy(host.set);
    tsu_context_destroy(host.context);
}

static std::uint32_t add(Host &host, float eta)
{
    tsu_marschner_params hair;
    std::uint32_t material = 99;
    expect(tsu_marschner_params_init(&hair) == TSU_OK, "parameters begin");
    hair.eta = eta;
    hair.beta_az = 0.4f;
    expect(tsu_set_add(host.set, tsu_marschner(), &hair, &material) == TSU_OK, "a material");
    return material;
}

static void shade(Host &host)
{
    const tsu_model *model = tsu_marschner();
    tsu_shader_desc desc;
    expect(tsu_shader_desc_init(&desc) == TSU_OK, "the shader's descriptor begins");
    desc.models = &model;
    desc.model_count = 1;
    expect(tsu_shader_create(host.context, &desc, &host.shader) == TSU_OK, "a shader");
}

static tsu_set_info describe(const Host &host)
{
    tsu_set_info info;
    expect(tsu_set_info_init(&info) == TSU_OK, "an info begins");
    expect(tsu_set_describe(host.set, &info) == TSU_OK, "a description");
    return info;
}

int main()
{
    Host a, b;
    open(a);
    open(b);
    b.snippet = "#define TSU_PAGE(k) tsu_records[k]\n"
                "#define TSU_RECORD(material, k) tsu_records[(material) * 8 + (8 + (k))]\n"
                "// of b alone\n";

    // Equal tables in two sets, indices and counters of their own.
    for (int i = 0; i < 3; i++) {
        const std::uint32_t index = static_cast<std::uint32_t>(i);
        expect(add(a, 1.3f + 0.1f * static_cast<float>(i)) == index, "a counts");
        if (i < 2)
            expect(add(b, 1.3f) == index, "b counts for itself");
        expect(tsu_set_bake((i & 1 ? a : b).set) == TSU_OK, "a bake in turn");
    }
    expect(describe(a).material_count == 3 && describe(a).table_count == 3, "a has three of three");
    expect(describe(b).material_count == 2 && describe(b).table_count == 1, "b has two of one");
    expect(describe(a).stale_count == 1 && describe(b).stale_count == 0, "only a waits for a bake");
    expect(describe(a).width != describe(b).width, "textures grow alone");

    // A mistake of one is told to that one.
    expect(tsu_set_remove(a.set, 77) == TSU_E_PARAMETER, "no such material");
    expect(a.lines.size() == 1 && b.lines.empty(), "only a was told");
    double sigma_a[3];
    expect(tsu_hair_melanin(b.context, -1, 0, sigma_a) == TSU_E_PARAMETER, "no such pigment");
    expect(a.lines.size() == 1 && b.lines.size() == 1, "only b was told");

    // Files of one are not seen by the other.
    shade(a);
    shade(b);
    expect(!std::strstr(tsu_shader_text(a.shader, nullptr), "of b alone"), "a has its own text");
    expect(std::strstr(tsu_shader_text(b.shader, nullptr), "of b alone") != nullptr, "b has b's");

    // One goes, the other stays whole.
    const std::size_t blocks = b.blocks.size();
    close(a);
    expect(a.blocks.empty() && !a.foreign, "a gave back all that it took");
    expect(b.blocks.size() == blocks, "b lost nothing");
    add(b, 1.9f);
    expect(tsu_set_bake(b.set) == TSU_OK && tsu_set_texels(b.set), "b still bakes");
    close(b);
    expect(b.blocks.empty() && !b.foreign, "b gave back all that it took");
    return failures != 0;
}
