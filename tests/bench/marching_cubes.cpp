#include "tests/bench/marching_cubes.hpp"

#include "engine/mesh/field_at_points.hpp"
#include "engine/mesh/place_index.hpp"

#include <array>
#include <map>
#include <vector>

namespace zeroset::test {
namespace {

/// The corners of a cube's faces, counter-clockwise as seen from outside.
constexpr std::array<std::array<unsigned, 4>, 6> faces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

/// The table's work, done anew for each cube: crossings of its faces' sides are joined within each
/// face (of four, so that what is inside stays apart), and the rings are filled by fans.
class Marcher {
public:
    Marcher(const MeshSolid& solid, int cells) : cells_(cells), edges_(1024) {
        const double size = 1.02 * solid.box.size();
        lo_ = solid.box.centre() - glm::dvec3(0.5 * size);
        step_ = size / cells;
        std::vector<glm::dvec3> points;
        for (int z = 0; z <= cells; ++z) {
            for (int y = 0; y <= cells; ++y) {
                for (int x = 0; x <= cells; ++x)
                    points.push_back(lo_ + step_ * glm::dvec3(x, y, z));
            }
        }
        values_ = field_at(solid, points, {});
    }
    TriangleMesh march() {
        for (int z = 0; z < cells_; ++z) {
            for (int y = 0; y < cells_; ++y) {
                for (int x = 0; x < cells_; ++x)
                    march_cube({x, y, z});
            }
        }
        return std::move(mesh_);
    }

private:
    [[nodiscard]] std::uint32_t corner(const glm::ivec3& cube, unsigned i) const {
        const glm::ivec3 at =
            cube + glm::ivec3(static_cast<int>(i & 1U), static_cast<int>(i >> 1U & 1U),
                              static_cast<int>(i >> 2U));
        return static_cast<std::uint32_t>((at.z * (cells_ + 1) + at.y) * (cells_ + 1) + at.x);
    }
    [[nodiscard]] glm::dvec3 point(std::uint32_t id) const {
        const auto row = static_cast<std::uint32_t>(cells_ + 1);
        return lo_ + step_ * glm::dvec3(id % row, id / row % row, id / row / row);
    }
    std::uint32_t crossing(std::uint32_t inside, std::uint32_t outside) {
        const std::uint32_t vertex = edges_.add(pair_key(inside, outside));
        if (vertex == mesh_.vertices.size()) {
            const double a = values_[inside].level;
            const double t = a / (a - values_[outside].level);
            const glm::dvec3 from = point(inside);
            mesh_.vertices.push_back({.point = from + t * (point(outside) - from)});
        }
        return vertex;
    }
    void march_cube(const glm::ivec3& cube) {
        std::map<std::uint32_t, std::uint32_t> next;
        for (const auto& face : faces)
            join(cube, face, next);
        while (!next.empty()) {
            const std::uint32_t first = next.begin()->first;
            std::uint32_t at = next.begin()->second;
            next.erase(next.begin());
            while (next.at(at) != first) {
                const std::uint32_t following = next.at(at);
                mesh_.triangles.push_back({first, at, following});
                next.erase(at);
                at = following;
            }
            next.erase(at);
        }
    }
    /// Joins where the face's border leaves the inside to where it came in last.
    void join(const glm::ivec3& cube, const std::array<unsigned, 4>& face,
              std::map<std::uint32_t, std::uint32_t>& next) {
        for (std::size_t leaving = 0; leaving < 4; ++leaving) {
            const std::uint32_t a = corner(cube, face[leaving]);
            const std::uint32_t b = corner(cube, face[(leaving + 1) % 4]);
            if (!values_[a].inside() || values_[b].inside()) continue;
            std::size_t k = leaving;
            while (values_[corner(cube, face[(k + 3) % 4])].inside())
                k = (k + 3) % 4;
            const std::uint32_t c = corner(cube, face[(k + 3) % 4]);
            next[crossing(corner(cube, face[k]), c)] = crossing(a, b);
        }
    }

    int cells_;
    glm::dvec3 lo_{};
    double step_ = 0.0;
    KeyIndex edges_;
    std::vector<SolidValue> values_;
    TriangleMesh mesh_;
};

}  // namespace

TriangleMesh marching_cubes(const MeshSolid& solid, int cells) {
    return Marcher(solid, cells).march();
}

}  // namespace zeroset::test
