// The form that the shader evaluates, fitted to the solution: what has scattered once is put back
// with its phase function exact, all the rest has three azimuthal modes.
#include "models/leaf_body/state.h"

#include "optics/angle.h"

#include <math.h>
#include <string.h>

static const double least = 1e-6; // value at normal incidence, 1/sr

// The phase function over that of isotropic scattering.
static double phase(double cosine)
{
    const double base = 1.0 + LEAF_G * LEAF_G - 2.0 * LEAF_G * cosine;
    return (1.0 - LEAF_G * LEAF_G) / (base * sqrt(base));
}

// P of the form, without the factor 1 - g^2.
static double bare_phase(double cosine)
{
    return phase(cosine) / (1.0 - LEAF_G * LEAF_G);
}

// The cosine outside minus 1, by the cosine inside. With it the form holds squares of 1 - cosine as
// well: the far wall sends light back more and more towards grazing.
static double grazing(double n, double inside)
{
    return sqrt(fmax(1.0 - n * n * (1.0 - inside * inside), 0.0)) - 1.0;
}

void tsu_i_leaf_terms(double n, int set, double u, double v, double z, double terms[LEAF_TERMS])
{
    const double U = 1.0 - u, V = 1.0 - v;
    const int through = set == LEAF_THROUGH;
    const double p = bare_phase(z + (through ? u * v : -u * v));
    terms[0] = 1.0;
    terms[1] = U + V;
    terms[2] = through ? U - V : U * V;
    terms[3] = through ? p * (U - V) : grazing(n, u) + grazing(n, v);
    terms[4] = U * U + V * V;
    terms[5] = z;
    terms[6] = p - 1.0;
    terms[7] = p * (U + V);
}

// Which terms are fitted: the coarse form has four.
static int fitted(uint32_t coarse, int which[LEAF_TERMS])
{
    static const int full[] = {0, 1, 2, 3, 4, 5, 6, 7}, few[] = {0, 1, 2, 6};
    const int count = coarse ? 4 : LEAF_TERMS;
    memcpy(which, coarse ? few : full, (size_t)count * sizeof *which);
    return count;
}

static double sine2(double cosine)
{
    return 1.0 - cosine * cosine;
}

static double azimuth(int k)
{
    return TSU_I_PI * k / (LEAF_AZIMUTHS - 1);
}

void tsu_i_leaf_fitter(const struct leaf_frame *frame, uint32_t coarse, struct leaf_fitter *fitter)
{
    for (int set = 0; set < LEAF_SETS; set++) {
        double rows[LEAF_SAMPLES][LEAF_TERMS], weight[LEAF_SAMPLES];
        double normal[LEAF_TERMS][LEAF_TERMS] = {{0.0}};
        const int count = fitted(coarse, fitter->which[set]);
        for (int s = 0; s < LEAF_SAMPLES; s++) {
            const int i = s / (LEAF_OUTER * LEAF_AZIMUTHS), j = s / LEAF_AZIMUTHS % LEAF_OUTER;
            const int k = s % LEAF_AZIMUTHS;
            const double u = frame->cosine[LEAF_INNER + i], v = frame->cosine[LEAF_INNER + j];
            const double z = sqrt(sine2(u) * sine2(v)) * cos(azimuth(k));
            double terms[LEAF_TERMS];
            tsu_i_leaf_terms(frame->n, set, u, v, z, terms);
            for (int a = 0; a < count; a++)
                rows[s][a] = terms[fitter->which[set][a]];
            weight[s] = (1.0 - frame->reflectance[LEAF_INNER + i]) *
                        (1.0 - frame->reflectance[LEAF_INNER + j]);
            // Straight on and straight back count more: there the form errs most.
            weight[s] *= weight[s] * (k == 0 || k == LEAF_AZIMUTHS - 1 ? 2.0 : 1.0) *
                         (i + j == 2 * (LEAF_OUTER - 1) ? 3.0 : 1.0);
            for (int a = 0; a < count; a++)
                for (int b = 0; b < count; b++)
                    normal[a][b] += weight[s] * rows[s][a] * rows[s][b];
        }
        // Gauss-Jordan: the inverse in place; symmetric and positive.
        for (int k = 0; k < count; k++) {
            const double pivot = 1.0 / normal[k][k];
            normal[k][k] = 1.0;
            for (int b = 0; b < count; b++)
                normal[k][b] *= pivot;
            for (int a = 0; a < count; a++) {
                if (a == k)
                    continue;
                const double factor = normal[a][k];
                normal[a][k] = 0.0;
                for (int b = 0; b < count; b++)
                    normal[a][b] -= factor * normal[k][b];
            }
        }
        for (int a = 0; a < count; a++)
            for (int s = 0; s < LEAF_SAMPLES; s++) {
                double sum = 0.0;
                for (int b = 0; b < count; b++)
                    sum += normal[a][b] * rows[s][b];
                fitter->solver[set][a][s] = sum * weight[s];
            }
        fitter->count[set] = count;
    }
}

