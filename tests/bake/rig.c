#include "rig.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

void rig_open(struct rig *r, uint32_t max_texture_size, tsu_jobs_fn jobs)
{
    watch_begin(&r->watch);
    tsu_context_desc desc = watch_desc(&r->watch);
    desc.jobs = jobs;
    desc.jobs_user = r;
    assert_int_equal(tsu_context_create(&desc, &r->context), TSU_OK);
    tsu_set_desc set;
    assert_int_equal(tsu_set_desc_init(&set), TSU_OK);
    if (max_texture_size)
        set.max_texture_size = max_texture_size;
    assert_int_equal(tsu_set_create(r->context, &set, &r->set), TSU_OK);
}

void rig_close(struct rig *r)
{
    tsu_set_destroy(r->set);
    tsu_context_destroy(r->context);
    watch_close(&r->watch);
}

tsu_marschner_params rig_hair(float eta, float beta_az)
{
    tsu_marschner_params hair;
    assert_int_equal(tsu_marschner_params_init(&hair), TSU_OK);
    hair.eta = eta;
    hair.beta_az = beta_az;
    return hair;
}

uint32_t rig_add(struct rig *r, float eta, float beta_az)
{
    const tsu_marschner_params hair = rig_hair(eta, beta_az);
    uint32_t material;
    assert_int_equal(tsu_set_add(r->set, tsu_marschner(), &hair, &material), TSU_OK);
    return material;
}

tsu_set_info rig_describe(const struct rig *r)
{
    tsu_set_info info;
    assert_int_equal(tsu_set_info_init(&info), TSU_OK);
    assert_int_equal(tsu_set_describe(r->set, &info), TSU_OK);
    return info;
}

tsu_region rig_region(const struct rig *r, uint32_t index)
{
    tsu_region region;
    assert_int_equal(tsu_set_region(r->set, index, &region), 1);
    return region;
}

tsu_region rig_region_of(const struct rig *r, uint32_t material)
{
    const tsu_set_info info = rig_describe(r);
    const float *record = tsu_set_record(r->set, material);
    assert_non_null(record);
    const double x = (double)record[3] * info.width - 64.0;
    const double y = (double)record[7] * info.height - 0.5;
    // Within a thousandth of a texel of a whole one.
    assert_true(fabs(x - rint(x)) < 1e-3 && fabs(y - rint(y)) < 1e-3);
    const tsu_region place = {(uint32_t)rint(x), (uint32_t)rint(y), 128, 128, 0};
    tsu_region region;
    for (uint32_t i = 0; tsu_set_region(r->set, i, &region); i++)
        if (region.width == 128 && region.x == place.x && region.y == place.y)
            return region;
    fail_msg("no table lies at %u, %u", place.x, place.y);
    return place;
}

uint16_t *rig_texels(const struct rig *r, tsu_region region)
{
    const tsu_set_info info = rig_describe(r);
    const uint16_t *all = tsu_set_texels(r->set);
    assert_non_null(all);
    assert_true(region.width && region.x + region.width <= info.width);
    assert_true(region.height && region.y + region.height <= info.height);
    const size_t row = (size_t)region.width * 4;
    uint16_t *out = malloc(region.height * row * sizeof *out);
    assert_non_null(out);
    for (uint32_t y = 0; y < region.height; y++)
        memcpy(out + y * row, all + ((size_t)(region.y + y) * info.width + region.x) * 4,
               row * sizeof *out);
    return out;
}

uint16_t *rig_alone(float eta, float beta_az)
{
    struct rig *r = calloc(1, sizeof *r);
    assert_non_null(r);
    rig_open(r, 0, NULL);
    const uint32_t material = rig_add(r, eta, beta_az);
    assert_int_equal(tsu_set_bake(r->set), TSU_OK);
    uint16_t *texels = rig_texels(r, rig_region_of(r, material));
    rig_close(r);
    free(r);
    return texels;
}
