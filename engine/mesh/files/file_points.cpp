#include "engine/mesh/files/file_points.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace zeroset {
namespace {

/// A set of points, which it refers to by their numbers; open addressing, at most half full.
class PointSet {
public:
    PointSet(const std::vector<glm::vec3>& points, std::size_t count)
        : points_(points), slots_(std::bit_ceil(2 * count + 1), none) {}

    /// Adds the point of a number; false where an equal one is there.
    bool add(std::size_t number) {
        const glm::vec3& point = points_[number];
        for (std::size_t slot = hash(point);; ++slot) {
            std::size_t& at = slots_[slot & (slots_.size() - 1)];
            if (at == none) {
                at = number;
                return true;
            }
            if (points_[at] == point) return false;
        }
    }

private:
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    static std::size_t hash(const glm::vec3& point) {
        std::uint64_t mixed = 0;
        for (int axis = 0; axis < 3; ++axis) {
            mixed = (mixed ^ std::bit_cast<std::uint32_t>(point[axis])) * 0x9E3779B97F4A7C15U;
            mixed ^= mixed >> 32U;
        }
        return mixed;
    }

    const std::vector<glm::vec3>& points_;
    std::vector<std::size_t> slots_;
};

/// Moves a point by a last place of its largest coordinate.
void move_on(glm::vec3& point) {
    int axis = 0;
    for (const int other : {1, 2}) {
        if (std::abs(point[other]) > std::abs(point[axis])) axis = other;
    }
    constexpr float up = std::numeric_limits<float>::infinity();
    constexpr float least = std::numeric_limits<float>::min();
    point[axis] = point[axis] == 0.0F ? least : std::nextafter(point[axis], up);
}

bool is_finite(const glm::vec3& point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

}  // namespace

FilePoints::FilePoints(const MeshFile& file) {
    for (const MeshObject& object : file.objects) {
        first_.push_back(points_.size());
        for (const MeshVertex& vertex : object.mesh.vertices)
            points_.push_back(glm::vec3(file.mm_per_unit * vertex.point) + 0.0F);  // no -0
    }
    first_.push_back(points_.size());
    PointSet known(points_, points_.size());
    for (std::size_t number = 0; number < points_.size(); ++number) {
        while (is_finite(points_[number]) && !known.add(number))
            move_on(points_[number]);
    }
}

}  // namespace zeroset
