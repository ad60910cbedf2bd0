#include "engine/base/clock.hpp"

namespace zeroset {

std::chrono::steady_clock::time_point until_after(std::chrono::steady_clock::time_point start,
                                                  double seconds) {
    using Clock = std::chrono::steady_clock;
    return start +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

double ms_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

}  // namespace zeroset
