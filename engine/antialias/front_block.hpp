#pragma once

#include "engine/antialias/front.hpp"
#include "engine/kernel/batches.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// Some fronts as columns, to be taken on many at a time. Plain data, nothing of it set at first.
/// Depths are rounded outward: less is free, and more wanted. In upward rounding.
template <class Real>
struct FrontBlock {
    static constexpr std::size_t capacity = 128;
    static_assert(capacity % batch_multiple == 0);
    using Numbers = std::array<Real, capacity>;

    alignas(64) Numbers at, to, end, step, open_from, inside_from, inside_to, turn;
    alignas(64) std::array<ContinuityMask<Real>, capacity> marks;  ///< FrontMarks

    void load(std::size_t i, const Front& front) {
        at[i] = below(front.at);
        to[i] = above(front.to);
        end[i] = above(front.end);
        step[i] = above(front.step);
        open_from[i] = below(front.open_from);
        inside_from[i] = above(front.inside_from);
        inside_to[i] = below(front.inside_to);
        turn[i] = static_cast<Real>(front.turn);
        marks[i] = std::bit_cast<std::uint32_t>(static_cast<const FrontMarks&>(front));
    }
    /// Puts a front in the place of another one.
    void copy(std::size_t from, std::size_t to_place) {
        for (Numbers* const column :
             {&at, &to, &end, &step, &open_from, &inside_from, &inside_to, &turn})
            (*column)[to_place] = (*column)[from];
        marks[to_place] = marks[from];
    }
    /// Writes to the front what a step may have changed: all but where its rays are inside.
    void store(std::size_t i, Front& front) const {
        front.at = static_cast<double>(at[i]);
        front.to = static_cast<double>(to[i]);
        front.step = static_cast<double>(step[i]);
        front.open_from = static_cast<double>(open_from[i]);
        front.turn = static_cast<float>(turn[i]);
        static_cast<FrontMarks&>(front) =
            std::bit_cast<FrontMarks>(static_cast<std::uint32_t>(marks[i]));
    }

private:
    static Real above(double depth) { return static_cast<Real>(depth); }
    static Real below(double depth) { return -static_cast<Real>(-depth); }
};

}  // namespace zeroset
