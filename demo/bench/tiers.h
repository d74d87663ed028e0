// The tiers and baselines whose cost is measured, and their fragment shaders.
#ifndef TSUYA_DEMO_BENCH_TIERS_H
#define TSUYA_DEMO_BENCH_TIERS_H

#include "draw/program.h"

#include <tsuya/shader.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tsuya::bench
{

// A row of tiers.inc.
struct Tier {
    const char *name;
    const tsu_model *model;
    bool fine; // needs TSU_SHADER_FINE
    int fetches;
    const char *expression; // radiance of one light, GLSL
};

const std::vector<Tier> &tiers();

// Flags that the parameters of its material need: those of the variant that it calls.
std::uint32_t params_flags(const Tier &tier);
// Default parameters with these flags, aligned as every typed struct wants.
std::vector<double> parameters(const Tier &tier);
// Bytes of the tables of one material.
std::size_t table_bytes(const Tier &tier);

// GLSL after the version line: varyings of stage.h, the library's functions, the tier's expression.
// Throws std::runtime_error with the library's status.
std::string fragment(tsu_context *context, const Tier &tier);

// The files of tests/bench/baseline; ends with a NULL name.
using draw::Source;
extern const Source baseline_sources[];

// What fragment() gives, of a shader of tests/bench/baseline: lambert, kajiya_kay or ggx.
std::string baseline(const std::string &name);

} // namespace tsuya::bench

#endif
