#include "offscreen.h"

#include <dlfcn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The few names of EGL 1.5, its platform extensions and OSMesa that are used here.
enum {
    EGL_VENDOR_ = 0x3053,
    EGL_EXTENSIONS_ = 0x3055,
    EGL_NONE_ = 0x3038,
    EGL_OPENGL_ES_API_ = 0x30A0,
    EGL_OPENGL_API_ = 0x30A2,
    EGL_CONTEXT_MAJOR_VERSION_ = 0x3098,
    EGL_CONTEXT_MINOR_VERSION_ = 0x30FB,
    EGL_CONTEXT_OPENGL_PROFILE_MASK_ = 0x30FD,
    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_ = 1,
    EGL_PLATFORM_SURFACELESS_MESA_ = 0x31DD,
    EGL_PLATFORM_DEVICE_EXT_ = 0x313F,
    OSMESA_FORMAT_ = 0x22,
    OSMESA_DEPTH_BITS_ = 0x30,
    OSMESA_STENCIL_BITS_ = 0x31,
    OSMESA_PROFILE_ = 0x33,
    OSMESA_CORE_PROFILE_ = 0x34,
    OSMESA_CONTEXT_MAJOR_VERSION_ = 0x36,
    OSMESA_CONTEXT_MINOR_VERSION_ = 0x37,
    GL_RGBA_ = 0x1908,
    GL_UNSIGNED_BYTE_ = 0x1401,
    GL_VENDOR_ = 0x1F00,
    GL_RENDERER_ = 0x1F01,
    GL_VERSION_ = 0x1F02,
    MAX_DEVICES = 16,
    BUFFER_SIDE = 16 // OSMesa wants some memory as its default framebuffer
};

typedef void (*any_function)(void);

struct egl {
    any_function (*get_proc)(const char *);
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
    void *(*get_current)(void);
    any_function (*get_proc)(const char *);
};

struct offscreen {
    enum offscreen_backend backend;
    unsigned egl_api;
    void *display; // EGL only
    void *context;
    char description[320];
    unsigned char buffer[BUFFER_SIDE * BUFFER_SIDE * 4]; // OSMesa only
};

static struct egl egl;
static struct osmesa osmesa;
static int backend_in_use = OFFSCREEN_ANY; // ANY until the first context exists

struct symbol {
    const char *name;
    void *slot; // address of a function pointer
};

// A message that grows by parts and is cut, still terminated, at the end of the caller's memory.
struct message {
    char *text;
    size_t size, used;
};

static void say(struct message *m, const char *format, ...)
{
    if (m->used + 1 >= m->size) {
        return;
    }
    va_list arguments;
    va_start(arguments, format);
    const int n = vsnprintf(m->text + m->used, m->size - m->used, format, arguments);
    va_end(arguments);
    if (n > 0) {
        m->used = m->used + (size_t)n < m->size ? m->used + (size_t)n : m->size - 1;
    }
}

// memcpy because ISO C has no cast between object and function pointers; POSIX makes them alike.
static int open_library(const char *const *names, const struct symbol *symbols, size_t count,
                        struct message *m)
{
    void *library = NULL;
    for (; !library && *names; names++) {
        library = dlopen(*names, RTLD_NOW | RTLD_LOCAL);
        if (!library) {
            say(m, "cannot open %s. ", *names);
        }
    }
    for (size_t i = 0; library && i < count; i++) {
        void *address = dlsym(library, symbols[i].name);
        if (!address) {
            say(m, "the library has no function %s. ", symbols[i].name);
            dlclose(library);
            return 0;
        }
        memcpy(symbols[i].slot, &address, sizeof address);
    }
    return library != NULL;
}

