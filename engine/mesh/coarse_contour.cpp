#include "engine/mesh/collapsible_mesh.hpp"
#include "engine/mesh/contour.hpp"
#include "engine/mesh/field_at_points.hpp"
#include "engine/mesh/mesh_steps.hpp"
#include "engine/mesh/place_index.hpp"
#include "engine/mesh/vertex_clusters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

// Tetrahedra are as small as the proof wants them and give some twelve triangles where two would
// do. So their vertices are put into groups first, as large as the surface's bend allows for the
// tolerance, whatever the sizes of cells; only what stands for a group gets a place on the surface.

namespace zeroset {
namespace {

// Grids of groups: from the lattice's step upwards, two for each doubling.
constexpr int no_grid = -1;
constexpr int all_grids = 1 << 10;
constexpr float never = std::numeric_limits<float>::infinity();
// The edge of a group's place where the surface bends with radius 1 and the tolerance is 1.
constexpr double edge_of_groups = 2.4;
// Normals of a triangle and of its vertices.
constexpr double least_agreement = 0.6;

class CoarseContour {
public:
    CoarseContour(const CellTree& tree, const Lattice& lattice, const MeshSolid& solid,
                  double tolerance, const MeshWork& work)
        : tree_(tree),
          lattice_(lattice),
          solid_(solid),
          tolerance_(tolerance),
          work_(work),
          marched_(march(lattice)),
          clusters_(marched_.triangles, marched_.edges.size()),
          labels_(marched_.edges.size()),
          changed_(marched_.edges.size(), 1),
          numbers_(marched_.edges.size()) {}

    Contour make(std::span<const std::uint32_t> cells);

private:
    void choose_grids(std::span<const std::uint32_t> cells);
    [[nodiscard]] int grid_for(double bend) const;
    void find_points();
    [[nodiscard]] std::uint64_t label(std::uint32_t v) const;
    void join(VertexClusters::Set set);
    [[nodiscard]] VertexClusters::Set refine(std::span<const std::uint32_t> roots, int by);
    void place_groups();
    void place_on_edges(std::span<const std::uint32_t> vertices);
    [[nodiscard]] std::vector<MeshVertex> nearest_on_surface(std::vector<glm::dvec3> points) const;
    void add_place(std::uint32_t root, const MeshVertex& vertex) {
        numbers_[root] = static_cast<std::uint32_t>(places_.size());
        places_.push_back(vertex);
    }
    [[nodiscard]] std::vector<std::uint32_t> wrong_groups() const;
    [[nodiscard]] const MeshVertex& vertex_of(std::uint32_t root) const {
        return places_[numbers_[root]];
    }
    Contour build();

