// What a lobe is worth: the light that is lost when the text leaves it out, as rows
// `tier,quantity,key,value` of the trade table.
//
//   bench_lobes > results/lobes.csv
//
// Double precision throughout: the fibre's own attenuations (optics/fiber.h) and the closed form of
// multiple scattering (optics/two_stream.h) in slabs drawn fibre by fibre (optics/fiber_slab.h).
#include "optics/angle.h"
#include "optics/fiber_slab.h"

#include <math.h>
#include <stdio.h>

enum { SIGMAS = 8, DEPTHS = 9 };
static const double sigmas[SIGMAS] = {0.0, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0};
static const double depths[DEPTHS] = {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 64.0};
static const double degree = TSU_I_PI / 180.0;

static void row(const char *quantity, const char *key, double value)
{
    printf("*,%s,%s,%.4f\n", quantity, key, value);
}

struct share {
    double most, sum;
    int count;
};

// Over inclinations from..to by 5 degrees.
static void add(struct share *share, int lobe, double eta, double sigma_a, int from, int to)
{
    for (int theta = from; theta <= to; theta += 5) {
        double a[TSU_I_LOBES];
        tsu_i_fiber_attenuation(eta, degree * theta, sigma_a, a);
        const double value = a[lobe] / (a[0] + a[1] + a[2] + a[3]);
        share->most = fmax(share->most, value);
        share->sum += value;
        share->count++;
    }
}

static void fiber_lobe(const char *name, int lobe)
{
    for (int s = 0; s < SIGMAS; s++) {
        char key[32];
        snprintf(key, sizeof key, "%s/%g", name, sigmas[s]);
        struct share here = {0}, grazing = {0}, range = {0};
        add(&here, lobe, 1.55, sigmas[s], 0, 60);
        add(&grazing, lobe, 1.55, sigmas[s], 60, 85);
        for (int eta = 0; eta <= 5; eta++)
            add(&range, lobe, 1.3 + 0.1 * eta, sigmas[s], 0, 60);
        row("lobe_share", key, here.most);
        row("lobe_share_mean", key, here.sum / here.count);
        row("lobe_share_grazing", key, grazing.most);
        row("lobe_share_any_eta", key, range.most);
    }
}

static struct tsu_i_fields whole(const void *stream, double front, double behind, double direct)
{
    return tsu_i_two_stream_fields(stream, front, behind, direct);
}

static struct tsu_i_fields dropped(const void *stream, double front, double behind, double direct)
{
    struct tsu_i_fields fields = tsu_i_two_stream_fields(stream, front, behind, direct);
    fields.same = 0.0;
    return fields;
}

// Share of the light that a slab reflects, view along its normal.
static double back(double sigma_a, double depth)
{
    struct tsu_i_strand strand = {.eta = 1.55,
                                  .sigma_a = sigma_a,
                                  .beta_az = 10.0 * degree,
                                  .kind = TSU_I_STRAND_DEON,
                                  .lobes = 4};
    static const double shifts[TSU_I_LOBES] = {1.0, -0.5, -1.5, -2.5};
    static const double widths[TSU_I_LOBES] = {1.0, 0.5, 2.0, 2.0};
    for (int p = 0; p < TSU_I_LOBES; p++) {
        strand.alpha[p] = -7.5 * degree * shifts[p];
        strand.beta[p] = 7.5 * degree * widths[p];
    }
    double c[TSU_I_FIBER_ORDERS][TSU_I_LOBES], sum[TSU_I_FIBER_ORDERS], r[2], t;
    struct tsu_i_event event;
    const int orders = tsu_i_strand_cosines(&strand, 0.0, c);
    tsu_i_strand_halves(orders, c, &event);
    for (int k = 0; k < orders; k++)
        sum[k] = c[k][0] + c[k][1] + c[k][2] + c[k][3];
    const struct tsu_i_turn turn = tsu_i_strand_turn(&event);
    const struct tsu_i_stream stream =
        tsu_i_two_stream(&turn, strand.eta, tsu_i_two_stream_gamma(strand.eta, strand.beta_az));
    tsu_i_fiber_slab(orders, sum, whole, &stream, depth, r, &t);
    tsu_i_fiber_slab(orders, sum, dropped, &stream, depth, r + 1, &t);
    return (r[0] - r[1]) / r[0];
}

int main(void)
{
    printf("# Light lost with a lobe, written by bench_lobes. Default fibre (eta 1.55, beta_az 10\n"
           "# degrees). trt, residual: share of what one fibre scatters, key LOBE/SIGMA_A; "
           "lobe_share\n"
           "# is the most over theta 0 to 60 degrees, _mean the mean there, _grazing the most over "
           "60\n"
           "# to 85, _any_eta the most to 60 over eta 1.3 to 1.8. back: share of what a slab of N\n"
           "# fibres reflects, key back/N (the most over sigma_a) and back/N/SIGMA_A.\n"
           "tier,quantity,key,value\n");
    fiber_lobe("trt", TSU_I_TRT);
    fiber_lobe("residual", TSU_I_RES);
    for (int d = 0; d < DEPTHS; d++) {
        char key[48];
        double most = 0.0, share[SIGMAS];
        for (int s = 0; s < SIGMAS; s++) {
            share[s] = back(sigmas[s], depths[d]);
            most = fmax(most, share[s]);
        }
        snprintf(key, sizeof key, "back/%g", depths[d]);
        row("lobe_share", key, most);
        for (int s = 0; s < SIGMAS; s++) {
            snprintf(key, sizeof key, "back/%g/%g", depths[d], sigmas[s]);
            row("lobe_share", key, share[s]);
        }
    }
    return 0;
}
