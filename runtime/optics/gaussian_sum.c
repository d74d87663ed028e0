#include "optics/gaussian_sum.h"

#include "optics/angle.h"

#include <math.h>
#include <string.h>

enum { COUNT = TSU_I_GAUSSIANS, SAMPLES = TSU_I_GAUSSIAN_SAMPLES };

// Least squares of one ladder, as normal equations: the same matrix for all profiles.
struct ladder {
    int count;
    double column[COUNT][SAMPLES], product[COUNT][COUNT];
};

// Totals weigh more than other samples: they are scaled to be exact in the end.
static double importance(int sample)
{
    return sample == 0 ? 4.0 : 1.0;
}

static void make_ladder(struct ladder *ladder, const struct tsu_i_transforms *t, int count,
                        const double *variance)
{
    ladder->count = count;
    for (int j = 0; j < count; j++)
        for (int i = 0; i < t->samples; i++)
            ladder->column[j][i] = exp(-0.5 * variance[j] * t->k[i] * t->k[i]);
    for (int j = 0; j < count; j++)
        for (int l = 0; l < count; l++) {
            ladder->product[j][l] = 0.0;
            for (int i = 0; i < t->samples; i++)
                ladder->product[j][l] +=
                    importance(i) * ladder->column[j][i] * ladder->column[l][i];
        }
}

// Solve for the Gaussians of `chosen` (bits) by Cholesky; 0 when one of them is not positive.
static int solve_chosen(const struct ladder *ladder, const double *right, unsigned chosen,
                        double *weight)
{
    int index[COUNT], n = 0;
    double l[COUNT][COUNT], x[COUNT];
    for (int j = 0; j < ladder->count; j++) {
        weight[j] = 0.0;
        if (chosen >> j & 1u)
            index[n++] = j;
    }
    for (int i = 0; i < n; i++) {
        for (int j = 0; j <= i; j++) {
            double sum = ladder->product[index[i]][index[j]];
            for (int k = 0; k < j; k++)
                sum -= l[i][k] * l[j][k];
            if (i == j && !(sum > 1e-13 * ladder->product[index[i]][index[i]]))
                return 0;
            l[i][j] = i == j ? sqrt(sum) : sum / l[j][j];
        }
        x[i] = right[index[i]];
        for (int k = 0; k < i; k++)
            x[i] -= l[i][k] * x[k];
        x[i] /= l[i][i];
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++)
            x[i] -= l[k][i] * x[k];
        x[i] /= l[i][i];
        if (!(x[i] > 0.0))
            return 0;
        weight[index[i]] = x[i];
    }
    return 1;
}

// Non-negative least squares: with so few unknowns every set of positive ones is tried. Returns the
// sum of squares.
static double solve_ladder(const struct ladder *ladder, int samples, const double *value,
                           double *weight)
{
    double right[COUNT], square = 0.0, best = INFINITY, tried[COUNT];
    for (int i = 0; i < samples; i++)
        square += importance(i) * value[i] * value[i];
    for (int j = 0; j < ladder->count; j++) {
        right[j] = 0.0;
        for (int i = 0; i < samples; i++)
            right[j] += importance(i) * ladder->column[j][i] * value[i];
    }
    for (unsigned chosen = 1; chosen < 1u << ladder->count; chosen++) {
        if (!solve_chosen(ladder, right, chosen, tried))
            continue;
        double rest = square;
        for (int j = 0; j < ladder->count; j++)
            rest -= tried[j] * right[j];
        if (rest < best) {
            best = rest;
            memcpy(weight, tried, sizeof tried);
        }
    }
    return fmax(best, 0.0);
}

// Sum of squares over all profiles for standard deviations first, first * ratio, ...
static double try_ladder(const struct tsu_i_transforms *t, int count, double first, double ratio,
                         struct tsu_i_gaussians *out)
{
    struct ladder ladder;
    double variance[COUNT], weight[COUNT], value[SAMPLES], sum = 0.0;
    for (int j = 0; j < count; j++)
        variance[j] = pow(first * pow(ratio, j), 2.0);
    make_ladder(&ladder, t, count, variance);
    for (int p = 0; p < t->profiles; p++) {
        const double total = t->value[p][0];
        struct tsu_i_gaussians *g = out + p;
        *g = (struct tsu_i_gaussians){.count = count};
        memcpy(g->variance, variance, sizeof variance);
        if (!(total > 0.0))
            continue;
        for (int i = 0; i < t->samples; i++)
            value[i] = t->value[p][i] / total;
        memset(weight, 0, sizeof weight);
        sum += solve_ladder(&ladder, t->samples, value, weight);
        double all = 0.0;
        for (int j = 0; j < count; j++)
            all += weight[j];
        for (int j = 0; j < count; j++)
            g->weight[j] = weight[j] * total / all;
    }
    return sum;
}

