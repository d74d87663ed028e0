#include "gl/object.h"

#include "base/desc.h"
#include "base/host.h"

static tsu_status check_points(const tsu_gl *gl, const char *function, uint32_t unit,
                               uint32_t block_binding)
{
    if (unit >= (uint32_t)gl->api.max_units) {
        tsu_i_log(gl->context, TSU_LOG_ERROR, TSU_LOG_GL_LIMIT,
                  "%s: unit = %u, expected less than GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS = %d",
                  function, unit, (int)gl->api.max_units);
        return TSU_E_LIMIT;
    }
    if (block_binding >= (uint32_t)gl->api.max_bindings) {
        tsu_i_log(gl->context, TSU_LOG_ERROR, TSU_LOG_GL_LIMIT,
                  "%s: block_binding = %u, expected less than GL_MAX_UNIFORM_BUFFER_BINDINGS = %d",
                  function, block_binding, (int)gl->api.max_bindings);
        return TSU_E_LIMIT;
    }
    return TSU_OK;
}

static tsu_status check_page(const tsu_gl *gl, const char *function, uint32_t page)
{
    if (!gl->set_id) {
        tsu_i_log(gl->context, TSU_LOG_ERROR, TSU_LOG_GL_STATE,
                  "%s: nothing was uploaded; call tsu_gl_sync() first", function);
        return TSU_E_STATE;
    }
    if (page >= gl->page_count) {
        tsu_i_log(gl->context, TSU_LOG_ERROR, TSU_LOG_INDEX,
                  "%s: page = %u, expected less than the %u pages of the set", function, page,
                  gl->page_count);
        return TSU_E_PARAMETER;
    }
    return TSU_OK;
}

tsu_status tsu_gl_bind(tsu_gl *gl, uint32_t page, uint32_t unit, uint32_t block_binding)
{
    if (!gl)
        return TSU_E_PARAMETER;
    tsu_status status = check_page(gl, "tsu_gl_bind", page);
    if (!status)
        status = check_points(gl, "tsu_gl_bind", unit, block_binding);
    if (status)
        return status;
    const struct tsu_i_gl_api *const api = &gl->api;
    const ptrdiff_t offset = (ptrdiff_t)page * TSU_PAGE_BYTES;
    const ptrdiff_t size = TSU_PAGE_BYTES;
    tsu_i_object_begin(gl, "tsu_gl_bind");
    if (api->direct) {
        api->BindTextureUnit(unit, gl->texture);
        api->BindSampler(unit, 0);
    } else {
        int32_t active = 0;
        api->GetIntegerv(TSU_I_GL_ACTIVE_TEXTURE, &active);
        api->ActiveTexture(TSU_I_GL_TEXTURE0 + unit);
        api->BindTexture(TSU_I_GL_TEXTURE_2D, gl->texture);
        api->BindSampler(unit, 0);
        api->ActiveTexture((uint32_t)active);
    }
    // Unlike the other one, this leaves the generic binding alone.
    if (api->BindBuffersRange)
        api->BindBuffersRange(TSU_I_GL_UNIFORM_BUFFER, block_binding, 1, &gl->buffer, &offset,
                              &size);
    else
        api->BindBufferRange(TSU_I_GL_UNIFORM_BUFFER, block_binding, gl->buffer, offset, size);
    tsu_i_object_end(gl, "tsu_gl_bind");
    return TSU_OK;
}

tsu_status tsu_gl_bindings(const tsu_gl *gl, uint32_t page, tsu_gl_bindings_info *out)
{
    tsu_gl_bindings_info own = {0};
    if (!gl || !out) {
        tsu_i_log(gl ? gl->context : NULL, TSU_LOG_ERROR, TSU_LOG_NULL,
                  "tsu_gl_bindings: gl or out is NULL");
        if (out)
            tsu_i_desc_write(out, &own, sizeof own);
        return TSU_E_PARAMETER;
    }
    const tsu_status status = check_page(gl, "tsu_gl_bindings", page);
    if (!status) {
        own.texture = gl->texture;
        own.buffer = gl->buffer;
        own.offset = (uint64_t)page * TSU_PAGE_BYTES;
        own.size = TSU_PAGE_BYTES;
    }
    const tsu_status written = tsu_i_desc_write(out, &own, sizeof own);
    if (written)
        tsu_i_log(gl->context, TSU_LOG_ERROR, TSU_LOG_STRUCT,
                  "tsu_gl_bindings_info.struct_size = %u; call tsu_gl_bindings_init() first",
                  out->struct_size);
    return status ? status : written;
}

// Below GL 4.1 and ES 3.1 a uniform is written in the current program only.
static void set_sampler(const struct tsu_i_gl_api *api, uint32_t program, int32_t location,
                        uint32_t unit)
{
    int32_t current = 0;
    if (api->ProgramUniform1i) {
        api->ProgramUniform1i(program, location, (int32_t)unit);
        return;
    }
    api->GetIntegerv(TSU_I_GL_CURRENT_PROGRAM, &current);
    const int other = (uint32_t)current != program;
    if (other)
        api->UseProgram(program);
    api->Uniform1i(location, (int32_t)unit);
    if (other)
        api->UseProgram((uint32_t)current);
}

// Asked before it is used, so that a wrong name raises no error in the host's context.
static int is_linked(const struct tsu_i_gl_api *api, uint32_t program)
{
    int32_t linked = 0;
    if (program && api->IsProgram(program))
        api->GetProgramiv(program, TSU_I_GL_LINK_STATUS, &linked);
    return linked != 0;
}

tsu_status tsu_gl_program_setup(tsu_gl *gl, uint32_t program, uint32_t unit, uint32_t block_binding)
{
    if (!gl)
        return TSU_E_PARAMETER;
    tsu_status status = check_points(gl, "tsu_gl_program_setup", unit, block_binding);
    if (status)
        return status;
    const struct tsu_i_gl_api *const api = &gl->api;
    tsu_i_object_begin(gl, "tsu_gl_program_setup");
    if (is_linked(api, program)) {
        const int32_t location = api->GetUniformLocation(program, "tsu_tables");
        const uint32_t block = api->GetUniformBlockIndex(program, "tsu_materials");
        if (location >= 0)
            set_sampler(api, program, location, unit);
        if (block != TSU_I_GL_INVALID_INDEX)
            api->UniformBlockBinding(program, block, block_binding);
    } else {
        tsu_i_log(gl->context, TSU_LOG_ERROR, TSU_LOG_PARAMETER,
                  "tsu_gl_program_setup: program = %u, expected a linked program", program);
        status = TSU_E_PARAMETER;
    }
    tsu_i_object_end(gl, "tsu_gl_program_setup");
    return status;
}
