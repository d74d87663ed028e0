// A loader between the library and GL that counts calls and the bytes they send.
#ifndef TSUYA_DEMO_BENCH_COUNTED_H
#define TSUYA_DEMO_BENCH_COUNTED_H

#include <cstdint>
#include <string>

namespace tsuya::bench
{

// Of all contexts and threads together; set it to {} to begin again.
struct Counts {
    std::uint64_t calls = 0; // of any GL function
    std::uint64_t bytes = 0; // sent by gl*SubImage2D and gl*BufferSubData, texels as RGBA16F
};
extern Counts counts;

// Hand this to tsu_gl_create() with an offscreen context. NULL for what the context has not.
void *counted_proc(void *context, const char *name);

// Functions that were asked for and cannot be counted: "" or their names.
const std::string &uncounted();

} // namespace tsuya::bench

#endif