    const CellTree& tree_;
    const Lattice& lattice_;
    const MeshSolid& solid_;
    double tolerance_;
    const MeshWork& work_;
    MarchedLattice marched_;
    VertexClusters clusters_;
    std::vector<int> grids_;          ///< of vertices
    std::vector<glm::dvec3> points_;  ///< about where vertices are
    std::vector<std::uint64_t> labels_;
    VertexClusters::Set changed_;  ///< groups without a place or not measured yet
    std::vector<MeshVertex> places_;
    std::vector<std::uint32_t> numbers_;  ///< of groups among `places_`, by their roots
};

int CoarseContour::grid_for(double bend) const {
    const int largest = 2 * (tree_.deepest() - 2);
    const double edge = edge_of_groups * std::sqrt(tolerance_ / bend);
    const double grid = std::floor(2.0 * std::log2(edge / lattice_.step));
    return static_cast<int>(std::clamp(grid, double{no_grid}, double(largest)));
}

void CoarseContour::choose_grids(std::span<const std::uint32_t> cells) {
    std::vector<float> of_cells(tree_.size());
    for (std::size_t i = 0; i < tree_.size(); ++i) {
        const MeshCell& cell = tree_[i];
        if (!cell.is_active()) continue;
        const bool smooth = cell.facts.graded && !cell.uncertain && !cell.facts.kinked;
        of_cells[i] = smooth ? cell.bend : never;
    }
    for (const std::uint32_t cell : cells)
        of_cells[cell] = never;
    std::vector<float> bends(marched_.edges.size());
    for (std::size_t i = 0; i < marched_.triangles.size(); ++i) {
        const auto& [a, b] = lattice_.tetrahedra[marched_.tetrahedra[i]].cells;
        const float bend = std::max(of_cells[a], of_cells[b]);
        for (const std::uint32_t v : marched_.triangles[i])
            bends[v] = std::max(bends[v], bend);
    }
    grids_.reserve(bends.size());
    for (const float bend : bends)
        grids_.push_back(bend == never ? no_grid : grid_for(double{bend}));
}

/// Takes the levels between lattice vertices for straight.
void CoarseContour::find_points() {
    points_.reserve(marched_.edges.size());
    for (const std::uint64_t edge : marched_.edges) {
        const LatticeVertex& a = lattice_.vertices[edge >> 32U];
        const LatticeVertex& b = lattice_.vertices[edge & 0xFFFFFFFFU];
        points_.push_back(a.point + a.level / (a.level - b.level) * (b.point - a.point));
    }
}

/// The number of v's place in its grid: of the middles and corners of cubes the nearest one.
std::uint64_t CoarseContour::label(std::uint32_t v) const {
    if (grids_[v] == no_grid) return VertexClusters::alone;
    const double edge = lattice_.step * std::exp2(0.5 * grids_[v]);
    const glm::dvec3 p = (points_[v] - tree_.point(Place(0))) / edge;
    const glm::dvec3 corner = glm::floor(p + 0.5);
    const glm::dvec3 middle = glm::floor(p);
    const glm::dvec3 from_corner = p - corner;
    const glm::dvec3 from_middle = p - middle - 0.5;
    const bool at_corner = glm::dot(from_corner, from_corner) <= glm::dot(from_middle, from_middle);
    const glm::dvec3 at = at_corner ? corner : middle;
    const auto part = [](double x) { return static_cast<std::uint64_t>(x); };
    return part(at.x) | part(at.y) << 19U | part(at.z) << 38U |
           static_cast<std::uint64_t>(grids_[v]) << 57U | (at_corner ? 1ULL << 63U : 0ULL);
}

/// Gives groups a finer grid where they are of more than one vertex; returns these.
VertexClusters::Set CoarseContour::refine(std::span<const std::uint32_t> roots, int by) {
    VertexClusters::Set wrong(points_.size());
    for (const std::uint32_t root : roots)
        wrong[root] = clusters_.size(root) > 1 ? 1 : 0;
    VertexClusters::Set refined(points_.size());
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
        if (wrong[clusters_.root(v)] == 0) continue;
        grids_[v] = std::max(no_grid, grids_[v] - by);
        refined[v] = changed_[v] = 1;
    }
    return refined;
}

/// Makes groups of a set anew, such that can become a vertex each.
void CoarseContour::join(VertexClusters::Set set) {
    constexpr int a_half = 2;
    for (int by = a_half;; by = all_grids) {
        for (std::uint32_t v = 0; v < labels_.size(); ++v) {
            if (set[v] != 0) labels_[v] = label(v);
        }
        clusters_.join(labels_, set);
        const std::vector<std::uint32_t> defects = clusters_.defects(set);
        if (defects.empty()) return;
        set = refine(defects, by);
    }
}

/// Gives changed groups places: their middle, brought onto the surface along its normals, or, where
/// that does not lead there and of one vertex alone, the root on an edge of the lattice.
void CoarseContour::place_groups() {
    std::vector<glm::dvec3> sums(points_.size(), glm::dvec3(0.0));
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
        if (changed_[v] != 0) sums[clusters_.root(v)] += points_[v];
    }
    std::vector<std::uint32_t> roots;
    std::vector<glm::dvec3> middles;
    std::vector<std::uint32_t> on_edges;
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
        if (changed_[v] == 0 || clusters_.root(v) != v) continue;
        if (clusters_.size(v) == 1) {
            on_edges.push_back(v);
            continue;
        }
        roots.push_back(v);
        middles.push_back(sums[v] / double(clusters_.size(v)));
    }
    const std::vector<MeshVertex> near = nearest_on_surface(middles);
    for (std::size_t i = 0; i < roots.size(); ++i) {
        const double edge = lattice_.step * std::exp2(0.5 * grids_[roots[i]]);
        const bool is_there = double{near[i].error} <= 1e-12 * edge;
        if (is_there && glm::distance(near[i].point, middles[i]) < 0.5 * edge)
            add_place(roots[i], near[i]);
        else
            on_edges.push_back(roots[i]);
    }
    place_on_edges(on_edges);
}

