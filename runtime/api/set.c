#include "api/params.h"
#include "api/set.h"
#include "bake/pool.h"
#include "base/desc.h"

#include <tsuya/set.h>

#include <string.h>

// In place of a table that the parameters' flags do not ask for.
#define NO_TABLE UINT32_MAX

struct material {
    const struct tsu_model *model; // NULL: the index is free
    unsigned char params[TSU_I_PARAMS_BYTES];
    unsigned char state[TSU_I_STATE_BYTES];
    uint32_t tables[TSU_I_MODEL_TABLES];
};

struct page {
    float *values; // TSU_PAGE_VEC4 * 4
    uint64_t generation;
};

struct tsu_set {
    tsu_context *context;
    tsu_set_desc desc;
    struct tsu_i_pool pool;
    struct material *materials;
    uint32_t material_count, material_capacity, live;
    struct page *pages;
    uint32_t page_count, page_capacity;
    uint64_t generation, id;
    uint32_t scaled_width, scaled_height; // texture size that the records are written for
};

tsu_status tsu_set_desc_init_sized(tsu_set_desc *desc, size_t size)
{
    const tsu_set_desc defaults = {
        .struct_size = sizeof defaults, .max_texture_size = 2048, .max_materials = 1048576};
    return tsu_i_desc_init(desc, size, &defaults, sizeof defaults, sizeof defaults);
}

static tsu_status bad_range(const tsu_context *context, const char *field, uint32_t value,
                            uint32_t low, uint32_t high)
{
    tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_PARAMETER, "tsu_set_desc.%s = %u, expected [%u, %u]",
              field, value, low, high);
    return TSU_E_PARAMETER;
}

tsu_status tsu_set_create(tsu_context *context, const tsu_set_desc *desc, tsu_set **out)
{
    if (!out)
        return TSU_E_PARAMETER;
    *out = NULL;
    if (!context)
        return TSU_E_PARAMETER;
    tsu_set_desc own;
    const tsu_status status =
        tsu_i_desc_read(context, "tsu_set_desc", desc, &own, sizeof own, sizeof own);
    if (status != TSU_OK)
        return status;
    if (own.flags) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_FLAGS, "tsu_set_desc.flags = %u, expected 0",
                  own.flags);
        return TSU_E_PARAMETER;
    }
    if (own.max_texture_size < TSU_CELL || own.max_texture_size > 65536)
        return bad_range(context, "max_texture_size", own.max_texture_size, TSU_CELL, 65536);
    if (own.max_materials < 1 || own.max_materials > 1048576)
        return bad_range(context, "max_materials", own.max_materials, 1, 1048576);
    tsu_set *set = tsu_i_alloc(context, 1, sizeof *set);
    if (!set)
        return TSU_E_MEMORY;
    set->context = context;
    set->id = ++context->sets;
    set->desc = own;
    set->pool.context = context;
    set->pool.atlas.context = context;
    set->pool.atlas.max_size = own.max_texture_size;
    set->pool.generation = &set->generation;
    *out = set;
    return TSU_OK;
}

void tsu_set_destroy(tsu_set *set)
{
    if (!set)
        return;
    const tsu_context *context = set->context;
    for (uint32_t i = 0; i < set->page_count; i++)
        tsu_i_free(context, set->pages[i].values, TSU_PAGE_BYTES, 1);
    tsu_i_free(context, set->pages, set->page_capacity, sizeof *set->pages);
    tsu_i_free(context, set->materials, set->material_capacity, sizeof *set->materials);
    tsu_i_pool_free(&set->pool);
    tsu_i_free(context, set, 1, sizeof *set);
}

struct tsu_i_pool *tsu_i_set_pool(tsu_set *set)
{
    return &set->pool;
}

static struct material *find(const tsu_set *set, uint32_t material)
{
    if (!set || material >= set->material_count || !set->materials[material].model) {
        if (set)
            tsu_i_log(set->context, TSU_LOG_ERROR, TSU_LOG_INDEX, "material %u is not in the set",
                      material);
        return NULL;
    }
    return set->materials + material;
}

