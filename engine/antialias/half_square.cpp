#include "engine/antialias/half_square.hpp"

#include <array>
#include <cstddef>

namespace zeroset {
namespace {

struct Corner {
    double x, y, f;
};

/// Where f vanishes between two corners.
Corner between(const Corner& a, const Corner& b) {
    const double part = a.f / (a.f - b.f);
    return {.x = a.x + part * (b.x - a.x), .y = a.y + part * (b.y - a.y), .f = 0.0};
}

}  // namespace

SquarePart part_below_zero(const LinearOnSquare& f) {
    const auto corner = [&](double x, double y) {
        return Corner{.x = x, .y = y, .f = f.at({.x = x, .y = y})};
    };
    const std::array square{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
    // The polygon that the line leaves.
    std::array<Corner, 8> kept{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Corner& a = square[i];
        const Corner& b = square[(i + 1) % 4];
        if (a.f <= 0) kept[count++] = a;
        if ((a.f <= 0) != (b.f <= 0)) kept[count++] = between(a, b);
    }
    double twice = 0.0;
    double x = 0.0;
    double y = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const Corner& a = kept[i];
        const Corner& b = kept[(i + 1) % count];
        const double cross = a.x * b.y - b.x * a.y;
        twice += cross;
        x += cross * (a.x + b.x);
        y += cross * (a.y + b.y);
    }
    if (!(twice > 0)) return {.share = 0.0, .x = 0.0, .y = 0.0};
    return {.share = twice / 8.0, .x = x / (3.0 * twice), .y = y / (3.0 * twice)};
}

}  // namespace zeroset
