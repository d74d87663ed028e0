// What the leaf under its coat promises: the coat against a brute-force integral, energy of a leaf
// without absorption in uniform light, reciprocity, and that extremes stay finite.
//
//   leaf_test [N]       N times as many leaves; with TSUYA_LONG set, 8
#include "sweep.h"

#include <tsuya/models/leaf.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

enum { MU0 = 6, MU, PHI, KIND, SIDE, ABSORPTION, THICKNESS, ROUGHNESS, COLUMNS };
enum { SPECULAR, REFLECTED, TRANSMITTED };

static void material(struct sweep *sweep, const tsu_leaf_params *params)
{
    uint32_t index;
    tsu_set_destroy(sweep->set);
    tsu_set_desc desc;
    tsu_set_desc_init(&desc);
    if (tsu_set_create(sweep->context, &desc, &sweep->set) != TSU_OK ||
        tsu_set_add(sweep->set, tsu_leaf(), params, &index) != TSU_OK ||
        tsu_set_bake(sweep->set) != TSU_OK)
        abort();
}

static void ask(struct sweep *sweep, double *in, double mu0, double mu, double phi, double out[3])
{
    in[MU0] = mu0;
    in[MU] = mu;
    in[PHI] = phi;
    sweep_table(sweep, 0, in, out);
}

static const double plain[COLUMNS] = {0, 1, 0.1, 0.1, 0.1, 1.45, 1, 1, 0, 0, 0, 1, 1, 0.35};

// Shares of light from one cosine: specular, reflected, transmitted. The highlight wants many
// nodes.
static void powers(struct sweep *sweep, int side, double mu0, double out[3])
{
    enum { COSINES = 96, PHIS = 96 };
    double in[COLUMNS], f[3];
    memcpy(in, plain, sizeof in);
    in[SIDE] = side;
    out[0] = out[1] = out[2] = 0.0;
    for (int kind = 0; kind < 2; kind++)
        for (int i = 0; i < COSINES; i++)
            for (int k = 0; k < PHIS; k++) {
                const double mu = (i + 0.5) / COSINES;
                in[KIND] = kind;
                ask(sweep, in, mu0, mu, (k + 0.5) * pi / PHIS, f);
                for (int lobe = 0; lobe < 3; lobe++)
                    out[lobe] += f[lobe] * mu * 2.0 * pi / (COSINES * PHIS);
            }
}

// Fresnel by its two polarisations, and the coat by its definition in plain angles.
static double fresnel(double n, double cosine)
{
    const double i = acos(fmin(cosine, 1.0)), t = asin(sin(i) / n);
    if (i < 1e-6)
        return (n - 1.0) * (n - 1.0) / ((n + 1.0) * (n + 1.0));
    const double s = sin(i - t) / sin(i + t), p = tan(i - t) / tan(i + t);
    return 0.5 * (s * s + p * p);
}

static double smith(double alpha, double cosine)
{
    const double tangent2 = 1.0 / (cosine * cosine) - 1.0;
    return 0.5 * (sqrt(1.0 + alpha * alpha * tangent2) - 1.0);
}

static double coat(double n, double alpha, double mu0, double mu, double phi)
{
    const double s0 = sqrt(1.0 - mu0 * mu0), s = sqrt(1.0 - mu * mu);
    // phi 0 is the mirror's side: light travels along +x, the viewer is there.
    const double h[3] = {-s0 + s * cos(phi), s * sin(phi), mu0 + mu};
    const double length = sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
    const double n_h = h[2] / length, l_h = (-s0 * h[0] + mu0 * h[2]) / length;
    const double tangent2 = 1.0 / (n_h * n_h) - 1.0, a2 = alpha * alpha;
    const double d =
        1.0 / (pi * a2 * n_h * n_h * n_h * n_h * (1.0 + tangent2 / a2) * (1.0 + tangent2 / a2));
    const double g = 1.0 / (1.0 + smith(alpha, mu0) + smith(alpha, mu));
    return fresnel(n, l_h) * d * g / (4.0 * mu0 * mu);
}

static int report(const char *name, double measured, double bound)
{
    const double stated = sweep_stated(tsu_leaf(), name);
    const int fine = measured <= stated && (bound <= 0.0 || stated <= bound);
    printf("%-14s measured %.5f  stated %.5f%s\n", name, measured, stated,
           fine ? "" : "  <-- too large");
    return fine;
}

static void white(tsu_leaf_params *params)
{
    for (int c = 0; c < 3; c++)
        params->absorption_top[c] = params->absorption_bottom[c] = 0.0f;
}

// Directional and whole energy of a leaf without absorption.
static void energy(struct sweep *sweep, double *one, double *all)
{
    enum { COSINES = 6 };
    for (int side = 0; side < 2; side++) {
        double whole = 0.0;
        for (int i = 0; i < COSINES; i++) {
            // Gauss-Legendre on [0, 1].
            static const double x[3] = {0.238619186083196909, 0.661209386466264514,
                                        0.932469514203152028};
            static const double w[3] = {0.467913934572691047, 0.360761573048138608,
                                        0.171324492379170345};
            const double mu = 0.5 + (i % 2 ? 0.5 : -0.5) * x[i / 2];
            double share[3];
            powers(sweep, side, mu, share);
            const double sum = share[0] + share[1] + share[2];
            whole += sum * mu * w[i / 2];
            *one = fmax(*one, fabs(sum - 1.0));
        }
        *all = fmax(*all, fabs(whole - 1.0));
    }
}