void CoarseContour::place_on_edges(std::span<const std::uint32_t> vertices) {
    std::vector<std::uint64_t> edges;
    edges.reserve(vertices.size());
    for (const std::uint32_t v : vertices)
        edges.push_back(marched_.edges[v]);
    const std::vector<MeshVertex> places = vertices_on(lattice_, edges, solid_, work_);
    for (std::size_t i = 0; i < vertices.size(); ++i)
        add_place(vertices[i], places[i]);
}

/// Goes from points along the surface's normals to it, as far as some steps lead.
std::vector<MeshVertex> CoarseContour::nearest_on_surface(std::vector<glm::dvec3> points) const {
    constexpr int most_steps = 5;
    std::vector<MeshVertex> vertices(points.size());
    for (int step = 0; step < most_steps; ++step) {
        const std::vector<SolidValue> values = field_at(solid_, points, work_);
        for (std::size_t i = 0; i < points.size(); ++i) {
            vertices[i] = {.point = points[i],
                           .normal = values[i].normal,
                           .part = values[i].part,
                           .error = static_cast<float>(values[i].distance())};
            points[i] -= values[i].level * values[i].normal;
        }
    }
    return vertices;
}

/// The changed groups at triangles that turn too far from the surface's normals or are too far from
/// it.
std::vector<std::uint32_t> CoarseContour::wrong_groups() const {
    TriangleMesh mesh;
    std::vector<Triangle> roots;
    for (const Triangle& t : marched_.triangles) {
        if (!VertexClusters::touches(t, changed_)) continue;
        const Triangle r = clusters_.roots_of(t);
        const bool grouped =
            std::ranges::any_of(r, [&](std::uint32_t root) { return clusters_.size(root) > 1; });
        if (!grouped || !VertexClusters::is_left(r)) continue;
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const std::uint32_t root : r)
            mesh.vertices.push_back(vertex_of(root));
        mesh.triangles.push_back({first, first + 1, first + 2});
        roots.push_back(r);
    }
    const std::vector<float> far = deviations(solid_, mesh, work_);
    std::vector<std::uint32_t> wrong;
    for (std::size_t i = 0; i < roots.size(); ++i) {
        const auto v = std::span(mesh.vertices).subspan(3 * i, 3);
        const glm::dvec3 across = area_vector(v[0].point, v[1].point, v[2].point);
        const double least = least_agreement * glm::length(across);
        const bool turned = std::ranges::any_of(v, [&](const MeshVertex& vertex) {
            return vertex.normal != glm::dvec3(0.0) && glm::dot(vertex.normal, across) <= least;
        });
        if (turned || far[i] > static_cast<float>(tolerance_))
            wrong.insert(wrong.end(), roots[i].begin(), roots[i].end());
    }
    return wrong;
}

Contour CoarseContour::build() {
    Contour contour;
    std::vector<std::uint32_t> numbers(points_.size());
    std::vector<std::uint64_t> edges;
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
        if (clusters_.root(v) != v) continue;
        numbers[v] = static_cast<std::uint32_t>(edges.size());
        contour.mesh.vertices.push_back(vertex_of(v));
        edges.push_back(marched_.edges[v]);
    }
    for (std::size_t i = 0; i < marched_.triangles.size(); ++i) {
        const Triangle r = clusters_.roots_of(marched_.triangles[i]);
        if (!VertexClusters::is_left(r)) continue;
        contour.mesh.triangles.push_back({numbers[r[0]], numbers[r[1]], numbers[r[2]]});
        contour.tetrahedra.push_back(marched_.tetrahedra[i]);
    }
    contour.creases = creases_on(lattice_, edges);
    return contour;
}

Contour CoarseContour::make(std::span<const std::uint32_t> cells) {
    constexpr int rounds_of_steps = 3;
    choose_grids(cells);
    find_points();
    join(changed_);
    for (int round = 0;; ++round) {
        place_groups();
        if (work_.limit.over()) break;
        const std::vector<std::uint32_t> wrong = wrong_groups();
        std::ranges::fill(changed_, std::uint8_t{0});
        if (wrong.empty()) break;
        join(refine(wrong, round < rounds_of_steps ? 1 : all_grids));
    }
    return build();
}

}  // namespace

Contour make_coarse_contour(const CellTree& tree, const Lattice& lattice,
                            std::span<const std::uint32_t> cells, const MeshSolid& solid,
                            double tolerance, const MeshWork& work) {
    return CoarseContour(tree, lattice, solid, tolerance, work).make(cells);
}

}  // namespace zeroset
