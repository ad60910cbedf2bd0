#pragma once

#include <glm/ext/vector_double3.hpp>

#include <array>
#include <string>

namespace zeroset {

/// A row that is a point, where it is for the values of the sliders.
struct ShownPoint {
    int row = 0;       ///< id of the row
    std::string name;  ///< as the row defines it; empty: it has none
    glm::dvec3 at{0.0};
    double radius = 0.0;  ///< of the ball that it is drawn as
    /// The slider that each coordinate is, w among them; empty: it is none.
    std::array<std::string, 3> sliders;

    bool operator==(const ShownPoint&) const = default;
    /// Whether a slider moves it along an axis.
    [[nodiscard]] bool is_movable() const {
        return !sliders[0].empty() || !sliders[1].empty() || !sliders[2].empty();
    }
};

}  // namespace zeroset