struct search {
    const struct tsu_i_transforms *transforms;
    struct tsu_i_gaussians *out;
    int count;
    double least, most, best, first, ratio;
};

// Ladders about (first, ratio), both in steps of a factor, `reach` steps to either side.
static void search_around(struct search *s, double first, double ratio, double first_step,
                          double ratio_step, int reach)
{
    const int ratios = s->count > 1 ? reach : 0;
    for (int a = -reach; a <= reach; a++)
        for (int b = -ratios; b <= ratios; b++) {
            const double f = first * pow(first_step, a), q = ratio * pow(ratio_step, b);
            if (f < s->least || q < 1.2 || f * pow(q, s->count - 1) > s->most * (1.0 + 1e-9))
                continue;
            const double sum = try_ladder(s->transforms, s->count, f, q, s->out);
            if (sum < s->best) {
                s->best = sum;
                s->first = f;
                s->ratio = q;
            }
        }
}

double tsu_i_gaussians_fit(const struct tsu_i_transforms *transforms, int count, double least,
                           double most, struct tsu_i_gaussians *out)
{
    struct search s = {transforms, out, count, least, most, INFINITY, least, 1.2};
    double first_step = pow(most / least, 1.0 / 24.0), ratio_step = 1.12;
    search_around(&s, sqrt(most * least), 2.8, first_step, ratio_step, 12);
    for (int i = 0; i < 3; i++) {
        first_step = sqrt(first_step);
        ratio_step = sqrt(ratio_step);
        search_around(&s, s.first, s.ratio, first_step, ratio_step, 2);
    }
    const double first = s.first, ratio = s.ratio;
    try_ladder(transforms, count, first, ratio, out);
    double worst = 0.0;
    for (int p = 0; p < transforms->profiles; p++)
        for (int i = 0; i < transforms->samples && transforms->value[p][0] > 0.0; i++)
            worst = fmax(worst, fabs(tsu_i_gaussians_transform(out + p, transforms->k[i]) -
                                     transforms->value[p][i]) /
                                    transforms->value[p][0]);
    return worst;
}

double tsu_i_gaussians_profile(const struct tsu_i_gaussians *sum, double r)
{
    double value = 0.0;
    for (int j = 0; j < sum->count; j++)
        value += sum->weight[j] * exp(-0.5 * r * r / sum->variance[j]) /
                 (2.0 * TSU_I_PI * sum->variance[j]);
    return value;
}

double tsu_i_gaussians_transform(const struct tsu_i_gaussians *sum, double k)
{
    double value = 0.0;
    for (int j = 0; j < sum->count; j++)
        value += sum->weight[j] * exp(-0.5 * k * k * sum->variance[j]);
    return value;
}

double tsu_i_gaussians_within(const struct tsu_i_gaussians *sum, double straight, double r)
{
    double inside = straight, all = straight;
    for (int j = 0; j < sum->count; j++) {
        inside -= sum->weight[j] * expm1(-0.5 * r * r / sum->variance[j]);
        all += sum->weight[j];
    }
    return all > 0.0 ? inside / all : 0.0;
}

double tsu_i_gaussians_radius(const struct tsu_i_gaussians *sum, double straight, double share)
{
    double all = straight;
    for (int j = 0; j < sum->count; j++)
        all += sum->weight[j];
    if (!(all > 0.0) || straight >= share * all)
        return 0.0;
    double low = 0.0, high = 20.0 * sqrt(sum->variance[sum->count - 1]);
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        *(tsu_i_gaussians_within(sum, straight, middle) < share ? &low : &high) = middle;
    }
    return 0.5 * (low + high);
}

double tsu_i_gaussians_strip(const struct tsu_i_gaussians *sum, double strip)
{
    double inside = 0.0, all = 0.0;
    for (int j = 0; j < sum->count; j++) {
        const double sigma = sqrt(sum->variance[j]), t = strip / sigma;
        inside += sum->weight[j] * sigma *
                  (0.5 * t * erfc(t * sqrt(0.5)) - expm1(-0.5 * t * t) / sqrt(2.0 * TSU_I_PI));
        all += sum->weight[j];
    }
    return all > 0.0 ? inside / (all * strip) : 0.0;
}

double tsu_i_gaussians_spill(const struct tsu_i_gaussians *sum)
{
    double spill = 0.0, all = 0.0;
    for (int j = 0; j < sum->count; j++) {
        spill += sum->weight[j] * sqrt(sum->variance[j] / (2.0 * TSU_I_PI));
        all += sum->weight[j];
    }
    return all > 0.0 ? spill / all : 0.0;
}
