// What a SPIR-V fragment shader expects around it, and a vertex shader that feeds it.
//
// Private to shader_cost.c; a header with its functions, so that one compiler call builds the tool.
#ifndef TSUYA_TESTS_BENCH_SPIRV_INTERFACE_H
#define TSUYA_TESTS_BENCH_SPIRV_INTERFACE_H

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <vulkan/vulkan.h>

enum { MAX_SLOTS = 32, MAX_BINDINGS = 64, MAX_VERTEX_WORDS = 8192 };
enum slot_kind { SLOT_FLOAT, SLOT_INT, SLOT_UINT };

// One location of an input or output: a scalar or a vector of 32-bit components.
struct slot {
    uint32_t location, components;
    enum slot_kind kind;
    int flat;
};

struct fragment_interface {
    char entry[128];
    struct slot inputs[MAX_SLOTS], outputs[MAX_SLOTS];
    int input_count, output_count;
    struct { uint32_t set; VkDescriptorSetLayoutBinding layout; } bindings[MAX_BINDINGS];
    int binding_count;
    int has_push_constants;
};

// The opcodes and enumerants used here, under the names of the SPIR-V specification.
enum {
    OpMemoryModel = 14, OpEntryPoint = 15, OpCapability = 17, OpTypeVoid = 19, OpTypeInt = 21,
    OpTypeFloat = 22, OpTypeVector = 23, OpTypeMatrix = 24, OpTypeImage = 25, OpTypeSampler = 26,
    OpTypeSampledImage = 27, OpTypeArray = 28, OpTypeStruct = 30, OpTypePointer = 32,
    OpTypeFunction = 33, OpConstant = 43, OpFunction = 54, OpFunctionEnd = 56, OpVariable = 59,
    OpLoad = 61, OpStore = 62, OpDecorate = 71, OpCompositeConstruct = 80, OpConvertSToF = 111,
    OpBitcast = 124, OpIMul = 132, OpFMul = 133, OpLabel = 248, OpReturn = 253,
    DecorationBufferBlock = 3, DecorationBuiltIn = 11, DecorationFlat = 14,
    DecorationLocation = 30, DecorationComponent = 31, DecorationBinding = 33,
    DecorationDescriptorSet = 34, ClassInput = 1, ClassOutput = 3, ClassPushConstant = 9,
    ClassStorageBuffer = 12, BuiltInPosition = 0, BuiltInVertexIndex = 42, ModelFragment = 4,
    DimBuffer = 5, SpirvMagic = 0x07230203
};

// Per result id of a module: its definition and the decorations that matter here, plus one so that
// zero means "none".
struct spirv_id {
    const uint32_t *def;
    uint32_t location, binding, set, flat, built_in, buffer_block, component;
};

static inline uint32_t spirv_op(const uint32_t *def)
{
    return def ? def[0] & 0xFFFF : 0;
}

// Strips array levels off `type` and multiplies `*count` by their lengths.
static inline uint32_t spirv_element(const struct spirv_id *ids, uint32_t type, uint32_t *count)
{
    while (spirv_op(ids[type].def) == OpTypeArray) {
        const uint32_t *length = ids[ids[type].def[3]].def;
        *count *= spirv_op(length) == OpConstant ? length[3] : 1;
        type = ids[type].def[2];
    }
    return type;
}

static inline VkDescriptorType spirv_descriptor(const struct spirv_id *ids, uint32_t type,
                                                uint32_t storage_class)
{
    const uint32_t *def = ids[type].def;
    switch (spirv_op(def)) {
    case OpTypeSampledImage:
        return ids[def[2]].def[3] == DimBuffer ? VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER
                                               : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    case OpTypeSampler:
        return VK_DESCRIPTOR_TYPE_SAMPLER;
    case OpTypeImage:
        if (def[3] == DimBuffer) {
            return def[7] == 2 ? VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER
                               : VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
        }
        return def[7] == 2 ? VK_DESCRIPTOR_TYPE_STORAGE_IMAGE : VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
    default:
        return storage_class == ClassStorageBuffer || ids[type].buffer_block
                   ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
                   : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    }
}

// Adds an input or output variable, one slot per location. Returns NULL or what is wrong.
static inline const char *spirv_add_slots(const struct spirv_id *ids, const struct spirv_id *var,
                                          uint32_t type, struct slot *slots, int *slot_count)
{
    uint32_t count = 1;
    struct slot slot = {var->location - 1, 1, SLOT_FLOAT, var->flat != 0};
    type = spirv_element(ids, type, &count);
    if (spirv_op(ids[type].def) == OpTypeMatrix) {
        count *= ids[type].def[3];
        type = ids[type].def[2];
    }
    if (spirv_op(ids[type].def) == OpTypeVector) {
        slot.components = ids[type].def[3];
        type = ids[type].def[2];
    }
    const uint32_t op = spirv_op(ids[type].def);
    if ((op != OpTypeFloat && op != OpTypeInt) || ids[type].def[2] != 32 || var->component) {
        return "an input or output is a block, not 32 bits wide or has a component qualifier";
    }
    if (op == OpTypeInt) {
        slot.kind = ids[type].def[3] ? SLOT_INT : SLOT_UINT;
    }
    for (; count > 0; count--, slot.location++) {
        if (*slot_count == MAX_SLOTS) {
            return "it has too many inputs or outputs";
        }
        slots[(*slot_count)++] = slot;
    }
    return NULL;
}