// Scattered once on the way back, over P / 4: a layer over another.
static double once_back(const double depth[2], const double albedo[2], double i, double o)
{
    const double x = 1.0 / i + 1.0 / o;
    return (albedo[0] * -expm1(-depth[0] * x) +
            exp(-depth[0] * x) * albedo[1] * -expm1(-depth[1] * x)) /
           (i + o);
}

static double once_through_layer(double depth, double albedo, double i, double o)
{
    const double y = (1.0 / i - 1.0 / o) * depth;
    return albedo * depth * exp(-depth / o) * (fabs(y) < 1e-6 ? 1.0 - 0.5 * y : -expm1(-y) / y) /
           (i * o);
}

static double once_through(const double depth[2], const double albedo[2], double i, double o)
{
    return once_through_layer(depth[0], albedo[0], i, o) * exp(-depth[1] / o) +
           exp(-depth[0] / i) * once_through_layer(depth[1], albedo[1], i, o);
}

// Light that was never scattered (through the leaf, or back from the far wall) is spread as Lambert
// would, so that energy is whole under uniform light: its value over the walls' factors.
static double straight(const struct leaf_frame *frame, const struct leaf_modes *modes, int set)
{
    double power = 0.0, passed = 0.0;
    for (int i = 0; i < LEAF_OUTER; i++) {
        const double t = 1.0 - frame->reflectance[LEAF_INNER + i];
        const double share = 2.0 * frame->outer[i] * frame->outer_weight[i] * t;
        power += share * t * (set == LEAF_THROUGH ? modes->through[i] : modes->back[i]);
        passed += share;
    }
    return power / (TSU_I_PI * passed * passed);
}

void tsu_i_leaf_fit(const struct leaf_frame *frame, const struct leaf_fitter *fitter,
                    const struct leaf_layer layers[2], const struct leaf_modes *modes, int set,
                    float numbers[LEAF_NUMBERS])
{
    double depth[2], albedo[2], values[LEAF_SAMPLES];
    for (int k = 0; k < 2; k++) {
        const struct leaf_layer *layer = layers + (set == LEAF_BELOW ? 1 - k : k);
        const double scatter = layer->scatter / (1.0 - LEAF_G);
        depth[k] = scatter + layer->absorption;
        albedo[k] = depth[k] > 0.0 ? scatter / depth[k] : 0.0;
    }
    const double side = set == LEAF_THROUGH ? 1.0 : -1.0;
    for (int i = 0; i < LEAF_OUTER; i++)
        for (int j = 0; j < LEAF_OUTER; j++) {
            const double u = frame->cosine[LEAF_INNER + i], v = frame->cosine[LEAF_INNER + j];
            const double once = (set == LEAF_THROUGH ? once_through(depth, albedo, v, u)
                                                     : once_back(depth, albedo, v, u)) /
                                (4.0 * TSU_I_PI * frame->n * frame->n);
            const int k = LEAF_OUTER * i + j,
                      nodes = LEAF_NODES * (LEAF_INNER + i) + LEAF_INNER + j;
            double rest[LEAF_MODES];
            for (int m = 0; m < LEAF_MODES; m++)
                rest[m] = modes->f[set][m][k] -
                          (m ? 2.0 : 1.0) * once *
                              (set == LEAF_THROUGH ? frame->onward : frame->back)[m][nodes];
            for (int a = 0; a < LEAF_AZIMUTHS; a++) {
                const double cosine = cos(azimuth(a));
                const double z = sqrt(sine2(u) * sine2(v)) * cosine;
                values[k * LEAF_AZIMUTHS + a] = rest[0] + rest[1] * cosine +
                                                rest[2] * (2.0 * cosine * cosine - 1.0) +
                                                once * phase(z + side * u * v);
            }
        }
    double c[LEAF_TERMS] = {0.0};
    for (int t = 0; t < fitter->count[set]; t++)
        for (int s = 0; s < LEAF_SAMPLES; s++)
            c[fitter->which[set][t]] += fitter->solver[set][t][s] * values[s];
    const double first = fmax(c[0] + straight(frame, modes, set), least);
    numbers[0] = (float)log2(first);
    for (int t = 1; t < LEAF_TERMS; t++)
        numbers[t] = (float)(c[t] / first);
    if (fitter->count[set] < LEAF_TERMS) {
        // The coarse form has all of its terms in texel A.
        numbers[3] = numbers[6];
        numbers[6] = 0.0f;
    }
}
