#include "counted.h"

#include <string.h>

struct counted counted;

// One index, one function type and one pointer to the real function for each entry point.
enum {
#define INDEX(gl, es, type, name, parameters) I_##name,
    TSU_I_GL_ENTRIES(INDEX) COUNT
};
#define TYPE(gl, es, type, name, parameters) typedef type(TSU_I_GL_CALL *name##_fn) parameters;
TSU_I_GL_ENTRIES(TYPE)
static unsigned calls[COUNT];
static struct {
#define REAL(gl, es, type, name, parameters) name##_fn name;
    TSU_I_GL_ENTRIES(REAL)
} real;

static void count(int index)
{
    calls[index]++;
    counted.calls++;
}

static void count_texels(int index, int32_t width, int32_t height)
{
    count(index);
    counted.uploads++;
    counted.texels += (unsigned long long)width * (unsigned long long)height;
}

static void count_bytes(int index, ptrdiff_t size)
{
    count(index);
    counted.uploads++;
    counted.bytes += (unsigned long long)size;
}

#define PLAIN(name, parameters, arguments)                                                         \
    static void TSU_I_GL_CALL c_##name parameters                                                  \
    {                                                                                              \
        count(I_##name);                                                                           \
        real.name arguments;                                                                       \
    }
#define VALUE(type, name, parameters, arguments)                                                   \
    static type TSU_I_GL_CALL c_##name parameters                                                  \
    {                                                                                              \
        count(I_##name);                                                                           \
        return real.name arguments;                                                                \
    }

PLAIN(PixelStorei, (uint32_t a, int32_t b), (a, b))
PLAIN(ActiveTexture, (uint32_t a), (a))
PLAIN(BindTexture, (uint32_t a, uint32_t b), (a, b))
PLAIN(DeleteTextures, (int32_t a, const uint32_t *b), (a, b))
PLAIN(TexParameteri, (uint32_t a, uint32_t b, int32_t c), (a, b, c))
PLAIN(TexImage2D,
      (uint32_t a, int32_t b, int32_t c, int32_t d, int32_t e, int32_t f, uint32_t g, uint32_t h,
       const void *i),
      (a, b, c, d, e, f, g, h, i))
PLAIN(BindBuffer, (uint32_t a, uint32_t b), (a, b))
PLAIN(BindBufferRange, (uint32_t a, uint32_t b, uint32_t c, ptrdiff_t d, ptrdiff_t e),
      (a, b, c, d, e))
PLAIN(DeleteBuffers, (int32_t a, const uint32_t *b), (a, b))
PLAIN(BufferData, (uint32_t a, ptrdiff_t b, const void *c, uint32_t d), (a, b, c, d))
VALUE(uint8_t, IsProgram, (uint32_t a), (a))
PLAIN(GetProgramiv, (uint32_t a, uint32_t b, int32_t *c), (a, b, c))
PLAIN(UseProgram, (uint32_t a), (a))
PLAIN(Uniform1i, (int32_t a, int32_t b), (a, b))
VALUE(int32_t, GetUniformLocation, (uint32_t a, const char *b), (a, b))
VALUE(uint32_t, GetUniformBlockIndex, (uint32_t a, const char *b), (a, b))
PLAIN(UniformBlockBinding, (uint32_t a, uint32_t b, uint32_t c), (a, b, c))
PLAIN(ProgramUniform1i, (uint32_t a, int32_t b, int32_t c), (a, b, c))
PLAIN(TexStorage2D, (uint32_t a, int32_t b, uint32_t c, int32_t d, int32_t e), (a, b, c, d, e))
PLAIN(BindBuffersRange,
      (uint32_t a, uint32_t b, int32_t c, const uint32_t *d, const ptrdiff_t *e,
       const ptrdiff_t *f),
      (a, b, c, d, e, f))
PLAIN(BindTextureUnit, (uint32_t a, uint32_t b), (a, b))
PLAIN(TextureParameteri, (uint32_t a, uint32_t b, int32_t c), (a, b, c))
PLAIN(TextureStorage2D, (uint32_t a, int32_t b, uint32_t c, int32_t d, int32_t e), (a, b, c, d, e))
PLAIN(NamedBufferData, (uint32_t a, ptrdiff_t b, const void *c, uint32_t d), (a, b, c, d))

static const uint8_t *TSU_I_GL_CALL c_GetString(uint32_t name)
{
    count(I_GetString);
    return counted.fake_version && name == TSU_I_GL_VERSION ? (const uint8_t *)counted.version
                                                            : real.GetString(name);
}

static uint32_t TSU_I_GL_CALL c_GetError(void)
{
    count(I_GetError);
    counted.gets++;
    return counted.stuck ? counted.stuck : real.GetError();
}

static void TSU_I_GL_CALL c_GetIntegerv(uint32_t name, int32_t *out)
{
    count(I_GetIntegerv);
    real.GetIntegerv(name, out);
    if (counted.max_texture_size && name == TSU_I_GL_MAX_TEXTURE_SIZE)
        *out = counted.max_texture_size;
}

static void TSU_I_GL_CALL c_BindSampler(uint32_t unit, uint32_t sampler)
{
    count(I_BindSampler);
    real.BindSampler(counted.bad_unit ? 0xFFFF : unit, sampler);
}

static void TSU_I_GL_CALL c_GenTextures(int32_t n, uint32_t *out)
{
    count(I_GenTextures);
    if (!counted.no_textures)
        real.GenTextures(n, out);
}

static void TSU_I_GL_CALL c_CreateTextures(uint32_t target, int32_t n, uint32_t *out)
{
    count(I_CreateTextures);
    if (!counted.no_textures)
        real.CreateTextures(target, n, out);
}

static void TSU_I_GL_CALL c_GenBuffers(int32_t n, uint32_t *out)
{
    count(I_GenBuffers);
    if (!counted.no_buffers)
        real.GenBuffers(n, out);
}

static void TSU_I_GL_CALL c_CreateBuffers(int32_t n, uint32_t *out)
{
    count(I_CreateBuffers);
    if (!counted.no_buffers)
        real.CreateBuffers(n, out);
}

static void TSU_I_GL_CALL c_TexSubImage2D(uint32_t target, int32_t level, int32_t x, int32_t y,
                                          int32_t width, int32_t height, uint32_t format,
                                          uint32_t type, const void *texels)
{
    count_texels(I_TexSubImage2D, width, height);
    real.TexSubImage2D(target, level, x, y, width, height, format, type, texels);
}

static void TSU_I_GL_CALL c_TextureSubImage2D(uint32_t texture, int32_t level, int32_t x, int32_t y,
                                              int32_t width, int32_t height, uint32_t format,
                                              uint32_t type, const void *texels)
{
    count_texels(I_TextureSubImage2D, width, height);
    real.TextureSubImage2D(texture, level, x, y, width, height, format, type, texels);
}

static void TSU_I_GL_CALL c_BufferSubData(uint32_t target, ptrdiff_t offset, ptrdiff_t size,
                                          const void *bytes)
{
    count_bytes(I_BufferSubData, size);
    real.BufferSubData(target, offset, size, bytes);
}

static void TSU_I_GL_CALL c_NamedBufferSubData(uint32_t buffer, ptrdiff_t offset, ptrdiff_t size,
                                               const void *bytes)
{
    count_bytes(I_NamedBufferSubData, size);
    real.NamedBufferSubData(buffer, offset, size, bytes);
}

// The compiler checks each trampoline against the entry's type.
static const struct {
#define WRAP_FIELD(gl, es, type, name, parameters) name##_fn name;
    TSU_I_GL_ENTRIES(WRAP_FIELD)
} wraps = {
#define WRAP(gl, es, type, name, parameters) c_##name,
    TSU_I_GL_ENTRIES(WRAP)};

static const struct {
    const char *name;
    int required;
    void *real;
    const void *wrap;
} rows[COUNT] = {
#define ROW(gl, es, type, name, parameters)                                                        \
    {"gl" #name, (gl) <= 33 && (es) != 0 && (es) <= 30, &real.name, &wraps.name},
    TSU_I_GL_ENTRIES(ROW)};

void counted_open(void *(*proc)(void *user, const char *name), void *user)
{
    counted.proc = proc;
    counted.user = user;
    counted_reset();
}

void counted_reset(void)
{
    counted = (struct counted){.proc = counted.proc, .user = counted.user};
    memset(calls, 0, sizeof calls);
}

void *counted_proc(void *user, const char *name)
{
    (void)user;
    counted.resolved++;
    if (counted.nothing || (counted.hide && strcmp(name, counted.hide) == 0))
        return NULL;
    for (size_t i = 0; i < COUNT; i++)
        if (strcmp(name, rows[i].name) == 0) {
            void *address = counted.proc(counted.user, name);
            memcpy(rows[i].real, &address, sizeof address);
            if (address)
                memcpy(&address, rows[i].wrap, sizeof address);
            return address;
        }
    return NULL;
}

unsigned counted_calls(const char *name)
{
    for (size_t i = 0; i < COUNT; i++)
        if (strcmp(name, rows[i].name) == 0)
            return calls[i];
    return 0;
}

const char *counted_name(size_t index, int *required)
{
    if (index >= COUNT)
        return NULL;
    *required = rows[index].required;
    return rows[index].name;
}
