// A set of materials: any number of materials of any models that share one texture and one block.
//
//   texture  one RGBA16F image (an atlas of 128 x 128 cells) with every table of every material;
//            equal tables are stored once
//   block    pages of 1024 vec4 (16 KiB, the least that GL promises): 8 vec4 of page header, then
//            one record of 8 vec4 for each of TSU_PAGE_MATERIALS materials
//
// The host adds materials, bakes, and hands texture and pages to the GPU, by itself or with gl.h.
// A change of parameters that touch no table (colour, shift, longitudinal roughness) rewrites one
// record and bakes nothing.
#ifndef TSUYA_SET_H
#define TSUYA_SET_H

#include <tsuya/model.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    TSU_PAGE_MATERIALS = 127,   // materials in a page
    TSU_RECORD_VEC4 = 8,        // vec4s in a record
    TSU_PAGE_VEC4 = 1024,       // vec4s in a page, header included
    TSU_PAGE_BYTES = 1024 * 16, // bytes in a page
    TSU_CELL = 128              // texels along a cell of the atlas
};

typedef struct tsu_set tsu_set;

typedef struct tsu_set_desc {
    uint32_t struct_size;      // set by tsu_set_desc_init()
    uint32_t flags;            // 0
    uint32_t max_texture_size; // texels, [128, 65536], default 2048 (GL ES 3's least maximum)
    uint32_t max_materials;    // [1, 1048576], default 1048576
} tsu_set_desc;

// Errors: TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_set_desc_init_sized(tsu_set_desc *desc, size_t size);
#define tsu_set_desc_init(desc) tsu_set_desc_init_sized((desc), sizeof *(desc))

// Make an empty set. Errors: TSU_E_STRUCT, TSU_E_PARAMETER, TSU_E_MEMORY.
// Threads: object, the context.
TSU_API tsu_status tsu_set_create(tsu_context *context, const tsu_set_desc *desc, tsu_set **out);
// Free a set; NULL is fine. GPU copies are the GL tier's. Threads: object.
TSU_API void tsu_set_destroy(tsu_set *set);

// Add a material; *material is its index in the set, which stays until it is removed. Its page is
// index / TSU_PAGE_MATERIALS, its index in the shader index % TSU_PAGE_MATERIALS. `params` is the
// model's typed struct and is copied.
// Errors: TSU_E_PARAMETER (a model of self-shadow, too), TSU_E_STRUCT, TSU_E_MEMORY, TSU_E_LIMIT
// (the texture cannot grow past max_texture_size, or max_materials is reached). The set is unchanged on failure.
// Threads: object.
TSU_API tsu_status tsu_set_add(tsu_set *set, const tsu_model *model, const void *params,
                               uint32_t *material);
// Change a material's parameters. *baked_again (may be NULL) is 1 when its tables wait for a bake.
// Equal parameters change nothing. The old tables are given back after the new ones are placed: a
// texture at its limit needs room for both. Errors and threads as tsu_set_add().
TSU_API tsu_status tsu_set_update(tsu_set *set, uint32_t material, const void *params,
                                  int32_t *baked_again);
// Remove a material; its index may be given out again. Errors: TSU_E_PARAMETER. Threads: object.
TSU_API tsu_status tsu_set_remove(tsu_set *set, uint32_t material);

// Bake every stale table, in rows over the host's jobs. Cheap when nothing is stale. Until then
// the texels of stale tables are zero. Errors: TSU_E_MEMORY. Threads: object.
TSU_API tsu_status tsu_set_bake(tsu_set *set);

