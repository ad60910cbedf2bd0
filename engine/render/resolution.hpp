#pragma once

#include <cstddef>

namespace zeroset {

/// Chooses how fine pictures are drawn while something moves, from what the last ones cost: the
/// finest resolution that is expected to stay within a time. It keeps to a resolution while the
/// cost wavers around it, so that the picture does not flicker. Not thread-safe.
class ResolutionGovernor {
public:
    explicit ResolutionGovernor(double budget_ms) : budget_ms_(budget_ms) {}

    /// Pixels along a side of the picture to draw, for each of the full one: at most 1. `pixels`:
    /// of the full picture.
    double choose(std::size_t pixels);
    /// A picture of so many pixels took so long.
    void measured(std::size_t pixels, double ms);
    /// Nothing is known of the next pictures: another formula, which may be `slow`.
    void forget(bool slow = false) {
        known_ = false;
        slow_ = slow;
    }

    /// Whether a picture of the formula has been measured.
    [[nodiscard]] bool is_known() const { return known_; }
    /// The time that a picture of so many pixels is expected to take; 0 where nothing is known.
    [[nodiscard]] double expected_ms(std::size_t pixels) const;

private:
    double budget_ms_;
    bool known_ = false;
    bool slow_ = false;     ///< the formula is interpreted
    double unit_ms_ = 0.0;  ///< of a picture of one pixel
    std::size_t step_ = 0;  ///< of the resolutions, the finest first
};

}  // namespace zeroset