static int open_egl(struct message *m)
{
    static const char *const names[] = {"libEGL.so.1", NULL};
    static const struct symbol symbols[] = {
        {"eglGetError", &egl.get_error},           {"eglQueryString", &egl.query_string},
        {"eglInitialize", &egl.initialize},        {"eglBindAPI", &egl.bind_api},
        {"eglCreateContext", &egl.create_context}, {"eglDestroyContext", &egl.destroy_context},
        {"eglMakeCurrent", &egl.make_current},     {"eglGetCurrentContext", &egl.get_current},
        {"eglGetProcAddress", &egl.get_proc},
    };
    if (egl.get_proc) {
        return 1;
    }
    if (!open_library(names, symbols, sizeof symbols / sizeof *symbols, m)) {
        return 0;
    }
    const any_function display = egl.get_proc("eglGetPlatformDisplayEXT");
    const any_function devices = egl.get_proc("eglQueryDevicesEXT");
    memcpy(&egl.get_platform_display, &display, sizeof display);
    memcpy(&egl.query_devices, &devices, sizeof devices);
    return 1;
}

static int open_osmesa(struct message *m)
{
    static const char *const names[] = {"libOSMesa.so.8", "libOSMesa.so", NULL};
    static const struct symbol symbols[] = {
        {"OSMesaCreateContextAttribs", &osmesa.create_context},
        {"OSMesaDestroyContext", &osmesa.destroy_context},
        {"OSMesaMakeCurrent", &osmesa.make_current},
        {"OSMesaGetCurrentContext", &osmesa.get_current},
        {"OSMesaGetProcAddress", &osmesa.get_proc},
    };
    return osmesa.get_proc || open_library(names, symbols, sizeof symbols / sizeof *symbols, m);
}

// True when `word` stands in the space-separated `list`, not merely as part of a longer name.
static int has_word(const char *list, const char *word)
{
    const size_t n = strlen(word);
    for (const char *at = list; at && (at = strstr(at, word)); at += n) {
        if ((at == list || at[-1] == ' ') && (at[n] == ' ' || at[n] == '\0')) {
            return 1;
        }
    }
    return 0;
}

// Fills the description and holds the context against the request. Needs the context current.
static int describe(offscreen *c, const char *name, const offscreen_desc *desc, struct message *m)
{
    const unsigned char *(*get_string)(unsigned);
    void *const address = offscreen_proc(c, "glGetString");
    memcpy(&get_string, &address, sizeof address);
    const char *version = address ? (const char *)get_string(GL_VERSION_) : NULL;
    if (!version) {
        say(m, "the context does not tell its version. ");
        return 0;
    }
    snprintf(c->description, sizeof c->description, "%s: %s, %s, %s", name,
             (const char *)get_string(GL_VENDOR_), (const char *)get_string(GL_RENDERER_), version);
    static const char es_prefix[] = "OpenGL ES ";
    const int es = strncmp(version, es_prefix, sizeof es_prefix - 1) == 0;
    int major = 0, minor = 0;
    if (sscanf(es ? version + sizeof es_prefix - 1 : version, "%d.%d", &major, &minor) != 2 ||
        es != (desc->api == OFFSCREEN_ES) || major < desc->major ||
        (major == desc->major && minor < desc->minor)) {
        say(m, "the context is version \"%s\". ", version);
        return 0;
    }
    return 1;
}

static int egl_context(offscreen *c, void *display, const char *name, const offscreen_desc *desc,
                       struct message *m)
{
    const int es = desc->api == OFFSCREEN_ES;
    const int attributes[] = {EGL_CONTEXT_MAJOR_VERSION_,
                              desc->major,
                              EGL_CONTEXT_MINOR_VERSION_,
                              desc->minor,
                              es ? EGL_NONE_ : EGL_CONTEXT_OPENGL_PROFILE_MASK_,
                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_,
                              EGL_NONE_};
    if (!display || !egl.initialize(display, NULL, NULL)) {
        say(m, "no display (EGL error 0x%x). ", (unsigned)egl.get_error());
        return 0;
    }
    const char *extensions = egl.query_string(display, EGL_EXTENSIONS_);
    if (!has_word(extensions, "EGL_KHR_surfaceless_context") ||
        !(has_word(extensions, "EGL_KHR_no_config_context") ||
          has_word(extensions, "EGL_MESA_configless_context"))) {
        say(m, "the display makes no contexts without a surface and a configuration. ");
        return 0;
    }
    c->display = display;
    c->egl_api = es ? EGL_OPENGL_ES_API_ : EGL_OPENGL_API_;
    if (!egl.bind_api(c->egl_api)) {
        say(m, "the display has no OpenGL%s. ", es ? " ES" : "");
        return 0;
    }
    c->context = egl.create_context(display, NULL, NULL, attributes);
    if (!c->context) {
        say(m, "no context of version %d.%d (EGL error 0x%x). ", desc->major, desc->minor,
            (unsigned)egl.get_error());
        return 0;
    }
    if (offscreen_make_current(c) && describe(c, name, desc, m)) {
        return 1;
    }
    say(m, "the context made by %s cannot be used. ", egl.query_string(display, EGL_VENDOR_));
    offscreen_release(c);
    egl.destroy_context(display, c->context);
    c->context = NULL;
    return 0;
}

