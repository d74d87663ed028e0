#include "gl/object.h"
#include "gl/state.h"

#include "base/host.h"

// For a set whose models bake nothing: what is bound is always a complete texture.
static const uint16_t black[4] = {0, 0, 0, 0};

static void set_parameters(const struct tsu_i_gl_api *api, uint32_t texture)
{
    static const struct {
        uint32_t name;
        int32_t value;
    } parameters[] = {
        {TSU_I_GL_TEXTURE_MIN_FILTER, TSU_I_GL_LINEAR},
        {TSU_I_GL_TEXTURE_MAG_FILTER, TSU_I_GL_LINEAR},
        {TSU_I_GL_TEXTURE_WRAP_S, TSU_I_GL_CLAMP_TO_EDGE},
        {TSU_I_GL_TEXTURE_WRAP_T, TSU_I_GL_CLAMP_TO_EDGE},
        {TSU_I_GL_TEXTURE_BASE_LEVEL, 0},
        {TSU_I_GL_TEXTURE_MAX_LEVEL, 0},
    };
    for (size_t i = 0; i < sizeof parameters / sizeof *parameters; i++) {
        if (api->direct)
            api->TextureParameteri(texture, parameters[i].name, parameters[i].value);
        else
            api->TexParameteri(TSU_I_GL_TEXTURE_2D, parameters[i].name, parameters[i].value);
    }
}

static uint32_t new_texture(const struct tsu_i_gl_api *api)
{
    uint32_t texture = 0;
    if (api->direct)
        api->CreateTextures(TSU_I_GL_TEXTURE_2D, 1, &texture);
    else
        api->GenTextures(1, &texture);
    return texture;
}

// Without direct access the texture is bound.
static void set_storage(const struct tsu_i_gl_api *api, uint32_t texture, int32_t width,
                        int32_t height)
{
    if (api->direct)
        api->TextureStorage2D(texture, 1, TSU_I_GL_RGBA16F, width, height);
    else if (api->TexStorage2D)
        api->TexStorage2D(TSU_I_GL_TEXTURE_2D, 1, TSU_I_GL_RGBA16F, width, height);
    else
        api->TexImage2D(TSU_I_GL_TEXTURE_2D, 0, TSU_I_GL_RGBA16F, width, height, 0, TSU_I_GL_RGBA,
                        TSU_I_GL_HALF_FLOAT, NULL);
}

static void send_region(const tsu_gl *gl, const uint16_t *texels, const tsu_region *region)
{
    const int32_t x = (int32_t)region->x, y = (int32_t)region->y;
    const int32_t width = (int32_t)region->width, height = (int32_t)region->height;
    const uint16_t *const first = texels + 4 * ((size_t)gl->width * region->y + region->x);
    if (gl->api.direct)
        gl->api.TextureSubImage2D(gl->texture, 0, x, y, width, height, TSU_I_GL_RGBA,
                                  TSU_I_GL_HALF_FLOAT, first);
    else
        gl->api.TexSubImage2D(TSU_I_GL_TEXTURE_2D, 0, x, y, width, height, TSU_I_GL_RGBA,
                              TSU_I_GL_HALF_FLOAT, first);
}

static void send_regions(const tsu_gl *gl, const tsu_set *set, const uint16_t *texels, int all)
{
    tsu_region region = {0, 0, gl->width, gl->height, 0};
    if (all) {
        send_region(gl, texels, &region);
        return;
    }
    for (uint32_t i = 0; tsu_set_region(set, i, &region); i++)
        if (region.generation > gl->generation)
            send_region(gl, texels, &region);
}

static tsu_status sync_texture(tsu_gl *gl, const tsu_set *set, const tsu_set_info *info, int all)
{
    const struct tsu_i_gl_api *const api = &gl->api;
    const uint32_t width = info->width ? info->width : 1;
    const uint32_t height = info->height ? info->height : 1;
    const int grown = width != gl->width || height != gl->height;
    if (!grown && !all && info->texture_generation == gl->texture_generation)
        return TSU_OK;
    const uint32_t old = gl->texture;
    const uint32_t texture = grown ? new_texture(api) : old;
    if (!texture) {
        tsu_i_log(gl->context, TSU_LOG_ERROR, TSU_LOG_MEMORY, "GL gave no name for a texture");
        return TSU_E_MEMORY;
    }
    gl->texture = texture;
    gl->width = width;
    gl->height = height;
    struct tsu_i_state state;
    tsu_i_state_begin_texture(api, &state, width);
    if (!api->direct)
        api->BindTexture(TSU_I_GL_TEXTURE_2D, texture);
    if (grown) {
        set_parameters(api, texture);
        set_storage(api, texture, (int32_t)width, (int32_t)height);
    }
    send_regions(gl, set, info->width ? tsu_set_texels(set) : black, grown || all);
    tsu_i_state_end_texture(api, &state);
    // Only now: the host may have it bound on the active unit, and the name just restored must
    // still be alive.
    if (grown && old)
        api->DeleteTextures(1, &old);
    return TSU_OK;
}

