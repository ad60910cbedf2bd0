#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// The sign of f at a point of a ray, as far as it is proved.
enum class EndSign : std::int8_t { Below = -1, Unknown = 0, Above = 1, NotAsked = 2 };

/// Whether the signs at two places are proved, and differ.
constexpr bool are_opposite(EndSign a, EndSign b) {
    return static_cast<int>(a) * static_cast<int>(b) == -1;
}
/// Whether the signs at two places are proved, and the same.
constexpr bool are_equal(EndSign a, EndSign b) {
    return static_cast<int>(a) * static_cast<int>(b) == 1;
}

/// A stretch T = [from, to] of a ray, in depths s along the view axis (TileRays).
struct Stretch {
    double from, to;
    EndSign from_sign = EndSign::NotAsked;
    EndSign to_sign = EndSign::NotAsked;

    [[nodiscard]] double width() const { return to - from; }
    [[nodiscard]] double middle() const { return 0.5 * from + 0.5 * to; }
};

/// A stretch of a ray to be looked at: all before it on the ray is known.
struct RayTask {
    std::uint32_t pixel;  ///< index in the tile, in rows of tile_size
    Stretch stretch;
    double finest;  ///< a stretch that is no wider than this is not divided
};

/// The answer of a method to a task.
struct TaskOutcome {
    enum class Kind : std::uint8_t {
        Parts,  ///< only these stretches, front to back, may hold a root; none: there is none
        Stop,   ///< fine enough: to be decided as it is
        Root,   ///< f has one root in the stretch parts[0], at `root` or nearby, and none before
    };
    Kind kind = Kind::Parts;
    std::uint8_t count = 0;
    std::array<Stretch, 2> parts{};
    double root = 0.0;

    void reject() {
        kind = Kind::Parts;
        count = 0;
    }
    void narrow(const Stretch& part) {
        kind = Kind::Parts;
        count = 1;
        parts[0] = part;
    }
    void divide(const Stretch& front, const Stretch& behind) {
        kind = Kind::Parts;
        count = 2;
        parts = {front, behind};
    }
    /// Divides a stretch in its middle, where f has this sign.
    void bisect(const Stretch& stretch, EndSign middle = EndSign::NotAsked) {
        const double at = stretch.middle();
        divide({.from = stretch.from, .to = at, .from_sign = stretch.from_sign, .to_sign = middle},
               {.from = at, .to = stretch.to, .from_sign = middle, .to_sign = stretch.to_sign});
    }
    void stop() { kind = Kind::Stop; }
    void take_root(double from, double to, double at) {
        kind = Kind::Root;
        count = 1;
        parts[0] = {.from = from, .to = to};
        root = at;
    }
};

}  // namespace zeroset
