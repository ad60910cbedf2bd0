#pragma once

#include "engine/antialias/front.hpp"
#include "engine/kernel/batches.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// Some fronts as columns, to be taken on many at a time. Plain data, nothing of it set at first.
struct FrontBlock {
    static constexpr std::size_t room = 128;
    static_assert(room % batch_multiple == 0);
    using Numbers = std::array<double, room>;

    alignas(64) Numbers at, to, end, step, open_from, inside_from, inside_to, turn;
    alignas(64) std::array<std::uint64_t, room> marks;  ///< FrontMarks

    void load(std::size_t i, const Front& front) {
        at[i] = front.at;
        to[i] = front.to;
        end[i] = front.end;
        step[i] = front.step;
        open_from[i] = front.open_from;
        inside_from[i] = front.inside_from;
        inside_to[i] = front.inside_to;
        turn[i] = front.turn;
        marks[i] = std::bit_cast<std::uint64_t>(static_cast<const FrontMarks&>(front));
    }
    [[nodiscard]] bool is_going(std::size_t i) const {
        return std::bit_cast<FrontMarks>(marks[i]).state == FrontMarks::State::Going;
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
        front.at = at[i];
        front.to = to[i];
        front.step = step[i];
        front.open_from = open_from[i];
        front.turn = turn[i];
        static_cast<FrontMarks&>(front) = std::bit_cast<FrontMarks>(marks[i]);
    }
};

}  // namespace zeroset
