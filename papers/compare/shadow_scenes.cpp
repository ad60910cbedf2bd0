#include "papers/compare/shadow_scenes.hpp"

namespace zeroset {
namespace {

constexpr ShadowTable shadows{
    .name = "florez-figure-5.13",
    .source = "Florez 2008, section 5.4.4 and figure 5.13: shadows of a set of spheres",
    .note =
        "the spheres, the light and the view are not printed: twelve in three rings, as one "
        "set of points, and three surfaces of the gallery; printed are whole pictures, with "
        "nine rays a pixel outside of boxes",
    .size_px = 512,
    .printed_rays_min = 38.0,
    .printed_boxes_min = 16.0,
    .scenes = {
        ShadowScene{.name = "spheres",
                    .formula =
                        "s(u, v, q) = min(min((x-u)^2+(y-v)^2+(z-q)^2, (x+u)^2+(y+v)^2+(z-q)^2), "
                        "min((x-v)^2+(y+u)^2+(z-q)^2, (x+v)^2+(y-u)^2+(z-q)^2)); "
                        "min(s(0.9, 0.1, -0.6), s(0.6, 0.6, 0.1), s(0.3, 0.4, 0.7)) = 0.16",
                    .domain = 1.5},
        ShadowScene{.name = "orthocircle",
                    .formula = "((x^2+y^2-1)^2+z^2) ((y^2+z^2-1)^2+x^2) ((z^2+x^2-1)^2+y^2) = "
                               "0.0056 (1 + 3 (x^2+y^2+z^2))",
                    .domain = 1.6},
        ShadowScene{.name = "tangle",
                    .formula = "x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8 = 0",
                    .domain = 3.0},
        ShadowScene{.name = "teardrop", .formula = "0.5x^5 + 0.5x^4 = y^2 + z^2", .domain = 1.0},
    }};

}  // namespace

const ShadowTable& shadow_table() { return shadows; }

}  // namespace zeroset
