#include "bench/rows.h"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace tsuya::bench
{

double wall()
{
    const auto time = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::nano>(time).count();
}

double worked()
{
    return double(std::clock()) * (1e9 / CLOCKS_PER_SEC);
}

double median(std::vector<double> values)
{
    if (values.empty()) {
        return 0.0;
    }
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace tsuya::bench
