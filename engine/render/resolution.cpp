#include "engine/render/resolution.hpp"

#include <array>
#include <cmath>

namespace zeroset {
namespace {

constexpr std::array scales{1.0, 0.75, 0.5, 0.375, 0.25, 0.1875, 0.125};
constexpr std::size_t unknown_step = 4;
constexpr std::size_t slow_step = scales.size() - 1;

/// Cells of pixels make finer pictures cheaper by the pixel.
constexpr double growth = 0.8;

/// A finer resolution must be sure to fit, a coarser one must be needed.
constexpr double share_that_fits = 0.8;
constexpr double too_slow = 1.2;

/// The weight of a cheaper picture; a dearer one counts at once.
constexpr double weight_of_cheaper = 0.4;

}  // namespace

double ResolutionGovernor::expected_ms(std::size_t pixels) const {
    return known_ ? unit_ms_ * std::pow(static_cast<double>(pixels), growth) : 0.0;
}

void ResolutionGovernor::measured(std::size_t pixels, double ms) {
    const double unit = ms / std::pow(static_cast<double>(pixels), growth);
    const bool cheaper = known_ && unit < unit_ms_;
    unit_ms_ = cheaper ? unit_ms_ + weight_of_cheaper * (unit - unit_ms_) : unit;
    known_ = true;
}

double ResolutionGovernor::choose(std::size_t pixels) {
    if (!known_) {
        step_ = slow_ ? slow_step : unknown_step;
        return scales[step_];
    }
    const auto expected = [&](std::size_t step) {
        return expected_ms(pixels) * std::pow(scales[step], 2 * growth);
    };
    while (step_ + 1 < scales.size() && expected(step_) > too_slow * budget_ms_)
        ++step_;
    while (step_ > 0 && expected(step_ - 1) < share_that_fits * budget_ms_)
        --step_;
    return scales[step_];
}

}  // namespace zeroset
