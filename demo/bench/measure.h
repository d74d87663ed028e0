// Cost on the machine at hand. Rows as in rows.h; times vary from run to run, counts do not.
//
// Times are processor time, which other programs on the machine hardly change; pixels of a GPU are
// timed by its own clock.
//
//   TIER,pixel,DRIVER/ns        nanoseconds a pixel
//   TIER,pixel,DRIVER/wall_ns   the same by the wall clock around glFinish
//   TIER,pixel,DRIVER/lambert   over those of Lambert in the same round, median of the rounds
//   TIER,pixel,DRIVER/ggx       the same of Lambert under GGX
//   TIER,fetches,               from textures, a pixel and light
//   TIER,bytes,                 of the tables of one material
//   TIER,bake_ms,               of one material on one core; 0 without tables
//   api,FRAME.WHAT,MATERIALS    FRAME: unchanged, one_changed, all_changed; WHAT: ns, calls (of
//   GL),
//                               allocations, bytes (uploaded) of updates, sync and one bind
//   api,bind.WHAT,MATERIALS     of the bind alone; other pages of a frame add as much each
#ifndef TSUYA_DEMO_BENCH_MEASURE_H
#define TSUYA_DEMO_BENCH_MEASURE_H

#include "bench/rows.h"
#include "bench/stage.h"

namespace tsuya::bench
{

// One pixel of every tier and baseline.
//   size    pixels along a side of the target; 0: 256, where softpipe draws 64
//   rounds  each draws every shader; 0: 41
// Throws std::runtime_error: the driver refuses a shader, or one is not finite and positive
// somewhere.
Rows measure_pixels(const Context &context, int size, int rounds);

// Fetches and memory of every tier.
Rows measure_memory();

// Bake of one material of every tier's model.
//   rounds  0: as many as fit into a quarter of a second, at least one
Rows measure_bakes(int rounds);

// Frames of sets of 1 to 10 000 materials with 16 sets of tables.
//   rounds  0: 41
// Throws std::runtime_error when the library calls a GL function that is not counted.
Rows measure_api(const Context &context, int rounds);

} // namespace tsuya::bench

#endif
