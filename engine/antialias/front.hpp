#pragma once

#include "engine/antialias/cover_rules.hpp"

#include <cstdint>
#include <limits>

namespace zeroset {

/// A cell, a slab of a square's beam, as its form judges all of its rays.
struct CellVerdict {
    double from, to;  ///< the slab
    bool rejected;    ///< no ray has a root
    bool continuous;  ///< f is
    bool monotone;    ///< f rises on all rays, or falls: there is at most one root on each
    bool kinked;      ///< f may have a kink
    bool precise;     ///< the form's error is small beside its change across the square
    /// Where its linear part lets roots be, perhaps beyond the slab.
    double root_from, root_to;
    double turn;  ///< the width of the enclosure of normal . view
    /// How much longer the next cell may be: rejected, or precise, if f goes on as it does here.
    double growth;
};

/// The lengths and bounds that steer the search along a beam.
struct FrontRules {
    double fair_length;  ///< of the longest cell that is not halved
    double margin;       ///< by which cells are longer than their slabs, at both ends
};

/// How far the search for the first root of one surface on all rays of a square has come.
/// Depths are along the view axis, as TileRays has them.
struct Front {
    enum class State : std::uint8_t {
        Going,   ///< before `at` there is no root
        Rooted,  ///< nor is there; between `at` and `to` every ray has its first one
        Edged,   ///< nor is there; between `at` and `to` some rays may have roots
        Gone,    ///< no ray has a root
    };
    static constexpr double none = std::numeric_limits<double>::infinity();

    State state = State::Going;
    bool continuous = true;  ///< f is, between open_from and `at`, if that is a stretch
    bool kinked = false;     ///< f may have a kink there, or between `at` and `to`
    bool stretched = false;  ///< the last cell was made longer for the roots that it holds
    std::uint8_t open_cells = 0;
    double at = 0.0;
    double to = 0.0;
    double end = 0.0;   ///< the rays leave the clip region
    double step = 0.0;  ///< of the next cell
    /// Where a stretch of cells began that are neither free nor hold the first root of every ray.
    double open_from = none;
    /// Within the clip region all rays are between these.
    double inside_from = 0.0, inside_to = 0.0;
    double turn = 0.0;      ///< Rooted: the width of the enclosure of normal . view
    bool monotone = false;  ///< Rooted: there is one root on each ray; else there may be more

    /// Whether one sample cannot stand for all rays of a root.
    [[nodiscard]] bool is_uneven() const { return turn > most_turn_of(kinked); }

    [[nodiscard]] bool is_open() const { return open_from < none; }
    /// Whether all rays are within the clip region between two depths.
    [[nodiscard]] bool is_inside(double from, double until) const {
        return from >= inside_from && until <= inside_to;
    }
    /// Before this there is no root.
    [[nodiscard]] double free_to() const {
        return state == State::Going && is_open() ? open_from : at;
    }
    /// Where the next cell ends.
    [[nodiscard]] double next() const { return at + step < end ? at + step : end; }
    /// Takes what is known of the next cell.
    void advance(const CellVerdict& cell, const FrontRules& rules);
    /// Goes on behind `to`.
    void pass();

private:
    void leave_open(const CellVerdict& cell);
    void end_stretch(double until);
    void take_root(const CellVerdict& cell, const FrontRules& rules);
};

}  // namespace zeroset