// Without direct access the buffer is bound.
static void send_pages(const tsu_gl *gl, uint32_t first, uint32_t count, const float *bytes)
{
    const ptrdiff_t offset = (ptrdiff_t)first * TSU_PAGE_BYTES;
    const ptrdiff_t size = (ptrdiff_t)count * TSU_PAGE_BYTES;
    if (count == 0)
        return;
    if (gl->api.direct)
        gl->api.NamedBufferSubData(gl->buffer, offset, size, bytes);
    else
        gl->api.BufferSubData(TSU_I_GL_UNIFORM_BUFFER, offset, size, bytes);
}

// The name stays when the store grows, so that bindings the host has copied stay right.
static void grow_buffer(tsu_gl *gl, uint32_t pages)
{
    const uint32_t doubled = 2 * gl->page_capacity;
    gl->page_capacity = doubled > pages ? doubled : pages;
    const ptrdiff_t size = (ptrdiff_t)gl->page_capacity * TSU_PAGE_BYTES;
    if (gl->api.direct)
        gl->api.NamedBufferData(gl->buffer, size, NULL, TSU_I_GL_DYNAMIC_DRAW);
    else
        gl->api.BufferData(TSU_I_GL_UNIFORM_BUFFER, size, NULL, TSU_I_GL_DYNAMIC_DRAW);
}

// Pages that changed and lie one after the other in memory are sent in one call.
static void send_changed_pages(const tsu_gl *gl, const tsu_set *set, uint32_t pages, int all)
{
    uint32_t first = 0, count = 0;
    const float *run = NULL;
    for (uint32_t page = 0; page < pages; page++) {
        uint64_t generation = 0;
        const float *const bytes = tsu_set_page(set, page, &generation);
        const int changed = all || generation > gl->generation;
        if (count && changed && bytes == run + (size_t)count * 4 * TSU_PAGE_VEC4) {
            count++;
            continue;
        }
        send_pages(gl, first, count, run);
        first = page;
        count = changed ? 1 : 0;
        run = bytes;
    }
    send_pages(gl, first, count, run);
}

static void sync_pages(tsu_gl *gl, const tsu_set *set, const tsu_set_info *info, int all)
{
    struct tsu_i_state state;
    const int grown = info->page_count > gl->page_capacity;
    tsu_i_state_begin_buffer(&gl->api, &state);
    if (!gl->api.direct)
        gl->api.BindBuffer(TSU_I_GL_UNIFORM_BUFFER, gl->buffer);
    if (grown)
        grow_buffer(gl, info->page_count);
    send_changed_pages(gl, set, info->page_count, grown || all);
    tsu_i_state_end_buffer(&gl->api, &state);
    gl->page_count = info->page_count;
}

static tsu_status check(const tsu_gl *gl, const tsu_set_info *info)
{
    const uint32_t most = (uint32_t)gl->api.max_texture_size;
    if (info->stale_count) {
        tsu_i_log(gl->context, TSU_LOG_ERROR, TSU_LOG_STALE,
                  "tsu_gl_sync: %u tables are stale; call tsu_set_bake() first", info->stale_count);
        return TSU_E_STATE;
    }
    if (info->width > most || info->height > most) {
        tsu_i_log(gl->context, TSU_LOG_ERROR, TSU_LOG_GL_LIMIT,
                  "tsu_gl_sync: texture of %u x %u, expected at most GL_MAX_TEXTURE_SIZE = %u",
                  info->width, info->height, most);
        return TSU_E_LIMIT;
    }
    return TSU_OK;
}

static tsu_status upload(tsu_gl *gl, const tsu_set *set, const tsu_set_info *info)
{
    const int all = gl->set_id != info->id;
    if (!gl->buffer) {
        if (gl->api.direct)
            gl->api.CreateBuffers(1, &gl->buffer);
        else
            gl->api.GenBuffers(1, &gl->buffer);
    }
    if (!gl->buffer) {
        tsu_i_log(gl->context, TSU_LOG_ERROR, TSU_LOG_MEMORY, "GL gave no name for a buffer");
        return TSU_E_MEMORY;
    }
    const tsu_status status = sync_texture(gl, set, info, all);
    if (status)
        return status;
    sync_pages(gl, set, info, all);
    return TSU_OK;
}

tsu_status tsu_gl_sync(tsu_gl *gl, const tsu_set *set)
{
    tsu_set_info info = {0};
    if (!gl || !set) {
        tsu_i_log(gl ? gl->context : NULL, TSU_LOG_ERROR, TSU_LOG_NULL,
                  "tsu_gl_sync: gl or set is NULL");
        return TSU_E_PARAMETER;
    }
    info.struct_size = sizeof info;
    tsu_status status = tsu_set_describe(set, &info);
    if (!status)
        status = check(gl, &info);
    if (status || (gl->set_id == info.id && gl->generation == info.generation))
        return status;
    tsu_i_object_begin(gl, "tsu_gl_sync");
    if (info.page_count)
        status = upload(gl, set, &info);
    else
        gl->page_count = 0;
    tsu_i_object_end(gl, "tsu_gl_sync");
    if (status)
        return status;
    gl->set_id = info.id;
    gl->generation = info.generation;
    gl->texture_generation = info.texture_generation;
    return TSU_OK;
}
