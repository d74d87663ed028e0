#include "base/desc.h"

#include "base/host.h"

#include <string.h>

static size_t smaller(size_t a, size_t b)
{
    return a < b ? a : b;
}

tsu_status tsu_i_desc_read(const tsu_context *context, const char *name, const void *host,
                           void *own, size_t own_size, size_t least)
{
    uint32_t size = 0;
    if (host)
        memcpy(&size, host, sizeof size);
    if (size < least) {
        if (host)
            tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_STRUCT,
                      "%s.struct_size = %u, expected at least %u; call %s_init() first", name, size,
                      (unsigned)least, name);
        else
            tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_NULL, "%s is NULL", name);
        return TSU_E_STRUCT;
    }
    for (size_t i = own_size; i < size; i++)
        if (((const unsigned char *)host)[i]) {
            tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_STRUCT,
                      "%s has a field past %u bytes that this library does not know", name,
                      (unsigned)own_size);
            return TSU_E_STRUCT;
        }
    memcpy(own, host, smaller(size, own_size));
    const uint32_t known = (uint32_t)own_size;
    memcpy(own, &known, sizeof known);
    return TSU_OK;
}

tsu_status tsu_i_desc_write(void *host, const void *own, size_t own_size)
{
    uint32_t size = 0;
    if (!host)
        return TSU_E_PARAMETER;
    memcpy(&size, host, sizeof size);
    if (size < 2 * sizeof size)
        return TSU_E_STRUCT;
    memcpy(host, own, smaller(size, own_size));
    memcpy(host, &size, sizeof size);
    return TSU_OK;
}

tsu_status tsu_i_desc_init(void *host, size_t host_size, const void *defaults, size_t own_size,
                           size_t least)
{
    if (!host || host_size < least || host_size > UINT32_MAX)
        return TSU_E_STRUCT;
    memset(host, 0, host_size);
    if (defaults)
        memcpy(host, defaults, smaller(host_size, own_size));
    const uint32_t size = (uint32_t)host_size;
    memcpy(host, &size, sizeof size);
    return TSU_OK;
}

tsu_status tsu_i_desc_fail(void *host, size_t own_size, tsu_status status)
{
    uint32_t size = 0;
    if (host)
        memcpy(&size, host, sizeof size);
    // A size that no init() wrote may be anything: never past what the host must own.
    if (size > sizeof size)
        memset((char *)host + sizeof size, 0, smaller(size, own_size) - sizeof size);
    return status;
}
