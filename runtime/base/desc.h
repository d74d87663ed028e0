// The one place where struct_size is understood.
#ifndef TSU_BASE_DESC_H
#define TSU_BASE_DESC_H

#include <tsuya/context.h>

// Copy a host descriptor over `own`, which holds our defaults. `own_size` is our layout, `least`
// the first released one. A larger host struct is accepted when what we do not know is zero. Fails
// with TSU_E_STRUCT and a log line that names `name`.
tsu_status tsu_i_desc_read(const tsu_context *context, const char *name, const void *host,
                           void *own, size_t own_size, size_t least);

// Copy a result of ours into a host struct that carries its size; the host's size is kept.
tsu_status tsu_i_desc_write(void *host, const void *own, size_t own_size);

// Zero a result that carries its size, at most our layout of it; `status` is handed through.
tsu_status tsu_i_desc_fail(void *host, size_t own_size, tsu_status status);

// Start a host struct: zero, the defaults that fit, and its size.
tsu_status tsu_i_desc_init(void *host, size_t host_size, const void *defaults, size_t own_size,
                           size_t least);

#endif
