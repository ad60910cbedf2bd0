#pragma once

#include "document/import/imported.hpp"

#include <glm/glm.hpp>

#include <optional>
#include <string>

namespace zeroset {

/// A map of points: p -> linear p + shift.
struct Placement {
    glm::dmat3 linear{1.0};
    glm::dvec3 shift{0.0};

    [[nodiscard]] glm::dvec3 of(const glm::dvec3& point) const { return linear * point + shift; }
    /// This map, and then `next`.
    [[nodiscard]] Placement then(const Placement& next) const;
    /// The map back; none where points fall together.
    [[nodiscard]] std::optional<Placement> inverse() const;
    /// The factor of all lengths, where the map keeps angles and handedness.
    [[nodiscard]] std::optional<double> scale() const;
    [[nodiscard]] bool is_identity() const;
    [[nodiscard]] bool is_finite() const;

    static Placement scaling(const glm::dvec3& factors);
    static Placement moving(const glm::dvec3& by);
    /// Turns right-handedly about an axis: 0 for x, 1 for y, 2 for z.
    static Placement turning(int axis, double angle_rad);
};

/// The coordinates of the place that a point (x, y, z) comes from, separated by commas:
/// "x, 0.5*y - z, z + 1".
std::string coordinates_of(const Placement& placement);

/// A camera that looks along -z of a view with y up, and sees [-half_height, half_height] of it at
/// z = 0; from `distance`, or along parallel rays where there is none. `from_view` maps the view to
/// the world, and has a scale.
Camera camera_of_view(const Placement& from_view, double half_height,
                      std::optional<double> distance);

}  // namespace zeroset
