// What a measurement says: rows of the long form of tests/bench/results.
#ifndef TSUYA_DEMO_BENCH_ROWS_H
#define TSUYA_DEMO_BENCH_ROWS_H

#include <string>
#include <vector>

namespace tsuya::bench
{

// `key` tells rows of one tier and quantity apart; it may be empty.
struct Row {
    std::string tier, quantity, key;
    double value;
};
using Rows = std::vector<Row>;

// Nanoseconds that a wall clock has gone forward.
double wall();

// Nanoseconds of processor time that the process has used, all threads together: the wall clock of
// one core that nobody else wants. Counts in microseconds.
double worked();

// Samples that worked() resolves to a thousandth.
constexpr double least_sample = 1e6;

// The value in the middle; of an even number the upper one. 0 of nothing.
double median(std::vector<double> values);

} // namespace tsuya::bench

#endif
