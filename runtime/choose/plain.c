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
    double sum = 1.0;
    for (int n = 14; n > 0; n--)
        sum = 1.0 + sum * r / n;
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
    double sum = 0.0;
    for (int n = 23; n > 0; n -= 2)
        sum = sum * square + 1.0 / n;
    return k * ln2_high + (2.0 * s * sum + k * ln2_low);
}
