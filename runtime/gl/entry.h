// The entry points, types and constants of GL that the library uses, without a GL header.
//
// Types: GLenum, GLuint, GLbitfield are uint32_t; GLint, GLsizei int32_t; GLintptr, GLsizeiptr
// ptrdiff_t; GLboolean uint8_t.
#ifndef TSU_GL_ENTRY_H
#define TSU_GL_ENTRY_H

#include <stddef.h>
#include <stdint.h>

#ifdef _WIN32
#define TSU_I_GL_CALL __stdcall
#else
#define TSU_I_GL_CALL
#endif

// X(gl, es, type, name, parameters): in core since GL gl / 10 and ES es / 10, 0 for never. An entry
// point that 3.3 and 3.0 both have is required, any other one is used when the context's version
// promises it and it resolves.
#define TSU_I_GL_ENTRIES(X)                                                                        \
    X(33, 30, const uint8_t *, GetString, (uint32_t name))                                         \
    X(33, 30, uint32_t, GetError, (void))                                                          \
    X(33, 30, void, GetIntegerv, (uint32_t name, int32_t * out))                                   \
    X(33, 30, void, PixelStorei, (uint32_t name, int32_t value))                                   \
    X(33, 30, void, ActiveTexture, (uint32_t unit))                                                \
    X(33, 30, void, BindTexture, (uint32_t target, uint32_t texture))                              \
    X(33, 30, void, BindSampler, (uint32_t unit, uint32_t sampler))                                \
    X(33, 30, void, GenTextures, (int32_t count, uint32_t * out))                                  \
    X(33, 30, void, DeleteTextures, (int32_t count, const uint32_t *textures))                     \
    X(33, 30, void, TexParameteri, (uint32_t target, uint32_t name, int32_t value))                \
    X(33, 30, void, TexImage2D,                                                                    \
      (uint32_t target, int32_t level, int32_t internal, int32_t width, int32_t height,            \
       int32_t border, uint32_t format, uint32_t type, const void *texels))                        \
    X(33, 30, void, TexSubImage2D,                                                                 \
      (uint32_t target, int32_t level, int32_t x, int32_t y, int32_t width, int32_t height,        \
       uint32_t format, uint32_t type, const void *texels))                                        \
    X(33, 30, void, BindBuffer, (uint32_t target, uint32_t buffer))                                \
    X(33, 30, void, BindBufferRange,                                                               \
      (uint32_t target, uint32_t index, uint32_t buffer, ptrdiff_t offset, ptrdiff_t size))        \
    X(33, 30, void, GenBuffers, (int32_t count, uint32_t * out))                                   \
    X(33, 30, void, DeleteBuffers, (int32_t count, const uint32_t *buffers))                       \
    X(33, 30, void, BufferData,                                                                    \
      (uint32_t target, ptrdiff_t size, const void *bytes, uint32_t usage))                        \
    X(33, 30, void, BufferSubData,                                                                 \
      (uint32_t target, ptrdiff_t offset, ptrdiff_t size, const void *bytes))                      \
    X(33, 30, uint8_t, IsProgram, (uint32_t program))                                              \
    X(33, 30, void, GetProgramiv, (uint32_t program, uint32_t name, int32_t * out))                \
    X(33, 30, void, UseProgram, (uint32_t program))                                                \
    X(33, 30, void, Uniform1i, (int32_t location, int32_t value))                                  \
    X(33, 30, int32_t, GetUniformLocation, (uint32_t program, const char *name))                   \
    X(33, 30, uint32_t, GetUniformBlockIndex, (uint32_t program, const char *name))                \
    X(33, 30, void, UniformBlockBinding, (uint32_t program, uint32_t index, uint32_t binding))     \
    X(41, 31, void, ProgramUniform1i, (uint32_t program, int32_t location, int32_t value))         \
    X(42, 30, void, TexStorage2D,                                                                  \
      (uint32_t target, int32_t levels, uint32_t format, int32_t width, int32_t height))           \
    X(44, 0, void, BindBuffersRange,                                                               \
      (uint32_t target, uint32_t first, int32_t count, const uint32_t *buffers,                    \
       const ptrdiff_t *offsets, const ptrdiff_t *sizes))                                          \
    X(45, 0, void, BindTextureUnit, (uint32_t unit, uint32_t texture))                             \
    X(45, 0, void, CreateTextures, (uint32_t target, int32_t count, uint32_t * out))               \
    X(45, 0, void, TextureParameteri, (uint32_t texture, uint32_t name, int32_t value))            \
    X(45, 0, void, TextureStorage2D,                                                               \
      (uint32_t texture, int32_t levels, uint32_t format, int32_t width, int32_t height))          \
    X(45, 0, void, TextureSubImage2D,                                                              \
      (uint32_t texture, int32_t level, int32_t x, int32_t y, int32_t width, int32_t height,       \
       uint32_t format, uint32_t type, const void *texels))                                        \
    X(45, 0, void, CreateBuffers, (int32_t count, uint32_t * out))                                 \
    X(45, 0, void, NamedBufferData,                                                                \
      (uint32_t buffer, ptrdiff_t size, const void *bytes, uint32_t usage))                        \
    X(45, 0, void, NamedBufferSubData,                                                             \
      (uint32_t buffer, ptrdiff_t offset, ptrdiff_t size, const void *bytes))

