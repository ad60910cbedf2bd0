#pragma once

#include "engine/antialias/cover_rules.hpp"

#include <cstdint>
#include <limits>

namespace zeroset {

/// The state of a front and its flags: vectors of fronts hold them in a word each.
struct FrontMarks {
    enum class State : std::uint8_t {
        Going,   ///< the search goes on; no ray has a root before `at`
        Rooted,  ///< every ray has its first root between `at` and `to`
        Edged,   ///< some rays may have roots between `at` and `to`; none has one before `at`
        Gone,    ///< no ray has a root
    };

    State state = State::Going;
    std::uint8_t open_cells = 0;  ///< of a stretch from open_from on
    bool continuous : 1 = true;   ///< f is so between open_from and `at`, if that is a stretch
    bool kinked : 1 = false;      ///< f may have a kink there, or between `at` and `to`
    bool stretched : 1 = false;   ///< the last cell was made longer for the roots that it holds
    bool monotone : 1 = false;    ///< Rooted: there is one root on each ray; else maybe more
    bool calm : 1 = false;        ///< how much normal . view changes does not matter
    bool placed : 1 = false;      ///< it is known where the rays are inside of the clip region
    std::uint8_t unused : 2 = 0;  ///< so that all of the word is set
    std::uint8_t unused_byte = 0;
};
static_assert(sizeof(FrontMarks) == sizeof(std::uint32_t));

/// How far the search for the first root of one surface on all rays of a square has come.
/// Depths are along the view axis, as TileRays has them.
struct Front : FrontMarks {
    static constexpr double none = std::numeric_limits<double>::infinity();

    float turn = 0.0F;  ///< Rooted: the width of the enclosure of normal . view
    double at = 0.0;
    double to = 0.0;
    double end = none;  ///< the rays leave the clip region
    double step = 0.0;  ///< of the next cell
    /// Where a stretch of cells began that are neither free nor hold the first root of every ray.
    double open_from = none;
    /// Within the clip region all rays are between these.
    double inside_from = 0.0, inside_to = 0.0;

    /// Whether one sample cannot stand for all rays of a root.
    [[nodiscard]] bool is_uneven() const {
        return !calm && static_cast<double>(turn) > most_turn_of(kinked);
    }

    [[nodiscard]] bool is_open() const { return open_from < none; }
    /// Whether all rays are within the clip region between two depths.
    [[nodiscard]] bool is_inside(double from, double until) const {
        return from >= inside_from && until <= inside_to;
    }
    /// Before this there is no root.
    [[nodiscard]] double free_to() const {
        return state == State::Going && is_open() ? open_from : at;
    }
    /// Goes on behind `to`.
    void pass() {
        at = to;
        open_from = none;
        state = at < end ? State::Going : State::Gone;
    }
};

}  // namespace zeroset