static inline const char *spirv_add_variable(const struct spirv_id *ids, uint32_t id,
                                             struct fragment_interface *out)
{
    const struct spirv_id *var = &ids[id];
    const uint32_t storage = var->def[3];
    uint32_t type = ids[var->def[1]].def[3];
    if (storage == ClassPushConstant) {
        out->has_push_constants = 1;
    } else if (var->binding) {
        uint32_t count = 1;
        type = spirv_element(ids, type, &count);
        if (out->binding_count == MAX_BINDINGS || var->set > 4) {
            return "it has too many bindings or sets";
        }
        out->bindings[out->binding_count].set = var->set ? var->set - 1 : 0;
        out->bindings[out->binding_count++].layout = (VkDescriptorSetLayoutBinding){
            var->binding - 1, spirv_descriptor(ids, type, storage), count,
            VK_SHADER_STAGE_FRAGMENT_BIT, NULL};
    } else if (storage == ClassInput && !var->built_in) {
        return var->location ? spirv_add_slots(ids, var, type, out->inputs, &out->input_count)
                             : "an input has no location";
    } else if (storage == ClassOutput && !var->built_in) {
        return var->location ? spirv_add_slots(ids, var, type, out->outputs, &out->output_count)
                             : "an output has no location";
    }
    return NULL;
}

// Reads the interface of a module that a compiler wrote. Returns NULL or what is wrong with it.
static inline const char *spirv_reflect(const uint32_t *words, size_t word_count,
                                        struct fragment_interface *out)
{
    memset(out, 0, sizeof *out);
    if (word_count < 5 || words[0] != SpirvMagic || words[3] > word_count) {
        return "it is not a whole SPIR-V module in this machine's byte order";
    }
    const uint32_t bound = words[3];
    struct spirv_id *ids = calloc(bound, sizeof *ids);
    const char *wrong = ids ? NULL : "out of memory";
    for (size_t i = 5; !wrong && i < word_count; i += words[i] >> 16) {
        const uint32_t *w = words + i;
        const uint32_t op = w[0] & 0xFFFF, length = w[0] >> 16;
        const uint32_t id = op == OpConstant || op == OpVariable ? 2 : 1;
        if (length == 0 || i + length > word_count) {
            wrong = "it is damaged";
        } else if (op == OpEntryPoint && !out->entry[0]) {
            if (w[1] != ModelFragment) {
                wrong = "it is not a fragment shader";
            }
            strncpy(out->entry, (const char *)(w + 3), sizeof out->entry - 1);
        } else if (op == OpDecorate && length > 2 && w[1] < bound) {
            struct spirv_id *d = &ids[w[1]];
            uint32_t *const field = w[2] == DecorationLocation        ? &d->location
                                    : w[2] == DecorationBinding       ? &d->binding
                                    : w[2] == DecorationDescriptorSet ? &d->set
                                    : w[2] == DecorationFlat          ? &d->flat
                                    : w[2] == DecorationBuiltIn       ? &d->built_in
                                    : w[2] == DecorationBufferBlock   ? &d->buffer_block
                                    : w[2] == DecorationComponent     ? &d->component
                                                                      : NULL;
            if (field) {
                *field = length > 3 ? w[3] + 1 : 1;
            }
        } else if (((op >= OpTypeVoid && op <= OpTypePointer) || id == 2) && length > id &&
                   w[id] < bound) {
            ids[w[id]].def = w;
        }
    }
    for (uint32_t id = 0; !wrong && id < bound; id++) {
        if (spirv_op(ids[id].def) == OpVariable) {
            wrong = spirv_add_variable(ids, id, out);
        }
    }
    free(ids);
    return wrong || out->entry[0] ? wrong : "it has no entry point";
}

struct vertex_stage {
    uint32_t words[MAX_VERTEX_WORDS];
    uint32_t count;
};

static inline void emit(struct vertex_stage *v, uint32_t op, uint32_t count, const uint32_t *words)
{
    v->words[v->count++] = (count + 1) << 16 | op;
    memcpy(v->words + v->count, words, count * sizeof *words);
    v->count += count;
}

#define EMIT(op, ...)                                                                              \
    emit(v, op, sizeof((uint32_t[]){__VA_ARGS__}) / 4, (const uint32_t[]){__VA_ARGS__})

