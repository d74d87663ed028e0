// binary16 against a construction of its own: the value of every half from the format's definition
// in double, and rounding by comparing distances.
#include "base/half.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

// Value of a half from IEEE 754: (-1)^s 2^(e-15) (1 + m/1024), subnormals 2^-14 m/1024.
static double value_of(uint16_t half)
{
    const int exponent = half >> 10 & 31, mantissa = half & 1023;
    const double sign = half & 0x8000 ? -1.0 : 1.0;
    if (exponent == 31)
        return mantissa ? NAN : sign * INFINITY;
    if (exponent == 0)
        return sign * ldexp(mantissa, -24);
    return sign * ldexp(1024 + mantissa, exponent - 25);
}

static uint32_t bits(float value)
{
    uint32_t b;
    memcpy(&b, &value, sizeof b);
    return b;
}

static void widening_is_exact(void **state)
{
    (void)state;
    for (uint32_t h = 0; h < 65536; h++) {
        const double expected = value_of((uint16_t)h);
        const float got = tsu_i_half_float((uint16_t)h);
        if (isnan(expected))
            assert_true(isnan(got));
        else if ((double)got != expected || !signbit(got) != !signbit(expected))
            fail_msg("half 0x%04x is %g, not %g", h, (double)got, expected);
    }
}

static void every_half_comes_back(void **state)
{
    (void)state;
    for (uint32_t h = 0; h < 65536; h++) {
        const uint16_t back = tsu_i_half(tsu_i_half_float((uint16_t)h));
        if (isnan(value_of((uint16_t)h))) {
            assert_true(isnan(value_of(back)));
            assert_int_equal(back & 0x8000, h & 0x8000);
        } else {
            assert_int_equal(back, h);
        }
    }
}

// The nearest half of a float in [low, next half above low], ties to the even one.
static uint16_t nearest(double value, uint16_t low)
{
    const uint16_t high = (uint16_t)(low + 1);
    // Past the largest half the format rounds as if one more binade were there.
    const double above = high == 0x7c00 ? 65536.0 : value_of(high);
    const double to_low = value - value_of(low), to_high = above - value;
    if (to_low == to_high)
        return low & 1 ? high : low;
    return to_low < to_high ? low : high;
}

static void rounds_to_nearest_even_around_every_midpoint(void **state)
{
    (void)state;
    for (uint32_t h = 0; h < 0x7c00; h++) {
        const uint16_t low = (uint16_t)h;
        const double above = h == 0x7bff ? 65536.0 : value_of((uint16_t)(h + 1));
        const float middle = (float)(0.5 * (value_of(low) + above));
        const float at[5] = {nextafterf((float)value_of(low), INFINITY),
                             nextafterf(middle, -INFINITY), middle, nextafterf(middle, INFINITY),
                             nextafterf((float)above, -INFINITY)};
        for (int i = 0; i < 5; i++) {
            const uint16_t expected = nearest((double)at[i], low);
            const uint16_t plus = tsu_i_half(at[i]), minus = tsu_i_half(-at[i]);
            if (plus != expected || minus != (expected | 0x8000))
                fail_msg("%.9g (0x%08x) gives 0x%04x and 0x%04x, not 0x%04x", (double)at[i],
                         bits(at[i]), plus, minus, expected);
        }
    }
}

static void floats_outside_the_range(void **state)
{
    (void)state;
    assert_int_equal(tsu_i_half(65519.996f), 0x7bff); // the last float that rounds down
    assert_int_equal(tsu_i_half(65520.0f), 0x7c00);
    assert_int_equal(tsu_i_half(3.4e38f), 0x7c00);
    assert_int_equal(tsu_i_half(-3.4e38f), 0xfc00);
    assert_int_equal(tsu_i_half(INFINITY), 0x7c00);
    assert_int_equal(tsu_i_half(-INFINITY), 0xfc00);
    assert_int_equal(tsu_i_half(0.0f), 0x0000);
    assert_int_equal(tsu_i_half(-0.0f), 0x8000);
    assert_int_equal(tsu_i_half(1e-45f), 0x0000); // a subnormal float
    assert_int_equal(tsu_i_half(-1e-45f), 0x8000);
    assert_int_equal(tsu_i_half(ldexpf(1, -25)), 0x0000); // half a step, ties to even
    assert_int_equal(tsu_i_half(nextafterf(ldexpf(1, -25), 1)), 0x0001);
}

static void nan_stays_nan(void **state)
{
    (void)state;
    const uint32_t patterns[] = {0x7f800001u, 0x7fc00000u, 0x7fffffffu, 0xff800001u, 0xffc01234u};
    for (size_t i = 0; i < sizeof patterns / sizeof *patterns; i++) {
        float f;
        memcpy(&f, patterns + i, sizeof f);
        const uint16_t h = tsu_i_half(f);
        assert_int_equal(h & 0x7c00, 0x7c00);
        assert_int_not_equal(h & 0x03ff, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(widening_is_exact),
        cmocka_unit_test(every_half_comes_back),
        cmocka_unit_test(rounds_to_nearest_even_around_every_midpoint),
        cmocka_unit_test(floats_outside_the_range),
        cmocka_unit_test(nan_stays_nan),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
