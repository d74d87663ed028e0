#include "choose/plain.h"

#include <stdint.h>
#include <string.h>

static const double ln2_high = 0x1.62e42fefa38p-1, ln2_low = 0x1.ef35793c7673p-45;

double tsu_i_plain_exp(double x)
{
    x = x < -80.0 ? -80.0 : x > 80.0 ? 80.0 : x;
    const double whole = x * 1.4426950408889634;
    const int k = (int)(whole < 0.0 ? whole - 0.5 : whole + 0.5);
    const double r = x - k * ln2_high - k * ln2_low; // within +-0.35
    static const double factorial[] = {1.0,
                                       1.0,
                                       1.0 / 2.0,
                                       1.0 / 6.0,
                                       1.0 / 24.0,
                                       1.0 / 120.0,
                                       1.0 / 720.0,
                                       1.0 / 5040.0,
                                       1.0 / 40320.0,
                                       1.0 / 362880.0,
                                       1.0 / 3628800,
                                       1.0 / 39916800,
                                       1.0 / 479001600,
                                       1.0 / 6227020800,
                                       1.0 / 87178291200};
    double sum = factorial[14];
    for (int n = 13; n >= 0; n--)
        sum = sum * r + factorial[n];
    const uint64_t bits = (uint64_t)(1023 + k) << 52;
    double scale;
    memcpy(&scale, &bits, sizeof scale);
    return sum * scale;
}

double tsu_i_plain_log(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    int k = (int)(bits >> 52 & 0x7ff) - 1023;
    bits = (bits & 0xfffffffffffffu) | 0x3ff0000000000000u;
    double m;
    memcpy(&m, &bits, sizeof m);
    if (m > 1.4142135623730951) {
        m *= 0.5;
        k++;
    }
    const double s = (m - 1.0) / (m + 1.0), square = s * s; // |s| up to 0.172
    static const double odd[] = {1.0,        1.0 / 3.0,  1.0 / 5.0,  1.0 / 7.0,
                                 1.0 / 9.0,  1.0 / 11.0, 1.0 / 13.0, 1.0 / 15.0,
                                 1.0 / 17.0, 1.0 / 19.0, 1.0 / 21.0, 1.0 / 23.0};
    double sum = odd[11];
    for (int n = 10; n >= 0; n--)
        sum = sum * square + odd[n];
    return k * ln2_high + (2.0 * s * sum + k * ln2_low);
}