// Builds the vertex stage. Each component of each input is another power of the vertex index: with
// equal or constant values a driver merges or folds inputs and the fragment shader reads too cheap.
static inline void vertex_stage_build(struct vertex_stage *v, const struct fragment_interface *f)
{
    enum { VOID = 1, FUNCTION, MAIN, LABEL, INDEX, POSITION, INDEX_POINTER, INDEX_VALUE,
           FLOAT_INDEX, UINT_INDEX, POSITION_VALUE, TYPES };
    enum { POINTERS = TYPES + 12, OUTPUTS = POINTERS + 12 };
    // Types and output pointers by kind and number of components.
#define TYPE(kind, components) ((uint32_t)TYPES + (uint32_t)(kind)*4 + (components)-1)
    const uint32_t n = (uint32_t)f->input_count;
    uint32_t id = OUTPUTS + n;
    uint32_t interface[6 + MAX_SLOTS] = {0, MAIN, 0x6E69616D, 0, INDEX, POSITION}; // "main"
    v->count = 5;
    EMIT(OpCapability, 1);
    EMIT(OpMemoryModel, 0, 1);
    for (uint32_t i = 0; i < n; i++) {
        interface[6 + i] = OUTPUTS + i;
    }
    emit(v, OpEntryPoint, 6 + n, interface);
    EMIT(OpDecorate, INDEX, DecorationBuiltIn, BuiltInVertexIndex);
    EMIT(OpDecorate, POSITION, DecorationBuiltIn, BuiltInPosition);
    for (uint32_t i = 0; i < n; i++) {
        EMIT(OpDecorate, OUTPUTS + i, DecorationLocation, f->inputs[i].location);
        if (f->inputs[i].flat) {
            EMIT(OpDecorate, OUTPUTS + i, DecorationFlat);
        }
    }
    EMIT(OpTypeVoid, VOID);
    EMIT(OpTypeFunction, FUNCTION, VOID);
    EMIT(OpTypeFloat, TYPE(SLOT_FLOAT, 1), 32);
    EMIT(OpTypeInt, TYPE(SLOT_INT, 1), 32, 1);
    EMIT(OpTypeInt, TYPE(SLOT_UINT, 1), 32, 0);
    for (uint32_t kind = SLOT_FLOAT; kind <= SLOT_UINT; kind++) {
        for (uint32_t c = 1; c <= 4; c++) {
            if (c > 1) {
                EMIT(OpTypeVector, TYPE(kind, c), TYPE(kind, 1), c);
            }
            EMIT(OpTypePointer, TYPE(kind, c) + 12, ClassOutput, TYPE(kind, c));
        }
    }
    EMIT(OpTypePointer, INDEX_POINTER, ClassInput, TYPE(SLOT_INT, 1));
    EMIT(OpVariable, INDEX_POINTER, INDEX, ClassInput);
    EMIT(OpVariable, TYPE(SLOT_FLOAT, 4) + 12, POSITION, ClassOutput);
    for (uint32_t i = 0; i < n; i++) {
        EMIT(OpVariable, TYPE(f->inputs[i].kind, f->inputs[i].components) + 12, OUTPUTS + i,
             ClassOutput);
    }
    EMIT(OpFunction, VOID, MAIN, 0, FUNCTION);
    EMIT(OpLabel, LABEL);
    EMIT(OpLoad, TYPE(SLOT_INT, 1), INDEX_VALUE, INDEX);
    EMIT(OpConvertSToF, TYPE(SLOT_FLOAT, 1), FLOAT_INDEX, INDEX_VALUE);
    EMIT(OpBitcast, TYPE(SLOT_UINT, 1), UINT_INDEX, INDEX_VALUE);
    EMIT(OpCompositeConstruct, TYPE(SLOT_FLOAT, 4), POSITION_VALUE, FLOAT_INDEX, FLOAT_INDEX,
         FLOAT_INDEX, FLOAT_INDEX);
    EMIT(OpStore, POSITION, POSITION_VALUE);
    const uint32_t base[3] = {FLOAT_INDEX, INDEX_VALUE, UINT_INDEX};
    uint32_t power[3] = {FLOAT_INDEX, INDEX_VALUE, UINT_INDEX};
    for (uint32_t i = 0; i < n; i++) {
        const struct slot *s = &f->inputs[i];
        uint32_t vector[6] = {TYPE(s->kind, s->components)};
        for (uint32_t c = 0; c < s->components; c++) {
            EMIT(s->kind == SLOT_FLOAT ? OpFMul : OpIMul, TYPE(s->kind, 1), id, power[s->kind],
                 base[s->kind]);
            vector[2 + c] = power[s->kind] = id++;
        }
        uint32_t value = power[s->kind];
        if (s->components > 1) {
            vector[1] = value = id++;
            emit(v, OpCompositeConstruct, 2 + s->components, vector);
        }
        EMIT(OpStore, OUTPUTS + i, value);
    }
    emit(v, OpReturn, 0, base);
    emit(v, OpFunctionEnd, 0, base);
    const uint32_t header[5] = {SpirvMagic, 0x00010000, 0, id, 0};
    memcpy(v->words, header, sizeof header);
#undef TYPE
}

#undef EMIT

#endif
