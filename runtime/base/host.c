#include "base/host.h"

#include "base/text.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static void *default_allocate(void *user, void *pointer, size_t old_size, size_t size)
{
    (void)user;
    (void)old_size;
    if (size == 0) {
        free(pointer);
        return NULL;
    }
    return realloc(pointer, size);
}

static void *allocate(const tsu_context *c, void *pointer, size_t old_size, size_t size)
{
    return c->desc.allocate ? c->desc.allocate(c->desc.allocate_user, pointer, old_size, size)
                            : default_allocate(NULL, pointer, old_size, size);
}

void *tsu_i_realloc(const tsu_context *context, void *pointer, size_t old_count, size_t count,
                    size_t size)
{
    void *grown = count <= SIZE_MAX / size && count > 0
                      ? allocate(context, pointer, old_count * size, count * size)
                      : NULL;
    if (!grown) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_MEMORY, "out of memory for %u items",
                  (unsigned)count);
        return NULL;
    }
    if (count > old_count)
        memset((char *)grown + old_count * size, 0, (count - old_count) * size);
    return grown;
}

void *tsu_i_alloc(const tsu_context *context, size_t count, size_t size)
{
    return tsu_i_realloc(context, NULL, 0, count, size);
}

void tsu_i_free(const tsu_context *context, void *pointer, size_t count, size_t size)
{
    if (pointer)
        allocate(context, pointer, count * size, 0);
}

void tsu_i_log(const tsu_context *context, int32_t level, int32_t code, const char *format, ...)
{
    if (!context || !context->desc.log)
        return;
    char line[512];
    struct tsu_i_line out = {line, sizeof line, 0};
    tsu_i_line_put(&out, level == TSU_LOG_ERROR ? "[E" : level == TSU_LOG_WARNING ? "[W" : "[I");
    const char digits[5] = {(char)('0' + code / 1000 % 10), (char)('0' + code / 100 % 10),
                            (char)('0' + code / 10 % 10), (char)('0' + code % 10), 0};
    tsu_i_line_put(&out, digits);
    tsu_i_line_put(&out, "] ");
    va_list arguments;
    va_start(arguments, format);
    tsu_i_line_format(&out, format, arguments);
    va_end(arguments);
    context->desc.log(context->desc.log_user, level, code, line);
}

void tsu_i_jobs(const tsu_context *context, void (*job)(void *, uint32_t), void *data,
                uint32_t count)
{
    if (context->desc.jobs && count > 1) {
        context->desc.jobs(context->desc.jobs_user, job, data, count);
        return;
    }
    for (uint32_t i = 0; i < count; i++)
        job(data, i);
}
