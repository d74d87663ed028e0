// Typed parameters of any model.
#ifndef TSUYA_DRAW_PARAMS_H
#define TSUYA_DRAW_PARAMS_H

#include <cstdint>
#include <cstring>

namespace tsuya::draw {

// Set bits in `flags`, the second number of every typed struct: those that a variant asks for
// (tsu_variant_info.params_flags).
inline void add_flags(void *params, std::uint32_t flags)
{
    std::uint32_t head[2]; // struct_size, flags
    std::memcpy(head, params, sizeof head);
    head[1] |= flags;
    std::memcpy(params, head, sizeof head);
}

} // namespace tsuya::draw

#endif
