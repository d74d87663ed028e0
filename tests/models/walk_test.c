// The random walk against figures made by other hands, and its energy.
#include "slab_truth.h"
#include "walk.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double degree = 0.0174532925199432958;
static int failures;

static void hold(const char *what, double value, double bound)
{
    const int good = value <= bound;
    printf("%-60s %.5f (bound %.5f)%s\n", what, value, bound, good ? "" : "  FAILED");
    failures += !good;
}

static struct walk_fiber default_fiber(double sigma_a, int lobe)
{
    return (struct walk_fiber){1.55,         sigma_a, 10.0 * degree, -7.5 * degree,
                               7.5 * degree, 0.0,     lobe};
}

// Both have errors: the difference in units of their sum's deviation.
static void against_truth(long walks)
{
    double square = 0.0, largest = 0.0;
    int count = 0;
    for (size_t i = 0; i < sizeof slab_truth / sizeof *slab_truth; i++) {
        const struct slab_truth *t = slab_truth + i;
        const struct walk_fiber fiber = default_fiber(t->sigma_a, WALK_GAUSSIAN);
        const double tau = t->tau > 0 ? t->tau : 1e9;
        struct walk_slab slab;
        walk(&fiber, t->theta_deg * degree, 1, &tau, walks, 17 * i + 5, &slab);
        for (int k = 0; k < (t->tau > 0 ? 2 : 1); k++) {
            const double z = k ? (slab.t - t->t) / hypot(slab.t_se, t->t_se)
                               : (slab.r - t->r) / hypot(slab.r_se, t->r_se);
            square += z * z;
            largest = fmax(largest, fabs(z));
            count++;
        }
    }
    hold("walk against the truth: rms z", sqrt(square / count), 1.25);
    hold("largest z", largest, 4.0);
}

// A walk among white fibres ends on one side or the other, whatever the lobe.
static void energy(void)
{
    const double taus[3] = {0.5, 2.0, 8.0};
    double worst = 0.0, differ = 0.0;
    for (int i = 0; i < 6; i++) {
        const struct walk_fiber own = default_fiber(0.0, WALK_OWN);
        const struct walk_fiber gaussian = default_fiber(0.0, WALK_GAUSSIAN);
        struct walk_slab a[3], b[3];
        walk(&own, (30.0 * i - 75.0) * degree, 3, taus, 20000, (uint64_t)i, a);
        walk(&gaussian, (30.0 * i - 75.0) * degree, 3, taus, 20000, (uint64_t)i + 100, b);
        for (int k = 0; k < 3; k++) {
            worst = fmax(worst, fmax(fabs(a[k].r + a[k].t - 1.0), fabs(b[k].r + b[k].t - 1.0)));
            differ = fmax(differ, fabs(a[k].r - b[k].r));
        }
    }
    hold("white slabs: R + T from 1", worst, 1e-12);
    // The lobes have the same shift and width, and N decides how much turns back.
    hold("R of the two lobes' fibres, difference", differ, 0.03);
}

int main(void)
{
    against_truth(getenv("TSUYA_LONG") ? 400000 : 30000);
    energy();
    return failures != 0;
}
