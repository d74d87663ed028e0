#include "base/desc.h"
#include "base/host.h"

#include <stdlib.h>
#include <string.h>

uint32_t tsu_version(void)
{
    return TSU_VERSION;
}

const char *tsu_status_text(tsu_status status)
{
    static const char *const names[] = {
        "TSU_OK",      "TSU_E_PARAMETER",   "TSU_E_STRUCT", "TSU_E_VERSION", "TSU_E_MEMORY",
        "TSU_E_LIMIT", "TSU_E_UNSUPPORTED", "TSU_E_STATE",  "TSU_E_HOST"};
    return status <= 0 && status >= TSU_E_HOST ? names[-status] : "unknown status";
}

enum { CONTEXT_LEAST = sizeof(tsu_context_desc) };

tsu_status tsu_context_desc_init_sized(tsu_context_desc *desc, size_t size, uint32_t version)
{
    const tsu_context_desc defaults = {.struct_size = sizeof defaults, .version = version};
    return tsu_i_desc_init(desc, size, &defaults, sizeof defaults, CONTEXT_LEAST);
}

tsu_status tsu_context_create(const tsu_context_desc *desc, tsu_context **out)
{
    if (!out)
        return TSU_E_PARAMETER;
    *out = NULL;
    struct tsu_context local = {0};
    // Until the descriptor is known to be sound only its logger is trusted, and only when it is
    // there.
    struct tsu_context early = {0};
    if (desc && desc->struct_size >= offsetof(tsu_context_desc, jobs)) {
        early.desc.log = desc->log;
        early.desc.log_user = desc->log_user;
    }
    const tsu_status status = tsu_i_desc_read(&early, "tsu_context_desc", desc, &local.desc,
                                              sizeof local.desc, CONTEXT_LEAST);
    if (status != TSU_OK)
        return status;
    if (local.desc.version >> 22 != TSU_VERSION_MAJOR) {
        tsu_i_log(&local, TSU_LOG_ERROR, TSU_LOG_VERSION,
                  "tsu_context_desc.version = %u (header major %u), this library is major %u",
                  local.desc.version, local.desc.version >> 22, TSU_VERSION_MAJOR);
        return TSU_E_VERSION;
    }
    if (local.desc.flags || local.desc.reserved) {
        tsu_i_log(&local, TSU_LOG_ERROR, TSU_LOG_FLAGS, "tsu_context_desc.flags = %u, expected 0",
                  local.desc.flags | local.desc.reserved);
        return TSU_E_PARAMETER;
    }
    tsu_context *context = tsu_i_alloc(&local, 1, sizeof *context);
    if (!context)
        return TSU_E_MEMORY;
    *context = local;
    *out = context;
    return TSU_OK;
}

void tsu_context_destroy(tsu_context *context)
{
    if (context) {
        const struct tsu_context last = *context;
        tsu_i_free(&last, context, 1, sizeof *context);
    }
}
