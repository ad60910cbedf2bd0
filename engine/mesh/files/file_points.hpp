#pragma once

#include "engine/mesh/files/mesh_file.hpp"

#include <glm/glm.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace zeroset {

/// The places of a file's vertices as it writes them, in millimetres and floats. No two are equal:
/// where points fall together in these numbers, one moves by a last place, so that surfaces stay
/// closed and without branches when a reader joins equal points.
class FilePoints {
public:
    explicit FilePoints(const MeshFile& file);

    /// The places of the vertices of an object, in their order.
    [[nodiscard]] std::span<const glm::vec3> of(std::size_t object) const {
        return std::span(points_).subspan(first_[object], first_[object + 1] - first_[object]);
    }

private:
    std::vector<glm::vec3> points_;
    std::vector<std::size_t> first_;  ///< the place of each object's first vertex, and the end
};

}  // namespace zeroset
