// What the tests of sets and tables share.
#ifndef TSUYA_TESTS_BAKE_RIG_H
#define TSUYA_TESTS_BAKE_RIG_H

#include "watch.h"

struct rig {
    struct watch watch;
    tsu_context *context;
    tsu_set *set;
};

// A watched context and a set; max_texture_size 0 leaves the default. `jobs` may be NULL.
void rig_open(struct rig *r, uint32_t max_texture_size, tsu_jobs_fn jobs);
// Destroys both and asserts that no memory is left.
void rig_close(struct rig *r);

tsu_marschner_params rig_hair(float eta, float beta_az);
uint32_t rig_add(struct rig *r, float eta, float beta_az);
tsu_set_info rig_describe(const struct rig *r);

// The first region of this generation or later that is in use; asserts that there is one.
tsu_region rig_region(const struct rig *r, uint32_t index);
// The rectangle of a Marschner table out of its material's record, as glsl/marschner/eval.glsl
// documents it: record 0.w and 1.w are the texture coordinates of the cell's middle column and of
// its first row's centre.
tsu_region rig_region_of(const struct rig *r, uint32_t material);
// Texels of a rectangle, tight; the caller frees.
uint16_t *rig_texels(const struct rig *r, tsu_region region);
// The same for a set that holds nothing but one material with these parameters.
uint16_t *rig_alone(float eta, float beta_az);

enum { RIG_TABLE_BYTES = 128 * 128 * 8 };

// Groups of tests.
int set_tests(void);
int growth_tests(void);
int jobs_tests(void);
int memory_tests(void);
int cache_tests(void);

#endif
