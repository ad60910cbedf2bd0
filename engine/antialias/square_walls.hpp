#pragma once

#include "engine/antialias/edge_fit.hpp"
#include "engine/antialias/edge_lines.hpp"
#include "engine/antialias/sample_drafts.hpp"
#include "engine/antialias/square_field.hpp"
#include "engine/antialias/wall_line.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace zeroset {

/// Squares that a wall of the clip region may cut: the edge of a surface in it, where all rays
/// cross it; where rays run along the wall, its line in the square is sought.
class SquareWalls {
public:
    SquareWalls(const TraceFrame& frame, std::size_t surface, SquareField& field,
                SampleDrafts& drafts, Counters& counters)
        : frame_(frame), surface_(surface), field_(field), drafts_(drafts), counters_(counters) {}

    /// The outcome for a square: it is left to others; it is decided here, or a wall is sought in
    /// it; or nothing is seen in it.
    enum class Choice : std::uint8_t { None, Taken, Outside };
    /// Decides a square that all rays enter, or leave, by one wall, where the edge in that is a
    /// line. `is_long`: f may come to 0 and go away again between the ends of its stretches.
    Choice take_line(std::size_t square, SquareStretches stretches, CornerStretches corners,
                     const LineRules& rules, bool is_long);
    /// Adds a square in which a wall may be sought.
    /// `corners`: the stretches of these rays within the clip region; `fit`: the edge without the
    /// wall, where it is known.
    Choice add(std::size_t square, SquareStretches stretches, CornerStretches corners,
               const std::optional<LinearOnSquare>& fit);
    /// Decides the squares that were added, or divides them.
    void decide();

private:
    struct WallPlaces {
        std::array<WallPlace, most_wall_places> places{};
        std::size_t count = 0;

        void push(const WallPlace& place) { places[count++] = place; }
        [[nodiscard]] std::span<const WallPlace> all() const {
            return std::span(places).first(count);
        }
    };
    struct Task {
        std::size_t square;
        SquareRayFlags misses;
        SquareRay shown;  ///< a ray with a root, between these depths
        double from, to;
        WallPlaces places;
        std::array<WallWay, 2> ways;

        /// Takes what is known of the square's rays.
        void take(SquareStretches stretches);
    };
    struct Open {
        const Task* task;
        WallWay* way;
    };
    Choice take_part(std::size_t square, SquareStretches stretches, const EdgeSamples& samples,
                     const LinearOnSquare& line, bool is_long);
    /// Searches the ways of all tasks.
    void narrow();
    void show(const Task& task, const LinearOnSquare& line);

    const TraceFrame& frame_;
    std::size_t surface_;
    SquareField& field_;
    SampleDrafts& drafts_;
    Counters& counters_;
    std::vector<Task> tasks_;
    std::vector<Open> open_;
    std::vector<RayStretch> stretches_;  ///< of the ways that are open
};

}  // namespace zeroset
