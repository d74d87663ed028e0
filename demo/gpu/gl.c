#include "gl.h"

#include <stdio.h>
#include <string.h>

typedef void *(*find_function)(void *user, const char *name);

// Loads one function into the pointer at `slot` and names it in `*missing` when it is not there.
// memcpy because ISO C has no cast between object and function pointers.
static void load(find_function proc, void *user, void *slot, const char *name, const char **missing)
{
    void *const address = proc(user, name);
    memcpy(slot, &address, sizeof address);
    if (!address && !*missing) {
        *missing = name;
    }
}

int gl_at_least(const struct gl_api *gl, int es, int major, int minor)
{
    return gl->es == es && (gl->major > major || (gl->major == major && gl->minor >= minor));
}

static int fail(const char **missing, const char *what)
{
    if (missing) {
        *missing = what;
    }
    return 0;
}

int gl_load(struct gl_api *gl, find_function proc, void *user, const char **missing)
{
    static const char es_prefix[] = "OpenGL ES ";
    const char *absent = NULL;
    memset(gl, 0, sizeof *gl);

    load(proc, user, &gl->GetString, "glGetString", &absent);
    if (absent) {
        return fail(missing, absent);
    }
    const char *version = (const char *)gl->GetString(GL_VERSION);
    if (!version) {
        return fail(missing, "a current context");
    }
    gl->es = strncmp(version, es_prefix, sizeof es_prefix - 1) == 0;
    if (sscanf(gl->es ? version + sizeof es_prefix - 1 : version, "%d.%d", &gl->major,
               &gl->minor) != 2) {
        return fail(missing, "a version string that can be read");
    }
    if (!gl_at_least(gl, 0, 3, 3) && !gl_at_least(gl, 1, 3, 0)) {
        return fail(missing, "OpenGL 3.3 or OpenGL ES 3.0");
    }

    // By version, not by address: a loader may answer any name with a stub.
#define GL_LOAD(type, name) load(proc, user, &gl->name, "gl" #name, &absent);
    GL_FUNCTIONS_COMMON(GL_LOAD)
    if (!gl->es) {
        GL_FUNCTIONS_DESKTOP(GL_LOAD)
    }
    if (gl->es || gl_at_least(gl, 0, 4, 2)) {
        GL_FUNCTIONS_STORAGE(GL_LOAD)
    }
    if (gl->es || gl_at_least(gl, 0, 4, 1)) {
        GL_FUNCTIONS_FEEDBACK(GL_LOAD)
    }
    if (gl_at_least(gl, 1, 3, 2) || gl_at_least(gl, 0, 4, 3)) {
        GL_FUNCTIONS_DEBUG(GL_LOAD)
    }
    if (gl_at_least(gl, 0, 4, 5)) {
        GL_FUNCTIONS_DIRECT(GL_LOAD)
    }
#undef GL_LOAD
    return absent ? fail(missing, absent) : 1;
}