static float *record_of(const tsu_set *set, uint32_t material)
{
    return set->pages[material / TSU_PAGE_MATERIALS].values +
           (material % TSU_PAGE_MATERIALS + 1) * TSU_RECORD_VEC4 * 4;
}

static void write_record(tsu_set *set, uint32_t material)
{
    const struct material *m = set->materials + material;
    float record[TSU_RECORD_VEC4 * 4] = {0};
    struct tsu_i_place places[TSU_I_MODEL_TABLES] = {{0, 0, 0, 0}};
    for (uint32_t i = 0; i < m->model->info.table_count; i++) {
        if (m->tables[i] == NO_TABLE)
            continue;
        const struct tsu_i_pool_table *t = set->pool.tables + m->tables[i];
        places[i] = (struct tsu_i_place){t->x, t->y, set->pool.width, set->pool.height};
    }
    m->model->record(m->state, places, record);
    float *at = record_of(set, material);
    if (memcmp(at, record, sizeof record) != 0) {
        memcpy(at, record, sizeof record);
        set->pages[material / TSU_PAGE_MATERIALS].generation = ++set->generation;
    }
}

static void write_header(tsu_set *set, struct page *page)
{
    const float w = (float)set->pool.width, h = (float)set->pool.height;
    if (w == 0.0f || h == 0.0f)
        return;
    const float header[4] = {1.0f / w, 1.0f / h, w, h};
    memcpy(page->values, header, sizeof header);
    page->generation = ++set->generation;
}

// Records hold texture coordinates: a texture that grew moves them all.
static void rescale(tsu_set *set)
{
    if (set->pool.width == set->scaled_width && set->pool.height == set->scaled_height)
        return;
    set->scaled_width = set->pool.width;
    set->scaled_height = set->pool.height;
    for (uint32_t i = 0; i < set->page_count; i++)
        write_header(set, set->pages + i);
    for (uint32_t i = 0; i < set->material_count; i++)
        if (set->materials[i].model)
            write_record(set, i);
}

static tsu_status add_page(tsu_set *set, uint32_t page)
{
    if (page < set->page_count)
        return TSU_OK;
    if (page == set->page_capacity) {
        const uint32_t capacity = set->page_capacity ? 2 * set->page_capacity : 4;
        struct page *pages =
            tsu_i_realloc(set->context, set->pages, set->page_capacity, capacity, sizeof *pages);
        if (!pages)
            return TSU_E_MEMORY;
        set->pages = pages;
        set->page_capacity = capacity;
    }
    set->pages[page].values = tsu_i_alloc(set->context, TSU_PAGE_BYTES, 1);
    if (!set->pages[page].values)
        return TSU_E_MEMORY;
    set->page_count++;
    write_header(set, set->pages + page);
    set->pages[page].generation = ++set->generation;
    return TSU_OK;
}

static tsu_status free_index(tsu_set *set, uint32_t *material)
{
    *material = set->material_count;
    if (set->live < set->material_count)
        for (*material = 0; set->materials[*material].model; ++*material)
            ;
    if (*material >= set->desc.max_materials) {
        tsu_i_log(set->context, TSU_LOG_ERROR, TSU_LOG_MATERIAL_LIMIT,
                  "tsu_set_desc.max_materials = %u is reached", set->desc.max_materials);
        return TSU_E_LIMIT;
    }
    if (*material == set->material_capacity) {
        const uint32_t capacity = set->material_capacity ? 2 * set->material_capacity : 16;
        struct material *materials = tsu_i_realloc(
            set->context, set->materials, set->material_capacity, capacity, sizeof *materials);
        if (!materials)
            return TSU_E_MEMORY;
        set->materials = materials;
        set->material_capacity = capacity;
    }
    return add_page(set, *material / TSU_PAGE_MATERIALS);
}

static void give_tables(tsu_set *set, const struct material *m, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++)
        if (m->tables[i] != NO_TABLE)
            tsu_i_pool_give(&set->pool, m->tables[i]);
}

// Parameters begin with struct_size and flags.
static uint32_t flags_of(const struct material *m)
{
    uint32_t head[2];
    memcpy(head, m->params, sizeof head);
    return head[1];
}

