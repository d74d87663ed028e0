#include "bench/counted.h"

#include "gpu/gl.h"
#include "gpu/offscreen.h"

#include <cstring>
#include <tuple>

namespace tsuya::bench
{

Counts counts;

namespace
{

// What the library asks for beyond the functions of the demo.
#define ALL(X)                                                                                     \
    GL_FUNCTIONS(X) X(BINDBUFFERSRANGE, BindBuffersRange) X(PROGRAMUNIFORM1I, ProgramUniform1i)

enum Index {
#define INDEX(type, name) i_##name,
    ALL(INDEX)
#undef INDEX
};

template <int index, class F> struct Entry;

template <int index, class R, class... A> struct Entry<index, R(APIENTRY *)(A...)> {
    static inline R(APIENTRY *real)(A...) = nullptr;

    static R APIENTRY call(A... a)
    {
        counts.calls++;
        if constexpr (index == i_TexSubImage2D || index == i_TextureSubImage2D) {
            const auto all = std::make_tuple(a...);
            counts.bytes += std::uint64_t(std::get<4>(all)) * std::uint64_t(std::get<5>(all)) * 8;
        } else if constexpr (index == i_BufferSubData || index == i_NamedBufferSubData) {
            counts.bytes += std::uint64_t(std::get<2>(std::make_tuple(a...)));
        }
        return real(a...);
    }
};

std::string &unknown()
{
    static std::string names;
    return names;
}

// Puts a counting function before the real one.
template <class E> void *wrap(void *address)
{
    auto call = E::call;
    void *wrapper = nullptr;
    std::memcpy(&E::real, &address, sizeof address);
    std::memcpy(&wrapper, &call, sizeof wrapper);
    return wrapper;
}

} // namespace

void *counted_proc(void *context, const char *name)
{
    void *const address = offscreen_proc(context, name);
    if (!address) {
        return nullptr;
    }
#define WRAP(type, entry)                                                                          \
    if (std::strcmp(name, "gl" #entry) == 0) {                                                     \
        return wrap<Entry<i_##entry, PFNGL##type##PROC>>(address);                                 \
    }
    ALL(WRAP)
#undef WRAP
    unknown() += (unknown().empty() ? "" : " ") + std::string(name);
    return address;
}

const std::string &uncounted()
{
    return unknown();
}

} // namespace tsuya::bench
