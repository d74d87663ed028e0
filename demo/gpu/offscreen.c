#include "offscreen.h"
#include "library.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The few names of EGL 1.5, its platform extensions, OSMesa and OpenGL that are used here.
enum { EGL_EXTENSIONS_ = 0x3055, EGL_NONE_ = 0x3038, EGL_ES_API_ = 0x30A0, EGL_GL_API_ = 0x30A2 };
enum { EGL_MAJOR_ = 0x3098, EGL_MINOR_ = 0x30FB, EGL_PROFILE_ = 0x30FD, EGL_CORE_ = 1 };
enum { EGL_SURFACELESS_ = 0x31DD, EGL_DEVICE_ = 0x313F };
enum { OSMESA_FORMAT_ = 0x22, OSMESA_DEPTH_ = 0x30, OSMESA_STENCIL_ = 0x31 };
enum { OSMESA_PROFILE_ = 0x33, OSMESA_CORE_ = 0x34, OSMESA_MAJOR_ = 0x36, OSMESA_MINOR_ = 0x37 };
enum { GL_VENDOR_ = 0x1F00, GL_RENDERER_ = 0x1F01, GL_VERSION_ = 0x1F02 };
enum { GL_RGBA_ = 0x1908, GL_UNSIGNED_BYTE_ = 0x1401, MAX_DEVICES = 16, BUFFER_SIDE = 16 };

// Addresses of functions travel as void *, which POSIX guarantees and dlsym() needs anyway.
struct egl {
    void *(*get_proc)(const char *);
    int (*get_error)(void);
    const char *(*query_string)(void *display, int name);
    unsigned (*initialize)(void *display, int *major, int *minor);
    unsigned (*bind_api)(unsigned api);
    void *(*create_context)(void *display, void *config, void *share, const int *attributes);
    unsigned (*destroy_context)(void *display, void *context);
    unsigned (*make_current)(void *display, void *draw, void *read, void *context);
    void *(*get_current)(void);
    void *(*get_platform_display)(unsigned platform, void *native, const int *attributes);
    unsigned (*query_devices)(int max, void **devices, int *count);
};

struct osmesa {
    void *(*create_context)(const int *attributes, void *share);
    void (*destroy_context)(void *context);
    unsigned char (*make_current)(void *context, void *buffer, unsigned type, int w, int h);
    void *(*get_proc)(const char *);
};

struct offscreen {
    enum offscreen_backend backend;
    unsigned egl_api;
    void *display; // EGL only
    void *context;
    char description[320];
    unsigned char buffer[BUFFER_SIDE * BUFFER_SIDE * 4]; // OSMesa wants a default framebuffer
};

static struct egl egl;
static struct osmesa osmesa;
static int backend_in_use = OFFSCREEN_ANY; // ANY until the first context exists

// A message that grows by parts and is cut, still terminated, at the end of the caller's memory.
struct message {
    char *text;
    size_t size;
};