// Checked parameters, state and tables of a material to be; nothing in the set refers to it yet.
static tsu_status prepare(tsu_set *set, const struct tsu_model *model, const void *params,
                          struct material *m)
{
    memset(m, 0, sizeof *m);
    tsu_status status = tsu_i_params_read(set->context, model, params, m->params);
    if (status != TSU_OK)
        return status;
    m->model = model;
    model->prepare(m->params, m->state);
    const uint32_t flags = flags_of(m);
    for (uint32_t i = 0; i < model->info.table_count; i++) {
        if (model->tables[i].info.params_flags & ~flags) {
            m->tables[i] = NO_TABLE;
            continue;
        }
        status = tsu_i_pool_take(&set->pool, model->tables + i, m->state, m->tables + i);
        if (status != TSU_OK) {
            give_tables(set, m, i);
            return status;
        }
    }
    return TSU_OK;
}

static int stale(const tsu_set *set, const struct material *m)
{
    for (uint32_t i = 0; i < m->model->info.table_count; i++)
        if (m->tables[i] != NO_TABLE && !set->pool.tables[m->tables[i]].baked)
            return 1;
    return 0;
}

tsu_status tsu_set_add(tsu_set *set, const tsu_model *model, const void *params, uint32_t *material)
{
    if (material)
        *material = 0;
    if (!set || !model || !material)
        return TSU_E_PARAMETER;
    if (model->info.flags & TSU_MODEL_SHADOW) {
        tsu_i_log(set->context, TSU_LOG_ERROR, TSU_LOG_PARAMETER,
                  "%s shades no fibre: it cannot be a material, see tsuya/hair_shadow.h",
                  model->info.name);
        return TSU_E_PARAMETER;
    }
    uint32_t index;
    struct material m;
    const uint32_t pages = set->page_count;
    const uint64_t generation = set->generation;
    tsu_status status = free_index(set, &index);
    if (status == TSU_OK)
        status = prepare(set, model, params, &m);
    if (status != TSU_OK) {
        // A page that was made for this material alone goes again.
        if (set->page_count > pages) {
            tsu_i_free(set->context, set->pages[--set->page_count].values, TSU_PAGE_BYTES, 1);
            if (set->pool.texture_generation <= generation)
                set->generation = generation;
        }
        rescale(set);
        return status;
    }
    rescale(set);
    set->materials[index] = m;
    if (index == set->material_count)
        set->material_count++;
    set->live++;
    write_record(set, index);
    *material = index;
    return TSU_OK;
}

tsu_status tsu_set_update(tsu_set *set, uint32_t material, const void *params, int32_t *baked_again)
{
    if (baked_again)
        *baked_again = 0;
    struct material *m = find(set, material), next;
    if (!m)
        return TSU_E_PARAMETER;
    const tsu_status status = prepare(set, m->model, params, &next);
    rescale(set);
    if (status != TSU_OK)
        return status;
    const struct material old = *m;
    *m = next;
    give_tables(set, &old, old.model->info.table_count);
    write_record(set, material);
    if (baked_again)
        *baked_again = stale(set, m);
    return TSU_OK;
}

tsu_status tsu_set_remove(tsu_set *set, uint32_t material)
{
    struct material *m = find(set, material);
    if (!m)
        return TSU_E_PARAMETER;
    give_tables(set, m, m->model->info.table_count);
    m->model = NULL;
    set->live--;
    set->generation++;
    return TSU_OK;
}

tsu_status tsu_set_bake(tsu_set *set)
{
    return set ? tsu_i_pool_bake(&set->pool) : TSU_E_PARAMETER;
}

tsu_status tsu_set_describe(const tsu_set *set, tsu_set_info *out)
{
    if (!set)
        return TSU_E_PARAMETER;
    tsu_set_info info = {.struct_size = sizeof info,
                         .material_count = set->live,
                         .page_count = set->page_count,
                         .table_count = set->pool.live,
                         .stale_count = set->pool.stale,
                         .width = set->pool.width,
                         .height = set->pool.height,
                         .generation = set->generation,
                         .id = set->id,
                         .texture_generation = set->pool.texture_generation};
    return tsu_i_desc_write(out, &info, sizeof info);
}

