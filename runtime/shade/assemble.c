#include "shade/assemble.h"

#include "base/host.h"
#include "shade/dialect.h"
#include "shade/reach.h"
#include "shade/snippet.h"
#include "shade/strip.h"

#include <string.h>

struct assembler {
    const tsu_context *context;
    const tsu_shader_desc *desc;
    const struct tsu_i_dialect *dialect;
    struct tsu_i_assembly *out;
};

static void put(const struct assembler *a, const char *string)
{
    tsu_i_text_string(&a->out->text, string);
}

static void put_number(const struct assembler *a, uint32_t value)
{
    tsu_i_text_number(&a->out->text, value);
}

static void put_line(const struct assembler *a, uint32_t source)
{
    put(a, "#line 1 ");
    put_number(a, source);
    put(a, "\n");
}

static int is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

static int is_word(char c)
{
    return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// The first word, then the second, however they are spaced; `whole`: the second ends there.
static int contains(const char *text, size_t size, const char *first, const char *second, int whole)
{
    const size_t a = strlen(first), b = strlen(second);
    for (size_t i = 0; i + a + b <= size; i++) {
        if (memcmp(text + i, first, a) != 0)
            continue;
        size_t k = i + a;
        while (k < size && is_space(text[k]))
            k++;
        if (k + b <= size && memcmp(text + k, second, b) == 0 &&
            (!whole || k + b == size || !is_word(text[k + b])))
            return 1;
    }
    return 0;
}

// The host's text for a file, when it has one; checked for what the host's own stage must own.
static tsu_status host_text(const struct assembler *a, const char *name, const char **text,
                            size_t *size)
{
    static const struct {
        const char *first, *second;
        int whole;
    } forbidden[] = {{"#", "version", 1}, {"void", "main", 1}, {"gl_Frag", "", 0}};
    *text = NULL;
    if (!a->context->desc.read ||
        !a->context->desc.read(a->context->desc.read_user, name, text, size))
        *text = NULL;
    for (size_t i = 0; *text && i < sizeof forbidden / sizeof *forbidden; i++)
        if (contains(*text, *size, forbidden[i].first, forbidden[i].second, forbidden[i].whole)) {
            tsu_i_log(a->context, TSU_LOG_ERROR, TSU_LOG_SNIPPET,
                      "%s from the host contains \"%s%s%s\"", name, forbidden[i].first,
                      i == 1 ? " " : "", forbidden[i].second);
            return TSU_E_HOST;
        }
    return TSU_OK;
}

static tsu_status put_file(const struct assembler *a, const char *name)
{
    for (uint32_t i = 1; i < a->out->source_count && i < TSU_I_SOURCES; i++)
        if (a->out->sources[i] && strcmp(a->out->sources[i], name) == 0)
            return TSU_OK; // shared by two models
    const struct tsu_i_snippet *snippet = tsu_i_snippets;
    while (snippet->name && strcmp(snippet->name, name) != 0)
        snippet++;
    const char *text;
    size_t size;
    const tsu_status status = host_text(a, name, &text, &size);
    if (status != TSU_OK)
        return status;
    if (!text && !snippet->name) {
        tsu_i_log(a->context, TSU_LOG_ERROR, TSU_LOG_SNIPPET, "no GLSL file %s", name);
        return TSU_E_PARAMETER;
    }
    struct tsu_i_assembly *out = a->out;
    if (out->source_count < TSU_I_SOURCES)
        out->sources[out->source_count] = snippet->name;
    put_line(a, out->source_count++);
    if (text)
        tsu_i_text_put(&out->text, text, size);
    else
        tsu_i_text_put(&out->text, (const char *)snippet->bytes, snippet->size);
    put(a, "\n");
    return TSU_OK;
}

// Models that extend another one bring its files along.
static int file_before(const tsu_shader_desc *desc, uint32_t model, const char *const *file)
{
    for (uint32_t i = 0; i <= model; i++)
        for (const char *const *other = desc->models[i]->snippets; *other && other != file; other++)
            if (strcmp(*other, *file) == 0)
                return 1;
    return 0;
}

static int listed_before(const tsu_shader_desc *desc, uint32_t index)
{
    for (uint32_t i = 0; i < index; i++)
        if (desc->models[i] == desc->models[index])
            return 1;
    return 0;
}

static void put_binding(const struct assembler *a, uint32_t binding, const char *before)
{
    put(a, before);
    put(a, "set = ");
    put_number(a, a->desc->set);
    put(a, ", binding = ");
    put_number(a, binding);
}

static int any_material(const tsu_shader_desc *desc)
{
    for (uint32_t i = 0; i < desc->model_count; i++)
        if (!(desc->models[i]->info.flags & TSU_MODEL_SHADOW))
            return 1;
    return 0;
}

// Whether a model shades surfaces, or fibres.
static int any_shades(const tsu_shader_desc *desc, uint32_t surface)
{
    for (uint32_t i = 0; i < desc->model_count; i++)
        if ((desc->models[i]->info.flags & TSU_MODEL_SURFACE) == surface)
            return 1;
    return 0;
}

static void put_resources(const struct assembler *a)
{
    if (!any_material(a->desc))
        return;
    int tables = 0;
    for (uint32_t i = 0; i < a->desc->model_count; i++)
        tables |= a->desc->models[i]->info.table_count > 0;
    if (tables) {
        if (a->dialect->bindings) {
            put_binding(a, a->desc->sampler_binding, "layout(");
            put(a, ") ");
        }
        put(a, "uniform sampler2D tsu_tables;\n");
    }
    if (a->desc->flags & TSU_SHADER_ARRAY) {
        put(a, "uniform vec4 tsu_records[");
        put_number(a, (a->desc->array_materials + 1) * 8);
        put(a, "];\n");
        return;
    }
    put(a, "layout(std140");
    if (a->dialect->bindings)
        put_binding(a, a->desc->block_binding, ", ");
    put(a, ") uniform tsu_materials {\n    vec4 tsu_records[1024];\n};\n");
}

static void put_varying(const struct assembler *a, uint32_t *location, const char *type,
                        const char *name)
{
    if (a->dialect->locations) {
        put(a, "layout(location = ");
        put_number(a, (*location)++);
        put(a, ") ");
    }
    if (strcmp(type, "int") == 0)
        put(a, "flat ");
    put(a, "in ");
    put(a, type);
    put(a, " ");
    put(a, name);
    put(a, ";\n");
}

// The variant that a harness calls: the first one of the model's that `only` names, or NULL.
static const tsu_variant_info *variant_of(const tsu_shader_desc *desc, const tsu_model *model)
{
    const char *word = desc->only;
    for (size_t size; word && (size = tsu_i_only_word(&word)) > 0; word += size)
        for (uint32_t i = 0; i < model->info.variant_count; i++)
            if (strlen(model->variants[i].name) == size &&
                memcmp(model->variants[i].name, word, size) == 0)
                return model->variants + i;
    return NULL;
}

// Whether a harness hands this input to the model.
static int takes(const tsu_shader_desc *desc, const tsu_model *model, uint32_t input)
{
    const tsu_variant_info *variant = variant_of(desc, model);
    return variant ? (variant->inputs >> input & 1u) != 0
                   : !(model->inputs[input].flags & TSU_INPUT_VARIANT);
}

// Extra inputs are shared between models by name.
static int extra_before(const tsu_shader_desc *desc, uint32_t model, const char *name)
{
    for (uint32_t i = 0; i < model; i++)
        for (uint32_t k = 0; k < desc->models[i]->info.input_count; k++)
            if (takes(desc, desc->models[i], k) &&
                strcmp(desc->models[i]->inputs[k].name, name) == 0)
                return 1;
    return 0;
}

static void put_varyings(const struct assembler *a)
{
    static const struct {
        const char *name;
        int fiber, surface;
    } fixed[] = {{"t", 1, 0}, {"n", 0, 1}, {"l", 1, 1}, {"v", 1, 1}, {"sigma_a", 1, 0}};
    const int fiber = any_shades(a->desc, 0), surface = any_shades(a->desc, TSU_MODEL_SURFACE);
    uint32_t location = 0;
    for (size_t i = 0; i < sizeof fixed / sizeof *fixed; i++)
        if ((fiber && fixed[i].fiber) || (surface && fixed[i].surface))
            put_varying(a, &location, "vec3", fixed[i].name);
    put_varying(a, &location, "int", "material");
    for (uint32_t i = 0; i < a->desc->model_count; i++)
        for (uint32_t k = 0; k < a->desc->models[i]->info.input_count; k++) {
            const tsu_input_info *input = a->desc->models[i]->inputs + k;
            if (input->flags & TSU_INPUT_EXTRA && takes(a->desc, a->desc->models[i], k) &&
                !extra_before(a->desc, i, input->name))
                put_varying(a, &location, input->type, input->name);
        }
    put(a, "layout(location = 0) out vec4 o;\n");
}

static void put_main(const struct assembler *a)
{
    put(a, "void main()\n{\n    vec3 sum = vec3(0.0);\n");
    for (uint32_t i = 0; i < a->desc->model_count; i++) {
        const struct tsu_model *model = a->desc->models[i];
        if (listed_before(a->desc, i))
            continue;
        put(a, "    sum += tsu_");
        put(a, model->info.name);
        put(a, "_sum(tsu_");
        put(a, model->info.name);
        const tsu_variant_info *variant = variant_of(a->desc, model);
        if (variant) {
            put(a, "_");
            put(a, variant->name);
        }
        put(a, "_eval(");
        for (uint32_t k = 0; k < model->info.input_count; k++) {
            if (!takes(a->desc, model, k))
                continue;
            put(a, k ? ", " : "");
            put(a, model->inputs[k].name);
        }
        put(a, "));\n");
    }
    put(a, "    o = vec4(sum, 1.0);\n}\n");
}

tsu_status tsu_i_assemble(const tsu_context *context, const tsu_shader_desc *desc,
                          struct tsu_i_assembly *out)
{
    const struct assembler a = {context, desc, tsu_i_dialect_find(desc->target), out};
    const int harness = (desc->flags & TSU_SHADER_HARNESS) != 0;
    out->text.context = context;
    out->sources[0] = "tsuya";
    out->source_count = 1;
    if (harness)
        put(&a, a.dialect->version);
    put(&a, "// tsuya, MIT licence: functions, one sampler and one block that begin with tsu_.\n");
    put(&a, a.dialect->preamble);
    put_resources(&a);
    if (harness)
        put_varyings(&a);
    tsu_status status = TSU_OK;
    if (any_material(desc))
        status = put_file(&a, "prelude/records.glsl");
    static const char *const lights[] = {"light/fiber.glsl", "light/light.glsl",
                                         "light/environment.glsl"};
    for (size_t i = 0; i < sizeof lights / sizeof *lights && status == TSU_OK; i++)
        if (desc->flags & TSU_SHADER_LIGHTS)
            status = put_file(&a, lights[i]);
    if (desc->flags & TSU_SHADER_BLUR && status == TSU_OK)
        status = put_file(&a, "light/blur.glsl");
    if (desc->flags & TSU_SHADER_FADE && status == TSU_OK)
        status = put_file(&a, "prelude/fade.glsl");
    for (uint32_t i = 0; i < desc->model_count && status == TSU_OK; i++)
        for (const char *const *file = desc->models[i]->snippets;
             *file && status == TSU_OK && !listed_before(desc, i); file++)
            if (!file_before(desc, i, file))
                status = put_file(&a, *file);
    if (status == TSU_OK && desc->flags & TSU_SHADER_PROBE)
        status = put_file(&a, desc->models[0]->functions[desc->function].probe);
    if (harness && status == TSU_OK) {
        put_line(&a, 0);
        put_main(&a);
    }
    if (out->text.failed && status == TSU_OK)
        status = TSU_E_MEMORY;
    if (status != TSU_OK)
        return status;
    tsu_i_strip(&out->text, desc->flags);
    return desc->only && desc->only[0] ? tsu_i_reach(context, desc, out) : TSU_OK;
}
