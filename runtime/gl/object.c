#include "gl/object.h"

#include "base/desc.h"
#include "base/host.h"

// A lost context answers GL_CONTEXT_LOST for ever.
enum { DRAIN_MOST = 32 };

static const char *error_name(uint32_t error)
{
    switch (error) {
    case TSU_I_GL_INVALID_ENUM:
        return "GL_INVALID_ENUM";
    case TSU_I_GL_INVALID_VALUE:
        return "GL_INVALID_VALUE";
    case TSU_I_GL_INVALID_OPERATION:
        return "GL_INVALID_OPERATION";
    case TSU_I_GL_OUT_OF_MEMORY:
        return "GL_OUT_OF_MEMORY";
    case TSU_I_GL_INVALID_FRAMEBUFFER_OPERATION:
        return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case TSU_I_GL_CONTEXT_LOST:
        return "GL_CONTEXT_LOST";
    default:
        return "an unknown error";
    }
}

static void drain(const tsu_gl *gl, const char *function, const char *whose)
{
    if (!(gl->flags & TSU_GL_CHECK))
        return;
    const uint32_t first = gl->api.GetError();
    uint32_t count = first != TSU_I_GL_NO_ERROR;
    while (count > 0 && count < DRAIN_MOST && gl->api.GetError() != TSU_I_GL_NO_ERROR)
        count++;
    if (count)
        tsu_i_log(gl->context, TSU_LOG_ERROR, TSU_LOG_GL_ERROR, "%s: GL errors %s: %u, first %s",
                  function, whose, count, error_name(first));
}

void tsu_i_object_begin(const tsu_gl *gl, const char *function)
{
    drain(gl, function, "of the host, pending on entry");
}

void tsu_i_object_end(const tsu_gl *gl, const char *function)
{
    drain(gl, function, "of the library");
}

tsu_status tsu_gl_desc_init_sized(tsu_gl_desc *desc, size_t size)
{
    return tsu_i_desc_init(desc, size, NULL, sizeof *desc, sizeof *desc);
}

static tsu_status check_desc(const tsu_context *context, const tsu_gl_desc *desc, tsu_gl_desc *own)
{
    const tsu_status status =
        tsu_i_desc_read(context, "tsu_gl_desc", desc, own, sizeof *own, sizeof *own);
    if (status)
        return status;
    if (own->flags & ~(uint32_t)TSU_GL_CHECK) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_FLAGS,
                  "tsu_gl_desc.flags = %u, expected TSU_GL_* bits", own->flags);
        return TSU_E_PARAMETER;
    }
    if (!own->get_proc_address) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_NULL, "tsu_gl_desc.get_proc_address is NULL");
        return TSU_E_PARAMETER;
    }
    return TSU_OK;
}

tsu_status tsu_gl_create(tsu_context *context, const tsu_gl_desc *desc, tsu_gl **out)
{
    tsu_gl_desc own = {0};
    if (out)
        *out = NULL;
    if (!context || !out) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_NULL, "tsu_gl_create: context or out is NULL");
        return TSU_E_PARAMETER;
    }
    tsu_status status = check_desc(context, desc, &own);
    if (status)
        return status;
    tsu_gl *const gl = tsu_i_alloc(context, 1, sizeof *gl);
    if (!gl)
        return TSU_E_MEMORY;
    gl->context = context;
    gl->flags = own.flags;
    status = tsu_i_load_entries(context, own.get_proc_address, own.user, &gl->api);
    if (status) {
        tsu_i_free(context, gl, 1, sizeof *gl);
        return status;
    }
    tsu_i_object_begin(gl, "tsu_gl_create");
    tsu_i_load_limits(&gl->api);
    tsu_i_object_end(gl, "tsu_gl_create");
    *out = gl;
    return TSU_OK;
}

void tsu_gl_destroy(tsu_gl *gl)
{
    if (!gl)
        return;
    tsu_i_object_begin(gl, "tsu_gl_destroy");
    if (gl->texture)
        gl->api.DeleteTextures(1, &gl->texture);
    if (gl->buffer)
        gl->api.DeleteBuffers(1, &gl->buffer);
    tsu_i_object_end(gl, "tsu_gl_destroy");
    tsu_gl_abandon(gl);
}

void tsu_gl_abandon(tsu_gl *gl)
{
    if (gl)
        tsu_i_free(gl->context, gl, 1, sizeof *gl);
}