const uint16_t *tsu_set_texels(const tsu_set *set)
{
    return set ? set->pool.texels : NULL;
}

int32_t tsu_set_region(const tsu_set *set, uint32_t index, tsu_region *out)
{
    if (!set || !out)
        return 0;
    if (index >= set->pool.count)
        return 0;
    const struct tsu_i_pool_table *t = set->pool.tables + index;
    *out = (tsu_region){t->x, t->y, 0, 0, t->generation};
    if (t->users) {
        out->width = t->definition->info.width;
        out->height = t->definition->info.height;
    }
    return 1;
}

const float *tsu_set_page(const tsu_set *set, uint32_t page, uint64_t *generation)
{
    if (!set || page >= set->page_count)
        return NULL;
    if (generation)
        *generation = set->pages[page].generation;
    return set->pages[page].values;
}

const float *tsu_set_record(const tsu_set *set, uint32_t material)
{
    return find(set, material) ? record_of(set, material) : NULL;
}

const void *tsu_set_params(const tsu_set *set, uint32_t material, const tsu_model **model)
{
    const struct material *m = find(set, material);
    if (model)
        *model = m ? m->model : NULL;
    return m ? m->params : NULL;
}

static tsu_status baked_tables(const tsu_set *set, uint32_t material, struct tsu_i_texels *tables)
{
    const struct material *m = find(set, material);
    if (!m)
        return TSU_E_PARAMETER;
    if (stale(set, m)) {
        tsu_i_log(set->context, TSU_LOG_ERROR, TSU_LOG_STALE,
                  "material %u has stale tables; call tsu_set_bake() first", material);
        return TSU_E_STATE;
    }
    for (uint32_t i = 0; i < m->model->info.table_count; i++)
        tables[i] = m->tables[i] == NO_TABLE ? (struct tsu_i_texels){NULL, 0}
                                             : tsu_i_pool_texels(&set->pool, m->tables[i]);
    return TSU_OK;
}

tsu_status tsu_set_evaluate(tsu_set *set, uint32_t material, uint32_t function, const double *in,
                            double *out)
{
    struct tsu_i_texels tables[TSU_I_MODEL_TABLES];
    tsu_status status = baked_tables(set, material, tables);
    if (status != TSU_OK)
        return status;
    const struct material *m = set->materials + material;
    status = out ? tsu_i_inputs_check(set->context, m->model, function, in) : TSU_E_PARAMETER;
    if (status == TSU_OK && !m->model->functions[function].sampled) {
        tsu_i_log(set->context, TSU_LOG_ERROR, TSU_LOG_INDEX, "%s has a reference only",
                  m->model->functions[function].info.name);
        return TSU_E_UNSUPPORTED;
    }
    if (status == TSU_OK && m->model->functions[function].params_flags & ~flags_of(m)) {
        tsu_i_log(set->context, TSU_LOG_ERROR, TSU_LOG_FLAGS,
                  "%s needs a material whose flags have the bits %u",
                  m->model->functions[function].info.name,
                  m->model->functions[function].params_flags);
        status = TSU_E_PARAMETER;
    }
    if (status == TSU_OK)
        m->model->functions[function].sampled(m->state, record_of(set, material), tables, in, out);
    else
        tsu_i_outputs_zero(m->model, function, out);
    return status;
}

tsu_status tsu_set_measure(tsu_set *set, uint32_t material, uint32_t index, const char **name,
                           double *value)
{
    struct tsu_i_texels tables[TSU_I_MODEL_TABLES];
    const tsu_status status = baked_tables(set, material, tables);
    if (status != TSU_OK)
        return status;
    const struct material *m = set->materials + material;
    if (index >= m->model->measure_count || !name || !value)
        return TSU_E_PARAMETER;
    *name = m->model->measures[index].name;
    *value = m->model->measures[index].worst(m->state, tables);
    return TSU_OK;
}