static void say(struct message *m, const char *format, ...)
{
    const size_t used = strlen(m->text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(m->text + used, m->size - used, format, arguments);
    va_end(arguments);
}

static int open_egl(struct message *m)
{
    static const char *const names[] = {"libEGL.so.1", NULL};
    static const struct library_symbol symbols[] = {
        {"eglGetError", &egl.get_error},           {"eglQueryString", &egl.query_string},
        {"eglInitialize", &egl.initialize},        {"eglBindAPI", &egl.bind_api},
        {"eglCreateContext", &egl.create_context}, {"eglDestroyContext", &egl.destroy_context},
        {"eglMakeCurrent", &egl.make_current},     {"eglGetCurrentContext", &egl.get_current},
        {"eglGetProcAddress", &egl.get_proc},      {NULL, NULL},
    };
    if (!egl.get_proc && !library_open(names, symbols, m->text, m->size)) {
        return 0;
    }
    void *const display = egl.get_proc("eglGetPlatformDisplayEXT");
    void *const devices = egl.get_proc("eglQueryDevicesEXT");
    memcpy(&egl.get_platform_display, &display, sizeof display);
    memcpy(&egl.query_devices, &devices, sizeof devices);
    return 1;
}

static int open_osmesa(struct message *m)
{
    static const char *const names[] = {"libOSMesa.so.8", "libOSMesa.so", NULL};
    static const struct library_symbol symbols[] = {
        {"OSMesaCreateContextAttribs", &osmesa.create_context},
        {"OSMesaDestroyContext", &osmesa.destroy_context},
        {"OSMesaMakeCurrent", &osmesa.make_current},
        {"OSMesaGetProcAddress", &osmesa.get_proc}, {NULL, NULL},
    };
    return osmesa.get_proc || library_open(names, symbols, m->text, m->size);
}

// None of the extension names asked for here is the beginning of another one.
static int has(const char *extensions, const char *name)
{
    return extensions && strstr(extensions, name);
}

// Gives the context back and leaves `c` ready for another attempt.
static void drop(offscreen *c)
{
    if (c->context && c->backend == OFFSCREEN_EGL) {
        if (egl.bind_api(c->egl_api) && egl.get_current() == c->context) {
            offscreen_release(c);
        }
        egl.destroy_context(c->display, c->context);
    } else if (c->context) {
        osmesa.destroy_context(c->context);
    }
    c->context = NULL;
}

// Makes the new context current, fills the description and holds the version against the request.
// Drops a context that does not pass.
static int settle(offscreen *c, const char *name, const offscreen_desc *desc, struct message *m)
{
    static const char es_prefix[] = "OpenGL ES ";
    const unsigned char *(*get_string)(unsigned) = NULL;
    if (offscreen_make_current(c)) {
        void *const address = offscreen_proc(c, "glGetString");
        memcpy(&get_string, &address, sizeof address);
    }
    const char *version = get_string ? (const char *)get_string(GL_VERSION_) : NULL;
    const int es = version && strncmp(version, es_prefix, sizeof es_prefix - 1) == 0;
    int major = 0, minor = 0;
    if (!version) {
        say(m, "the context cannot be made current. ");
    } else if (sscanf(version + (es ? sizeof es_prefix - 1 : 0), "%d.%d", &major, &minor) != 2 ||
               es != (desc->api == OFFSCREEN_ES) || major < desc->major ||
               (major == desc->major && minor < desc->minor)) {
        say(m, "the context is version \"%s\". ", version);
    } else {
        snprintf(c->description, sizeof c->description, "%s: %s, %s, %s", name,
                 (const char *)get_string(GL_VENDOR_), (const char *)get_string(GL_RENDERER_),
                 version);
        return 1;
    }
    drop(c);
    return 0;
}

static int egl_context(offscreen *c, void *display, const char *name, const offscreen_desc *desc,
                       struct message *m)
{
    const int es = desc->api == OFFSCREEN_ES;
    const int attributes[] = {EGL_MAJOR_, desc->major, EGL_MINOR_, desc->minor,
                              es ? EGL_NONE_ : EGL_PROFILE_, EGL_CORE_, EGL_NONE_};
    if (!display || !egl.initialize(display, NULL, NULL)) {
        say(m, "no display (EGL error 0x%x). ", (unsigned)egl.get_error());
        return 0;
    }
    const char *extensions = egl.query_string(display, EGL_EXTENSIONS_);
    if (!has(extensions, "EGL_KHR_surfaceless_context") ||
        !has(extensions, "EGL_KHR_no_config_context")) {
        say(m, "the display makes no contexts without a surface and a configuration. ");
        return 0;
    }
    c->display = display;
    c->egl_api = es ? EGL_ES_API_ : EGL_GL_API_;
    if (egl.bind_api(c->egl_api)) {
        c->context = egl.create_context(display, NULL, NULL, attributes);
    }
    if (!c->context) {
        say(m, "no context of version %d.%d (EGL error 0x%x). ", desc->major, desc->minor,
            (unsigned)egl.get_error());
        return 0;
    }
    return settle(c, name, desc, m);
}

static int create_egl(offscreen *c, const offscreen_desc *desc, struct message *m)
{
    c->backend = OFFSCREEN_EGL;
    say(m, "EGL surfaceless: ");
    if (!open_egl(m)) {
        return 0;
    }
    const char *extensions = egl.query_string(NULL, EGL_EXTENSIONS_);
    if (!egl.get_platform_display || !has(extensions, "EGL_MESA_platform_surfaceless")) {
        say(m, "the platform is not there. ");
    } else if (egl_context(c, egl.get_platform_display(EGL_SURFACELESS_, NULL, NULL),
                           "EGL surfaceless", desc, m)) {
        return 1;
    }
    say(m, "EGL device: ");
    void *devices[MAX_DEVICES];
    int count = 0;
    if (!egl.get_platform_display || !has(extensions, "EGL_EXT_platform_device") ||
        !egl.query_devices || !egl.query_devices(MAX_DEVICES, devices, &count) || count < 1) {
        say(m, "the platform is not there or has no devices. ");
        return 0;
    }
    int made = 0;
    for (int i = 0; i < count && !made; i++) {
        void *const display = egl.get_platform_display(EGL_DEVICE_, devices[i], NULL);
        made = egl_context(c, display, "EGL device", desc, m);
    }
    return made;
}

static int create_osmesa(offscreen *c, const offscreen_desc *desc, struct message *m)
{
    const int attributes[] = {OSMESA_FORMAT_, GL_RGBA_, OSMESA_PROFILE_, OSMESA_CORE_,
                              OSMESA_DEPTH_, 24, OSMESA_STENCIL_, 8,
                              OSMESA_MAJOR_, desc->major, OSMESA_MINOR_, desc->minor, 0};
    c->backend = OFFSCREEN_OSMESA;
    say(m, "OSMesa: ");
    if (desc->api == OFFSCREEN_ES) {
        say(m, "it makes no OpenGL ES contexts. ");
        return 0;
    }
    if (!open_osmesa(m)) {
        return 0;
    }
    c->context = osmesa.create_context(attributes, NULL);
    if (!c->context) {
        say(m, "no context of version %d.%d. ", desc->major, desc->minor);
        return 0;
    }
    return settle(c, "OSMesa", desc, m);
}

int offscreen_create(const offscreen_desc *desc, offscreen **out, char *error, size_t error_size)
{
    struct message m = {error, error_size};
    *out = NULL;
    error[0] = '\0';
    offscreen *c = calloc(1, sizeof *c);
    if (!c) {
        say(&m, "out of memory for an offscreen context.");
        return 0;
    }
    int made = 0;
    for (int b = OFFSCREEN_EGL; b <= OFFSCREEN_OSMESA && !made; b++) {
        const int asked = desc->backend == OFFSCREEN_ANY || (int)desc->backend == b;
        if (asked && backend_in_use != OFFSCREEN_ANY && backend_in_use != b) {
            say(&m, "%s: refused, this process already draws through the other back-end. ",
                b == OFFSCREEN_EGL ? "EGL" : "OSMesa");
        } else if (asked) {
            made = b == OFFSCREEN_EGL ? create_egl(c, desc, &m) : create_osmesa(c, desc, &m);
        }
    }
    if (!made) {
        free(c);
        return 0;
    }
    backend_in_use = (int)c->backend;
    error[0] = '\0';
    *out = c;
    return 1;
}

void offscreen_destroy(offscreen *context)
{
    if (context) {
        drop(context);
        free(context);
    }
}

int offscreen_make_current(offscreen *context)
{
    if (context->backend == OFFSCREEN_OSMESA) {
        return osmesa.make_current(context->context, context->buffer, GL_UNSIGNED_BYTE_,
                                   BUFFER_SIDE, BUFFER_SIDE) != 0;
    }
    // Released first: EGL does nothing when it believes the context is current already, which is
    // wrong after someone else in the process changed the slot behind its back.
    return offscreen_release(context) &&
           egl.make_current(context->display, NULL, NULL, context->context) != 0;
}

int offscreen_release(offscreen *context)
{
    if (context->backend == OFFSCREEN_OSMESA) {
        return osmesa.make_current(NULL, NULL, 0, 0, 0) != 0;
    }
    return egl.bind_api(context->egl_api) != 0 &&
           egl.make_current(context->display, NULL, NULL, NULL) != 0;
}

void *offscreen_proc(void *user, const char *name)
{
    const offscreen *context = user;
    return context->backend == OFFSCREEN_EGL ? egl.get_proc(name) : osmesa.get_proc(name);
}

const char *offscreen_description(const offscreen *context)
{
    return context->description;
}
