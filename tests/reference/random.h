// Random numbers that depend on nothing but a key: the same for any number of threads.
#ifndef TSUYA_TESTS_REFERENCE_RANDOM_H
#define TSUYA_TESTS_REFERENCE_RANDOM_H

#include <cmath>
#include <cstdint>

namespace tsuya::reference {

// Source: PCG32 (XSH RR 64/32), its state and stream from two rounds of SplitMix64 over the key.
class Random
{
  public:
    // Different keys give independent sequences.
    Random(std::uint64_t seed, std::uint64_t pixel, std::uint64_t sample)
    {
        const std::uint64_t key = mixed(seed + mixed(pixel + mixed(sample)));
        step_ = mixed(key) | 1u;
        state_ = key + step_;
        next();
    }

    // [0, 1), 32 random bits.
    double unit()
    {
        return double(next()) * (1.0 / 4294967296.0);
    }

    // Standard normal deviate, within +-6.7. Source: Box and Muller 1958.
    double normal()
    {
        constexpr double two_pi = 6.28318530717958647692;
        const double radius = std::sqrt(-2.0 * std::log(1.0 - unit()));
        return radius * std::cos(two_pi * unit());
    }

  private:
    static std::uint64_t mixed(std::uint64_t x)
    {
        x += 0x9e3779b97f4a7c15u;
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
        return x ^ (x >> 31);
    }

    std::uint32_t next()
    {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005u + step_;
        const std::uint32_t x = std::uint32_t(((old >> 18) ^ old) >> 27);
        const std::uint32_t r = std::uint32_t(old >> 59);
        return (x >> r) | (x << ((32 - r) & 31));
    }

    std::uint64_t state_, step_;
};

} // namespace tsuya::reference

#endif