// Baked tables as bytes for a file of the host's: of tables that take long, only the first run of a
// program pays. Add the materials, read, and bake what is still stale:
//
//   tsu_set_cache_read(set, bytes, size, NULL);   // a block that does not fit is no loss
//   tsu_set_bake(set);
//
// A table is taken when the block has one of the same model, table, description and key (the
// parameters that shape it); what else is in the block is left alone. Blocks belong to one version
// of the library.
//
// Bytes of a block with the set's baked tables; 0 for NULL. Threads: object.
TSU_API size_t tsu_set_cache_size(const tsu_set *set);
// Write the block. `size`: bytes of `buffer`, at least tsu_set_cache_size().
// Errors: TSU_E_PARAMETER. Threads: object.
TSU_API tsu_status tsu_set_cache_write(const tsu_set *set, void *buffer, size_t size);
// Fill stale tables from a block of exactly `size` bytes; *taken (may be NULL) counts them. The
// whole block is checked before anything is taken: length, structure, and a hash that any changed
// byte breaks. The hash guards against accidents, not against a forger.
// Errors: TSU_E_PARAMETER (not a whole block), TSU_E_VERSION (of another library), both logged; the
// set is unchanged then. Threads: object.
TSU_API tsu_status tsu_set_cache_read(tsu_set *set, const void *buffer, size_t size,
                                      uint32_t *taken);

typedef struct tsu_set_info {
    uint32_t struct_size;        // set by tsu_set_info_init()
    uint32_t flags;              // 0
    uint32_t material_count;     // live materials
    uint32_t page_count;         // pages that hold or held one
    uint32_t table_count;        // distinct tables
    uint32_t stale_count;        // tables that tsu_set_bake() would bake
    uint32_t width, height;      // of the texture, texels; 0 before the first table
    uint64_t generation;         // grows with every change; one counter for all that changes
    uint64_t texture_generation; // when the texture last changed, size or texels
    uint64_t id;                 // of the set: no other set of this context has or had it
} tsu_set_info;
#define tsu_set_info_init(info) tsu_info_init_sized((info), sizeof *(info))
// Errors: TSU_E_PARAMETER, TSU_E_STRUCT. Threads: object.
TSU_API tsu_status tsu_set_describe(const tsu_set *set, tsu_set_info *out);

// Texels of the whole texture: `width * height` RGBA16F, rows bottom-up or top-down as you like
// (row 0 is v = 0), no padding. Valid until the next call that changes the set. NULL when empty.
// Threads: object.
TSU_API const uint16_t *tsu_set_texels(const tsu_set *set);

// A rectangle of the texture that changed after `generation`.
typedef struct tsu_region {
    uint32_t x, y, width, height;
    uint64_t generation; // when it last changed
} tsu_region;
// Region `index` of the texture, one a table, in no special order; 0 past the last. A table that is
// no longer used leaves a region of no width.
// Threads: object.
TSU_API int32_t tsu_set_region(const tsu_set *set, uint32_t index, tsu_region *out);

// A page's TSU_PAGE_BYTES bytes (std140: vec4[1024]) and, when not NULL, the generation in which
// it last changed. NULL past the last page. Valid as tsu_set_texels().
// Threads: object.
TSU_API const float *tsu_set_page(const tsu_set *set, uint32_t page, uint64_t *generation);

// A material's record: TSU_RECORD_VEC4 vec4s inside its page; NULL for a dead index.
// Threads: object.
TSU_API const float *tsu_set_record(const tsu_set *set, uint32_t material);

// Typed parameters of a material as the set holds them, and its model. NULL for a dead index.
// Threads: object.
TSU_API const void *tsu_set_params(const tsu_set *set, uint32_t material, const tsu_model **model);

// Answer a function of the material's model from the baked tables, in C, as the shader does:
// same formulas, same texels, bilinear as GL filters. `in` and `out` as tsu_function_reference();
// inputs marked TSU_VALUE_MATERIAL are read from the material, not from `in`.
// Errors: TSU_E_PARAMETER, TSU_E_STATE (stale tables), TSU_E_UNSUPPORTED (the function has a
// reference only). Threads: object.
TSU_API tsu_status tsu_set_evaluate(tsu_set *set, uint32_t material, uint32_t function,
                                    const double *in, double *out);

// Measure table errors of a material again: the shader's formula on the baked texels against the
// reference, between the texels. `index` counts the model's errors that have a table behind them;
// *name and *value get its name and the worst value found. Takes seconds.
// Errors: TSU_E_PARAMETER past the last, TSU_E_STATE (stale tables). Threads: object.
TSU_API tsu_status tsu_set_measure(tsu_set *set, uint32_t material, uint32_t index,
                                   const char **name, double *value);

#ifdef __cplusplus
}
#endif
#endif