// Values from the GL registry.
enum {
    TSU_I_GL_FALSE = 0,
    TSU_I_GL_NO_ERROR = 0,
    TSU_I_GL_INVALID_ENUM = 0x0500,
    TSU_I_GL_INVALID_VALUE = 0x0501,
    TSU_I_GL_INVALID_OPERATION = 0x0502,
    TSU_I_GL_OUT_OF_MEMORY = 0x0505,
    TSU_I_GL_INVALID_FRAMEBUFFER_OPERATION = 0x0506,
    TSU_I_GL_CONTEXT_LOST = 0x0507,
    TSU_I_GL_UNPACK_SWAP_BYTES = 0x0CF0,
    TSU_I_GL_UNPACK_LSB_FIRST = 0x0CF1,
    TSU_I_GL_UNPACK_ROW_LENGTH = 0x0CF2,
    TSU_I_GL_UNPACK_SKIP_ROWS = 0x0CF3,
    TSU_I_GL_UNPACK_SKIP_PIXELS = 0x0CF4,
    TSU_I_GL_UNPACK_ALIGNMENT = 0x0CF5,
    TSU_I_GL_MAX_TEXTURE_SIZE = 0x0D33,
    TSU_I_GL_TEXTURE_2D = 0x0DE1,
    TSU_I_GL_HALF_FLOAT = 0x140B,
    TSU_I_GL_RGBA = 0x1908,
    TSU_I_GL_VERSION = 0x1F02,
    TSU_I_GL_LINEAR = 0x2601,
    TSU_I_GL_TEXTURE_MAG_FILTER = 0x2800,
    TSU_I_GL_TEXTURE_MIN_FILTER = 0x2801,
    TSU_I_GL_TEXTURE_WRAP_S = 0x2802,
    TSU_I_GL_TEXTURE_WRAP_T = 0x2803,
    TSU_I_GL_TEXTURE_BINDING_2D = 0x8069,
    TSU_I_GL_UNPACK_SKIP_IMAGES = 0x806D,
    TSU_I_GL_UNPACK_IMAGE_HEIGHT = 0x806E,
    TSU_I_GL_CLAMP_TO_EDGE = 0x812F,
    TSU_I_GL_TEXTURE_BASE_LEVEL = 0x813C,
    TSU_I_GL_TEXTURE_MAX_LEVEL = 0x813D,
    TSU_I_GL_TEXTURE0 = 0x84C0,
    TSU_I_GL_ACTIVE_TEXTURE = 0x84E0,
    TSU_I_GL_RGBA16F = 0x881A,
    TSU_I_GL_DYNAMIC_DRAW = 0x88E8,
    TSU_I_GL_PIXEL_UNPACK_BUFFER = 0x88EC,
    TSU_I_GL_PIXEL_UNPACK_BUFFER_BINDING = 0x88EF,
    TSU_I_GL_UNIFORM_BUFFER = 0x8A11,
    TSU_I_GL_UNIFORM_BUFFER_BINDING = 0x8A28,
    TSU_I_GL_MAX_UNIFORM_BUFFER_BINDINGS = 0x8A2F,
    TSU_I_GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS = 0x8B4D,
    TSU_I_GL_LINK_STATUS = 0x8B82,
    TSU_I_GL_CURRENT_PROGRAM = 0x8B8D
};
#define TSU_I_GL_INVALID_INDEX 0xFFFFFFFFu

#endif
