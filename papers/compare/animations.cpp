#include "papers/compare/animations.hpp"

#include <algorithm>
#include <array>

namespace zeroset {
namespace {

constexpr std::array animations{
    PrintedAnimation{
        .name = "florez-figure-6.8",
        .source = "Florez 2008, figure 6.8: the orthocircle",
        .note = "how its parameters, its place and the camera go is not printed: a goes from 0.1 "
                "to 0.3 with b = 3, while it turns about z",
        .formula = "g(u, v, q) = ((u^2 + v^2 - 1)^2 + q^2) ((v^2 + q^2 - 1)^2 + u^2) "
                   "((q^2 + u^2 - 1)^2 + v^2) - (0.1 + 0.4 w)^2 (1 + 3 (u^2 + v^2 + q^2)); "
                   "g(x cos(w) - y sin(w), x sin(w) + y cos(w), z) = 0",
        .domain = 1.5,
        .from = 0.0,
        .to = 0.5,
        .printed_least = 40.0,
        .printed_most = 54.0},
    PrintedAnimation{
        .name = "florez-figure-6.10",
        .source = "Florez 2008, figure 6.10: spheres that move out",
        .note = "their number, sizes and ways are not printed: eight of radius 0.25, on their way "
                "to the corners of a cube, as one set of points",
        .formula = "min(min(min((x-w)^2+(y-w)^2+(z-w)^2, (x+w)^2+(y-w)^2+(z-w)^2), "
                   "min((x-w)^2+(y+w)^2+(z-w)^2, (x+w)^2+(y+w)^2+(z-w)^2)), "
                   "min(min((x-w)^2+(y-w)^2+(z+w)^2, (x+w)^2+(y-w)^2+(z+w)^2), "
                   "min((x-w)^2+(y+w)^2+(z+w)^2, (x+w)^2+(y+w)^2+(z+w)^2))) = 0.0625",
        .domain = 1.5,
        .from = 0.1,
        .to = 1.1,
        .printed_least = 32.0,
        .printed_most = 66.0},
    PrintedAnimation{
        .name = "florez-figure-6.12",
        .source = "Florez 2008, figure 6.12: from Chubs to McMullen's K3",
        .note = "the turns are not printed: about x; all of the morph in the 20 frames, as it is "
                "meant to be fast",
        .formula = "g(u, v, q) = (1 - w) (u^4 + v^4 + q^4 - u^2 - v^2 - q^2 + 0.5) + "
                   "w ((1 + u^2) (1 + v^2) (1 + q^2) + 8 u v q - 2); "
                   "g(x, y cos(w) - z sin(w), y sin(w) + z cos(w)) = 0",
        .domain = 2.0,
        .from = 0.0,
        .to = 1.0,
        .printed_least = 10.0,
        .printed_most = 10.0},
};

}  // namespace

std::span<const PrintedAnimation> printed_animations() { return animations; }

const PrintedAnimation* find_printed_animation(std::string_view name) {
    const auto found = std::ranges::find(animations, name, &PrintedAnimation::name);
    return found == animations.end() ? nullptr : &*found;
}

}  // namespace zeroset
