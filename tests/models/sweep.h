// Random sweeps of a model's functions: the same numbers on every machine.
#ifndef TSUYA_TESTS_SWEEP_H
#define TSUYA_TESTS_SWEEP_H

#include <tsuya/tsuya.h>

struct sweep {
    tsu_context *context;
    tsu_set *set;
    uint64_t random;
};

void sweep_open(struct sweep *sweep, uint64_t seed);
void sweep_close(struct sweep *sweep);

// Uniform in [low, high), or one of the ends in two of five draws: errors live in corners.
double sweep_corner(struct sweep *sweep, double low, double high);
// Uniform in [low, high).
double sweep_between(struct sweep *sweep, double low, double high);
double sweep_degrees(struct sweep *sweep, double low, double high); // radians

// Make the set hold the one material that `in` describes; 1 on success.
int sweep_material(struct sweep *sweep, const tsu_model *model, uint32_t function,
                   const double *in);
// The function from the baked tables, and by its reference.
void sweep_table(struct sweep *sweep, uint32_t function, const double *in, double *out);
void sweep_reference(struct sweep *sweep, const tsu_model *model, uint32_t function,
                     const double *in, double *out);

// The stated error of this name, or -1.
double sweep_stated(const tsu_model *model, const char *name);

#endif
