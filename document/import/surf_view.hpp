#pragma once

#include "document/import/imported.hpp"
#include "document/import/placement.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

// Position, clip region and perspective of surf's pictures: a view of [-10, 10] x [-10, 10] from
// +z, in which the surface is moved, turned (about y, x and then z) and divided by the scales.

namespace zeroset {

/// The number of a constant of surf's language: Pi, central, yes, cube.
std::optional<double> surf_constant(std::string_view name);

/// Whether a command, or a word alone, does not change what a picture shows.
bool surf_only_sets(std::string_view command);

/// Whether a number of this name changes surf's pictures, but not what is made of them here; its
/// number at the end does not count.
bool surf_draws_with(std::string_view number);

/// The turn about an axis, as rot_x and rotate() do it: left-handed about y.
Placement surf_turning(int axis, double angle_rad);

struct SurfView {
    Placement to_view;  ///< of points of the surface
    /// Where the document shows the view itself: the surface's coordinates at a point of it. Else
    /// the document shows the surface's own coordinates.
    std::optional<Placement> substituted;
    double radius = 10.0, clip_front = 10.0, clip_back = -10.0;
    glm::dvec3 centre{0.0};
    int clip = 0;
    double half_height = 10.0;
    std::optional<double> distance;
};

/// The script's variables that make a SurfView.
class SurfViewNames {
public:
    [[nodiscard]] bool knows(std::string_view name) const;
    using Setting = std::function<double(const std::string& name, double otherwise)>;
    [[nodiscard]] SurfView of(const Setting& setting) const;
};

/// Sets box, region and camera. `lines`: where the script sets which variable.
void apply(const SurfView& view, ImportedDocument& drawn,
           const std::map<std::string, std::size_t>& lines);

}  // namespace zeroset