static double exchange(struct sweep *sweep)
{
    double worst = 0.0, in[COLUMNS], a[3], b[3];
    memcpy(in, plain, sizeof in);
    for (int k = 0; k < 200; k++) {
        const double mu0 = sweep_between(sweep, 0.02, 1.0), mu = sweep_between(sweep, 0.02, 1.0);
        const double phi = sweep_between(sweep, 0.0, pi);
        in[KIND] = k % 2;
        in[SIDE] = k / 2 % 2;
        ask(sweep, in, mu0, mu, phi, a);
        in[SIDE] = k % 2 ? 1.0 - in[SIDE] : in[SIDE]; // through: the other way from the other side
        ask(sweep, in, mu, mu0, phi, b);
        for (int lobe = 0; lobe < 3; lobe++)
            worst = fmax(worst, fabs(a[lobe] - b[lobe]) / (fabs(a[lobe]) + 1e-6));
    }
    return worst;
}

// Corners of every range: finite, not negative, no more than all light.
static int extremes(struct sweep *sweep)
{
    static const float scatters[] = {0.0f, 1e-4f, 2.0f, 50.0f}, absorptions[] = {0.0f, 1.0f, 1e6f};
    static const float indices[] = {1.2f, 1.8f}, roughness[] = {0.05f, 1.0f};
    double most = 0.0;
    int bad = 0;
    for (int i = 0; i < 48; i++) {
        tsu_leaf_params params;
        tsu_leaf_params_init(&params);
        params.n = indices[i % 2];
        params.roughness = roughness[i / 2 % 2];
        for (int c = 0; c < 3; c++) {
            params.scatter_top[c] = params.scatter_bottom[c] = scatters[i / 4 % 4];
            params.absorption_top[c] = params.absorption_bottom[c] = absorptions[i / 16];
        }
        material(sweep, &params);
        for (int k = 0; k < 400; k++) {
            double in[COLUMNS], out[3], sum;
            memcpy(in, plain, sizeof in);
            in[KIND] = k % 2;
            in[SIDE] = k / 2 % 2;
            in[ABSORPTION] = k % 3;
            in[THICKNESS] = k % 5 < 2 ? 0.5 : 2.0;
            ask(sweep, in, sweep_corner(sweep, 1e-3, 1.0), sweep_corner(sweep, 1e-3, 1.0),
                sweep_corner(sweep, 0.0, pi), out);
            sum = out[0] + out[1] + out[2];
            bad += !isfinite(sum) || out[0] < 0.0 || out[1] < 0.0 || out[2] < 0.0;
        }
        double share[3];
        powers(sweep, 0, 0.5, share);
        if (share[0] + share[1] + share[2] > 1.02)
            printf("extreme %d: %g %g %g\n", i, share[0], share[1], share[2]);
        most = fmax(most, share[0] + share[1] + share[2]);
    }
    printf("extremes: %d bad values, largest share of light %.4f\n", bad, most);
    return bad == 0 && most <= 1.02;
}

int main(int argc, char **argv)
{
    const int scale = argc > 1 ? atoi(argv[1]) : getenv("TSUYA_LONG") ? 8 : 1;
    struct sweep sweep;
    double specular = 0.0, one = 0.0, all = 0.0, reciprocity = 0.0;
    sweep_open(&sweep, 20070625);
    for (int i = 0; i < 4 * scale; i++) {
        tsu_leaf_params params;
        tsu_leaf_params_init(&params);
        params.n = (float)sweep_corner(&sweep, 1.35, 1.55);
        params.roughness = (float)sweep_corner(&sweep, 0.15, 0.8);
        for (int c = 0; c < 3; c++)
            params.scatter_bottom[c] = (float)sweep_corner(&sweep, 1.0, 5.0);
        material(&sweep, &params);
        for (int k = 0; k < 500; k++) {
            double in[COLUMNS], out[3];
            memcpy(in, plain, sizeof in);
            const double mu0 = sweep_between(&sweep, 0.02, 1.0),
                         mu = sweep_between(&sweep, 0.02, 1);
            const double phi = sweep_between(&sweep, 0.0, pi);
            ask(&sweep, in, mu0, mu, phi, out);
            const double exact = coat(params.n, params.roughness, mu0, mu, phi);
            specular = fmax(specular, fabs(out[SPECULAR] - exact) / exact);
        }
        reciprocity = fmax(reciprocity, exchange(&sweep));
        white(&params);
        material(&sweep, &params);
        energy(&sweep, &one, &all);
    }
    int fine = extremes(&sweep);
    sweep_close(&sweep);
    fine &= report("specular", specular, 0.01);
    fine &= report("energy", all, 0.005);
    fine &= report("energy_view", one, -1);
    fine &= report("reciprocity", reciprocity, 0.001);
    return fine ? 0 : 1;
}
