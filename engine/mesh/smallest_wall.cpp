#include "engine/mesh/collapsible_mesh.hpp"
#include "engine/mesh/finished_mesh.hpp"
#include "engine/mesh/parallel.hpp"
#include "engine/mesh/triangle_tree.hpp"
#include "engine/real/unbounded.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

// Rays take a microsecond or two.
constexpr std::size_t most_triangles = 40'000;
// The cosine between the way inwards and the normal of the side that it meets.
constexpr double least_facing = 0.5;
// That cosine where the two sides count as parallel.
constexpr double parallel_facing = 0.94;
// The direction of narrower triangles is not to be trusted.
constexpr double least_shape = 0.02;

/// Where a triangle is asked, as shares of its corners.
constexpr std::array<glm::dvec3, 4> places{
    {{1.0 / 3, 1.0 / 3, 1.0 / 3}, {0.96, 0.02, 0.02}, {0.02, 0.96, 0.02}, {0.02, 0.02, 0.96}}};

glm::dvec3 area_vector_of(const TriangleMesh& mesh, const Triangle& t) {
    return area_vector(mesh.vertices[t[0]].point, mesh.vertices[t[1]].point,
                       mesh.vertices[t[2]].point);
}

double shape(const TriangleMesh& mesh, const Triangle& t) {
    return shape_of(mesh.vertices[t[0]].point, mesh.vertices[t[1]].point,
                    mesh.vertices[t[2]].point);
}

/// The thinnest wall behind one triangle, if it is no thicker than the thinnest one so far.
SmallestWall behind(const TriangleMesh& mesh, const TriangleTree& tree, std::uint32_t triangle,
                    std::atomic<double>& thinnest) {
    SmallestWall least{.thickness = unbounded};
    const Triangle& t = mesh.triangles[triangle];
    if (shape(mesh, t) < least_shape) return least;
    const glm::dvec3 inward = -glm::normalize(area_vector_of(mesh, t));
    for (const glm::dvec3& share : places) {
        const glm::dvec3 from = share.x * mesh.vertices[t[0]].point +
                                share.y * mesh.vertices[t[1]].point +
                                share.z * mesh.vertices[t[2]].point;
        ++least.places;
        const bool is_middle = &share == places.data();
        // A thread that is ahead must not hide a wall that is as thin.
        constexpr double rounding = 1e-9;
        const double most = std::min(least.thickness, thinnest.load(std::memory_order_relaxed));
        const auto hit =
            tree.way_out(from, inward, triangle, is_middle ? unbounded : most * (1.0 + rounding));
        if (!hit) continue;
        const Triangle& met = mesh.triangles[hit->triangle];
        if (shape(mesh, met) < least_shape) continue;
        const glm::dvec3 normal = glm::normalize(area_vector_of(mesh, met));
        const double facing = glm::dot(normal, inward);
        if (is_middle && facing > parallel_facing) least.but_for_rims = hit->distance;
        if (!(facing > least_facing) || hit->distance >= least.thickness) continue;
        least.thickness = hit->distance;
        least.at = from + 0.5 * hit->distance * inward;
        double before = thinnest.load(std::memory_order_relaxed);
        while (
            least.thickness < before &&
            !thinnest.compare_exchange_weak(before, least.thickness, std::memory_order_relaxed)) {
        }
    }
    return least;
}

/// The thickness between parallel sides below which the part `share` of their area lies; `found[i]`
/// is behind the triangle i * every.
std::optional<double> thickness_at(double share, const TriangleMesh& mesh,
                                   const std::vector<SmallestWall>& found, std::size_t every) {
    std::vector<std::pair<double, double>> walls;  // thickness, area
    double all = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!found[i].but_for_rims) continue;
        const double area = glm::length(area_vector_of(mesh, mesh.triangles[i * every]));
        walls.emplace_back(*found[i].but_for_rims, area);
        all += area;
    }
    std::ranges::sort(walls);
    double thinner = 0.0;
    for (const auto& [thickness, area] : walls) {
        thinner += area;
        if (thinner >= share * all) return thickness;
    }
    return std::nullopt;
}

}  // namespace

std::optional<SmallestWall> smallest_wall(const TriangleMesh& mesh, const MeshWork& work) {
    const std::size_t count = mesh.triangles.size();
    // Beginning the tree takes about so long for a triangle, and cannot be ended.
    constexpr std::chrono::nanoseconds of_tree(500);
    if (work.limit.until - TimeLimit::Clock::now() < count * of_tree) return std::nullopt;
    const TriangleTree tree(mesh);
    const std::size_t every = (count + most_triangles - 1) / most_triangles;
    const std::size_t asked = count == 0 ? 0 : (count + every - 1) / every;
    std::vector<SmallestWall> found(asked);
    std::atomic<double> thinnest = unbounded;
    parallel_upward(asked, 64, work, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last && !work.limit.over(); ++i)
            found[i] = behind(mesh, tree, static_cast<std::uint32_t>(i * every), thinnest);
    });
    // Another place might have a thinner one.
    if (work.limit.over()) return std::nullopt;
    SmallestWall least{.thickness = unbounded};
    for (const SmallestWall& wall : found) {
        const std::size_t places_before = least.places;
        if (wall.thickness < least.thickness) least = wall;
        least.places = places_before + wall.places;
    }
    if (least.thickness == unbounded) return std::nullopt;
    constexpr double rims = 0.01;
    least.but_for_rims = thickness_at(rims, mesh, found, every);
    return least;
}

}  // namespace zeroset
