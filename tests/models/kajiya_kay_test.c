// What Kajiya-Kay states about its errors, measured again: its energy against Marschner's of the
// same fibre, integrated over all light directions.
//
//   kajiya_kay_test      a sample, each measured error must not exceed the stated one
//   kajiya_kay_test N    N times as many materials; with TSUYA_LONG set, 12
#include "sweep.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double pi = 3.14159265358979323846;

// Albedo at a view by the shader's formulas, and of Marschner's reference (whose longitudinal lobes
// integrate to 1, so that its albedo is the sum of its azimuthal energies).
static double albedo(struct sweep *sweep, double *in)
{
    enum { THETAS = 2000 };
    double sum = 0.0, out[3];
    for (int i = 0; i < THETAS; i++) {
        in[0] = ((i + 0.5) / THETAS - 0.5) * pi;
        sweep_table(sweep, 0, in, out);
        sum += out[2] * cos(in[0]);
    }
    return sum * pi / THETAS * 2.0 * pi;
}

static double marschner_albedo(struct sweep *sweep, const double *in)
{
    enum { PHIS = 90 };
    double row[5] = {in[3], in[1], in[4], 30.0 * pi / 180.0, 0}, n[4], sum = 0.0;
    for (int k = 0; k < PHIS; k++) {
        row[4] = (k + 0.5) / PHIS * pi;
        sweep_reference(sweep, tsu_marschner(), 1, row, n);
        sum += n[0] + n[1] + n[2] + n[3];
    }
    return sum * 2.0 * pi / PHIS;
}

static double error_at(struct sweep *sweep, double *in)
{
    return fabs(albedo(sweep, in) / marschner_albedo(sweep, in) - 1.0);
}

// The table of the model's promise: eta 1.55, default roughness.
static double promised(struct sweep *sweep)
{
    static const double sigmas[] = {0.0, 0.05, 0.2, 1.0}, views[] = {0, 30, 60, -30, -60};
    double in[7] = {0, 0, 0, 1.55, 0, -7.5 * pi / 180, 7.5 * pi / 180}, worst = 0.0;
    sweep_material(sweep, tsu_kajiya_kay(), 0, in);
    printf("albedo over Marschner's, sigma_a 0, .05, .2, 1:\n");
    for (int v = 0; v < 5; v++) {
        printf("  view %3.0f ", views[v]);
        for (int s = 0; s < 4; s++) {
            in[1] = views[v] * pi / 180.0;
            in[4] = sigmas[s];
            const double error = error_at(sweep, in);
            printf(" %.4f", error);
            worst = fmax(worst, error);
        }
        printf("\n");
    }
    return worst;
}

static int report(const char *name, double measured, double bound)
{
    const double stated = sweep_stated(tsu_kajiya_kay(), name);
    const int fine = measured <= stated && (bound <= 0.0 || stated <= bound);
    printf("%-22s measured %.5f  stated %.5f%s\n", name, measured, stated,
           fine ? "" : "  <-- too large");
    return fine;
}

int main(int argc, char **argv)
{
    const int scale = argc > 1 ? atoi(argv[1]) : getenv("TSUYA_LONG") ? 12 : 1;
    struct sweep sweep;
    double worst_60 = 0.0, worst_85 = 0.0;
    sweep_open(&sweep, 19890731);
    const double table = promised(&sweep);
    for (int i = 0; i < 60 * scale; i++) {
        double in[7] = {0,
                        0,
                        0,
                        sweep_corner(&sweep, 1.3, 1.8),
                        0,
                        sweep_corner(&sweep, -10, 10) * pi / 180,
                        sweep_corner(&sweep, 5, 20) * pi / 180};
        sweep_material(&sweep, tsu_kajiya_kay(), 0, in);
        in[4] = sweep_corner(&sweep, 0, 5);
        in[1] = sweep_corner(&sweep, -60, 60) * pi / 180;
        worst_60 = fmax(worst_60, error_at(&sweep, in));
        in[1] = sweep_corner(&sweep, -85, 85) * pi / 180;
        worst_85 = fmax(worst_85, error_at(&sweep, in));
    }
    sweep_close(&sweep);
    int fine = report("albedo_default", table, 0.05);
    fine &= report("albedo_60", worst_60, -1);
    fine &= report("albedo_85", worst_85, -1);
    return fine ? 0 : 1;
}
