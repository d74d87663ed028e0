#include "leaf_truth.h"

#include <math.h>
#include <stdlib.h>

const double truth_cosine[TRUTH_COSINES] = {0.05, 0.12, 0.22, 0.35, 0.5, 0.65, 0.8, 0.92, 1.0};

// Eight Gauss-Legendre nodes on [0, 1], upper half; the lower one mirrors them.
static const double half_node[4] = {0.591717321247824949, 0.762766204958164493,
                                    0.898333238706813370, 0.980144928248768116};
static const double half_weight[4] = {0.181341891689180992, 0.156853322938943644,
                                      0.111190517226687236, 0.0506142681451881296};

static double node(int i)
{
    return i < 4 ? half_node[i] : 1.0 - half_node[i - 4];
}

static double surface(double n, double mu)
{
    const double t = sqrt(1.0 - (1.0 - mu * mu) / (n * n));
    const double s = (mu - n * t) / (mu + n * t), p = (t - n * mu) / (t + n * mu);
    return 0.5 * (s * s + p * p);
}

void truth_solve(struct truth *truth, const tsu_leaf_body_params *params, double pigment,
                 double thickness)
{
    const double scatter[2] = {params->scatter_top[0], params->scatter_bottom[0]};
    const double absorption[2] = {params->absorption_top[0], params->absorption_bottom[0]};
    for (int k = 0; k < 2; k++) {
        const double s = thickness * scatter[k] / (1.0 - TSU_LEAF_G);
        const double depth = s + thickness * pigment * absorption[k];
        truth->layers[k] = (struct tsu_i_slab_layer){.n = params->n,
                                                     .albedo = depth > 0.0 ? s / depth : 0.0,
                                                     .depth = depth,
                                                     .g = TSU_LEAF_G};
    }
    for (int i = 0; i < TRUTH_COSINES + TRUTH_GAUSS; i++)
        truth->directions[i] = (struct tsu_i_slab_direction){
            i < TRUTH_COSINES ? truth_cosine[i] : node(i - TRUTH_COSINES), 1.0};
    truth->desc = (struct tsu_i_slab_desc){.layers = truth->layers,
                                           .layer_count = 2,
                                           .slide_top = 1.0,
                                           .slide_bottom = 1.0,
                                           .nodes = 8,
                                           .modes = 16,
                                           .directions = truth->directions,
                                           .direction_count = TRUTH_COSINES + TRUTH_GAUSS};
    truth->memory = malloc(tsu_i_slab_doubles(&truth->desc) * sizeof(double));
    tsu_i_slab_solve(&truth->slab, &truth->desc, truth->memory);
    const struct tsu_i_slab *slab = &truth->slab;
    for (int side = 0; side < 2; side++) {
        double outer = 0.0, straight[2] = {0.0, 0.0};
        for (int i = 0; i < TRUTH_GAUSS; i++) {
            const double mu = node(i), weight = 2.0 * mu * half_weight[i % 4];
            outer += weight * surface(params->n, mu);
            straight[0] +=
                weight * (slab->specular[side][TRUTH_COSINES + i] - surface(params->n, mu));
            straight[1] += weight * slab->direct[side][TRUTH_COSINES + i];
        }
        for (int through = 0; through < 2; through++)
            truth->straight[side][through] =
                straight[through] / (3.14159265358979324 * (1.0 - outer) * (1.0 - outer));
    }
}

void truth_free(struct truth *truth)
{
    free(truth->memory);
}

double truth_value(const struct truth *truth, int side, int through, int in, int out, double phi)
{
    const double f = through
                         ? tsu_i_slab_btdf(&truth->slab, side, (uint32_t)in, (uint32_t)out, phi)
                         : tsu_i_slab_brdf(&truth->slab, side, (uint32_t)in, (uint32_t)out, phi);
    return f + truth->straight[side][through] *
                   (1.0 - surface(truth->layers[0].n, truth->directions[in].mu)) *
                   (1.0 - surface(truth->layers[0].n, truth->directions[out].mu));
}

double truth_power(const struct truth *truth, int side, int through, int in)
{
    return through ? truth->slab.transmittance[side][in]
                   : truth->slab.reflectance[side][in] -
                         surface(truth->layers[0].n, truth->directions[in].mu);
}

double truth_spread(const struct truth *truth, int side, int through, int in)
{
    const struct tsu_i_slab *slab = &truth->slab;
    const double n = truth->layers[0].n;
    double outer = 0.0;
    for (int i = 0; i < TRUTH_GAUSS; i++)
        outer += 2.0 * node(i) * half_weight[i % 4] * surface(n, node(i));
    const double scattered = through ? slab->transmittance[side][in] - slab->direct[side][in]
                                     : slab->reflectance[side][in] - slab->specular[side][in];
    return scattered + truth->straight[side][through] * 3.14159265358979324 * (1.0 - outer) *
                           (1.0 - surface(n, truth->directions[in].mu));
}
