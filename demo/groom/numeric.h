// Private to the generators of hair, leaves and trees: numbers that come out the same on every machine.
//
// Only + - * / and sqrt on doubles, which IEEE 754 rounds in one way, integer
// random numbers, and polynomials in place of libm's sine and cosine. A fused
// multiply-add would round differently, so contraction is off in every file
// that includes this header; include it first.
#ifndef TSUYA_GROOM_NUMERIC_H
#define TSUYA_GROOM_NUMERIC_H

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#endif

#include <cmath>
#include <cstdint>

namespace tsuya::groom {

constexpr double pi = 3.14159265358979323846;

struct Vec {
    double x = 0.0, y = 0.0, z = 0.0;
};

inline Vec operator+(Vec a, Vec b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec operator-(Vec a, Vec b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec operator*(Vec a, double s)
{
    return {a.x * s, a.y * s, a.z * s};
}
inline Vec operator*(Vec a, Vec b)
{
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
inline Vec operator/(Vec a, Vec b)
{
    return {a.x / b.x, a.y / b.y, a.z / b.z};
}
inline double dot(Vec a, Vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec cross(Vec a, Vec b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec a)
{
    return std::sqrt(dot(a, a));
}
// `a` at length 1, or `instead` when it is too short to have a direction.
inline Vec unit(Vec a, Vec instead)
{
    const double l = length(a);
    return l > 1e-12 ? a * (1.0 / l) : instead;
}
inline Vec mix(Vec a, Vec b, double t)
{
    return a + (b - a) * t;
}
inline double mix(double a, double b, double t)
{
    return a + (b - a) * t;
}
// 0 up to `a`, 1 from `b`, smooth between.
inline double smooth(double a, double b, double x)
{
    double t = (x - a) / (b - a);
    t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    return t * t * (3.0 - 2.0 * t);
}

// Sine of 2 pi `turns`. Domain: |turns| < 1e9. Error: below 1e-11.
inline double sine(double turns)
{
    const double whole = double(std::int64_t(turns < 0.0 ? turns - 0.5 : turns + 0.5));
    double t = turns - whole; // [-0.5, 0.5]
    t = t > 0.25 ? 0.5 - t : t < -0.25 ? -0.5 - t : t;
    const double x = t * (2.0 * pi), y = x * x;
    double s = -1.0 / 1307674368000.0;
    s = s * y + 1.0 / 6227020800.0;
    s = s * y - 1.0 / 39916800.0;
    s = s * y + 1.0 / 362880.0;
    s = s * y - 1.0 / 5040.0;
    s = s * y + 1.0 / 120.0;
    s = s * y - 1.0 / 6.0;
    return x + x * y * s;
}
// Cosine of 2 pi `turns`; as sine().
inline double cosine(double turns)
{
    return sine(turns + 0.25);
}

// 32-bit random numbers with a 64-bit state. Source: PCG32 (XSH RR 64/32).
// Different streams are independent sequences.
class Random
{
  public:
    Random(std::uint64_t seed, std::uint64_t stream) : step_(stream * 2 + 1)
    {
        next();
        state_ += seed;
        next();
    }

    std::uint32_t next()
    {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005u + step_;
        const std::uint32_t x = std::uint32_t(((old >> 18) ^ old) >> 27);
        const std::uint32_t r = std::uint32_t(old >> 59);
        return (x >> r) | (x << ((32 - r) & 31));
    }
    double unit() // [0, 1)
    {
        return double(next()) * (1.0 / 4294967296.0);
    }
    double range(double from, double to)
    {
        return from + (to - from) * unit();
    }
    double bell() // mean 0, in (-1, 1), standard deviation 0.29
    {
        const double a = unit(), b = unit(), c = unit(), d = unit();
        return (a + b + c + d) * 0.5 - 1.0;
    }

  private:
    std::uint64_t state_ = 0;
    std::uint64_t step_;
};

} // namespace tsuya::groom

#endif
