// Colour of a head: the library's curves, solved once for each fibre that a program meets.
#ifndef TSUYA_SCENE_HEAD_H
#define TSUYA_SCENE_HEAD_H

#include <tsuya/hair_color.h>
#include <tsuya/model.h>

#include <cstdint>

namespace tsuya::scene {

// The fibre that a model's typed parameters describe; what the model has no parameter for is at its
// default.
tsu_hair_head_desc head_fibre(const tsu_model *model, const void *params);

// sigma_a of a head's albedo, as tsu_hair_head_sigma_a(). The first call for a fibre other than the
// default takes seconds; the last curves are kept. Errors: the library's, in the context's log.
tsu_status head_sigma_a(tsu_context *context, const tsu_hair_head_desc &fibre,
                        const double albedo[3], double sigma_a[3]);

// A tsu_jobs_fn that uses all cores.
void all_cores(void *user, void (*job)(void *data, std::uint32_t index), void *data,
               std::uint32_t count);

} // namespace tsuya::scene

#endif
