#include "gl/load.h"

#include "base/host.h"
#include "base/text.h"

#include <string.h>

_Static_assert(sizeof(void *) == sizeof(void (*)(void)), "functions are handed over as void *");

struct entry {
    const char *name;
    int32_t gl, es; // since, as in entry.h
    size_t offset;  // in struct tsu_i_gl_api
};

static const struct entry entries[] = {
#define TSU_I_GL_ROW(gl, es, type, name, parameters)                                               \
    {"gl" #name, gl, es, offsetof(struct tsu_i_gl_api, name)},
    TSU_I_GL_ENTRIES(TSU_I_GL_ROW)
#undef TSU_I_GL_ROW
};

enum { LEAST_GL = 33, LEAST_ES = 30, DIRECT_GL = 45 };

static int is_required(const struct entry *entry)
{
    return entry->gl <= LEAST_GL && entry->es != 0 && entry->es <= LEAST_ES;
}

// Loaders may answer any name with a stub, so the version decides first.
static int is_promised(const struct entry *entry, const struct tsu_i_gl_api *api)
{
    const int32_t since = api->es ? entry->es : entry->gl;
    return since != 0 && since <= api->version;
}

// memcpy because ISO C has no cast between object and function pointers.
static int resolve(const struct entry *entry, tsu_gl_proc_fn proc, void *user,
                   struct tsu_i_gl_api *api)
{
    void *const address = proc(user, entry->name);
    memcpy((char *)api + entry->offset, &address, sizeof address);
    return address != NULL;
}

// 0 when there is no number.
static int32_t number(const char **text)
{
    int32_t value = 0;
    while (**text >= '0' && **text <= '9' && value < 1000)
        value = 10 * value + (*(*text)++ - '0');
    return value;
}

// The string and not GL_MAJOR_VERSION: asking an old context for that raises an error in it.
// Source: "<major>.<minor>..." on GL, "OpenGL ES <major>.<minor>..." on ES, and "OpenGL ES-CM 1.1".
static tsu_status read_version(const tsu_context *context, struct tsu_i_gl_api *api)
{
    static const char es[] = "OpenGL ES";
    const char *const version = (const char *)api->GetString(TSU_I_GL_VERSION);
    if (!version) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_GL_VERSION,
                  "GL_VERSION is NULL: no GL context is current");
        return TSU_E_UNSUPPORTED;
    }
    const char *at = version;
    api->es = strncmp(version, es, sizeof es - 1) == 0;
    while (api->es && *at && !(*at >= '0' && *at <= '9'))
        at++;
    const int32_t major = number(&at);
    if (*at == '.')
        at++;
    const int32_t minor = number(&at);
    api->version = 10 * major + (minor < 9 ? minor : 9);
    if (api->version < (api->es ? LEAST_ES : LEAST_GL)) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_GL_VERSION,
                  "GL_VERSION is \"%s\", expected GL 3.3 or GL ES 3.0 or later", version);
        return TSU_E_UNSUPPORTED;
    }
    return TSU_OK;
}

tsu_status tsu_i_load_entries(const tsu_context *context, tsu_gl_proc_fn proc, void *user,
                              struct tsu_i_gl_api *api)
{
    char names[640];
    struct tsu_i_line missing = {names, sizeof names, 0};
    const size_t count = sizeof entries / sizeof *entries;
    memset(api, 0, sizeof *api);
    // GetString is the first in entry.h. The version is read before the rest is asked for, so
    // that an old context is called old and not incomplete.
    if (resolve(&entries[0], proc, user, api)) {
        const tsu_status status = read_version(context, api);
        if (status)
            return status;
    }
    api->direct = !api->es && api->version >= DIRECT_GL;
    for (size_t i = 0; i < count; i++) {
        if (!is_required(&entries[i]) && !is_promised(&entries[i], api))
            continue;
        if (resolve(&entries[i], proc, user, api))
            continue;
        if (is_required(&entries[i])) {
            tsu_i_line_put(&missing, missing.size ? " " : "");
            tsu_i_line_put(&missing, entries[i].name);
        } else if (entries[i].gl == DIRECT_GL) {
            api->direct = 0;
        }
    }
    if (missing.size) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_GL_MISSING, "missing from GL: %s", names);
        return TSU_E_UNSUPPORTED;
    }
    return TSU_OK;
}

void tsu_i_load_limits(struct tsu_i_gl_api *api)
{
    api->GetIntegerv(TSU_I_GL_MAX_TEXTURE_SIZE, &api->max_texture_size);
    api->GetIntegerv(TSU_I_GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &api->max_units);
    api->GetIntegerv(TSU_I_GL_MAX_UNIFORM_BUFFER_BINDINGS, &api->max_bindings);
}