static int create_egl(offscreen *c, const offscreen_desc *desc, struct message *m)
{
    c->backend = OFFSCREEN_EGL;
    say(m, "EGL surfaceless: ");
    if (!open_egl(m)) {
        return 0;
    }
    const char *extensions = egl.query_string(NULL, EGL_EXTENSIONS_);
    if (!egl.get_platform_display || !has_word(extensions, "EGL_EXT_platform_base")) {
        say(m, "the library has no platform displays. ");
        return 0;
    }
    if (!has_word(extensions, "EGL_MESA_platform_surfaceless")) {
        say(m, "the platform is not there. ");
    } else if (egl_context(c, egl.get_platform_display(EGL_PLATFORM_SURFACELESS_MESA_, NULL, NULL),
                           "EGL surfaceless", desc, m)) {
        return 1;
    }
    say(m, "EGL device: ");
    void *devices[MAX_DEVICES];
    int count = 0;
    if (!egl.query_devices || !has_word(extensions, "EGL_EXT_platform_device") ||
        !egl.query_devices(MAX_DEVICES, devices, &count) || count < 1) {
        say(m, "the platform is not there or has no devices. ");
        return 0;
    }
    for (int i = 0; i < count; i++) {
        if (egl_context(c, egl.get_platform_display(EGL_PLATFORM_DEVICE_EXT_, devices[i], NULL),
                        "EGL device", desc, m)) {
            return 1;
        }
    }
    return 0;
}

static int create_osmesa(offscreen *c, const offscreen_desc *desc, struct message *m)
{
    const int attributes[] = {OSMESA_FORMAT_,
                              GL_RGBA_,
                              OSMESA_DEPTH_BITS_,
                              24,
                              OSMESA_STENCIL_BITS_,
                              8,
                              OSMESA_PROFILE_,
                              OSMESA_CORE_PROFILE_,
                              OSMESA_CONTEXT_MAJOR_VERSION_,
                              desc->major,
                              OSMESA_CONTEXT_MINOR_VERSION_,
                              desc->minor,
                              0};
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
    if (offscreen_make_current(c) && describe(c, "OSMesa", desc, m)) {
        return 1;
    }
    say(m, "the context cannot be used. ");
    osmesa.destroy_context(c->context);
    c->context = NULL;
    return 0;
}

int offscreen_create(const offscreen_desc *desc, offscreen **out, char *error, size_t error_size)
{
    struct message m = {error, error_size, 0};
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
    if (!context) {
        return;
    }
    if (context->backend == OFFSCREEN_EGL) {
        egl.bind_api(context->egl_api);
        if (egl.get_current() == context->context) {
            offscreen_release(context);
        }
        egl.destroy_context(context->display, context->context);
    } else {
        osmesa.destroy_context(context->context);
    }
    free(context);
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
    const any_function function =
        context->backend == OFFSCREEN_EGL ? egl.get_proc(name) : osmesa.get_proc(name);
    void *address;
    memcpy(&address, &function, sizeof address);
    return address;
}

enum offscreen_backend offscreen_backend_of(const offscreen *context)
{
    return context->backend;
}

const char *offscreen_description(const offscreen *context)
{
    return context->description;
}
