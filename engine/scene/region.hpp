#pragma once

#include "engine/view/box.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace zeroset {

/// The points no farther from `centre` than `radius`, above 0.
struct Ball {
    glm::dvec3 centre{0.0};
    double radius = 1.0;

    bool operator==(const Ball&) const = default;
};

/// A section plane: keeps the points with dot(normal, p) <= offset.
struct Section {
    glm::dvec3 normal{1.0, 0.0, 0.0};  ///< of length 1
    double offset = 0.0;
    bool cap = true;  ///< fills the solids that it cuts open
    /// Shows the numbers behind the surfaces there (Scene::section_values): in caps where `cap`,
    /// else wherever they are defined.
    bool values = false;

    bool operator==(const Section&) const = default;
};

inline constexpr std::size_t max_sections = 6;

/// The part of the clip box that is shown: the points in the ball that all sections keep. Convex,
/// so that a ray is inside on one stretch.
struct Region {
    std::optional<Ball> ball;
    std::vector<Section> sections;  ///< at most max_sections

    bool operator==(const Region&) const = default;
    /// Whether it is all of space.
    [[nodiscard]] bool is_whole() const { return !ball && sections.empty(); }
    /// Whether a point is in it, or no farther than `slack` beyond the ball or a section's plane.
    [[nodiscard]] bool contains(const glm::dvec3& point, double slack = 0.0) const;
};

/// Rounding errors of distances from the shape are proportional to this size and the places'.
double size_of(const Section& section);
double size_of(const Ball& ball);

/// The section that keeps dot(normal, p) <= offset, for a normal of any length above 0.
Section make_section(const glm::dvec3& normal, double offset, bool cap = true);

/// Whether something is seen on the section itself.
inline bool is_filled(const Section& section) { return section.cap || section.values; }

/// The region, which has no ball, in a world that is drawn stretched (Camera).
Region stretched(const Region& region, const glm::dvec3& stretch);

/// Whether the section takes something away from the box, and is no face of it.
bool cuts(const Section& section, const Box& box);

}  // namespace zeroset
