#include "engine/mesh/parts_apart.hpp"

#include "engine/mesh/field_at_points.hpp"
#include "engine/mesh/field_on_boxes.hpp"
#include "engine/mesh/finished_mesh.hpp"
#include "engine/mesh/mesh_facts.hpp"
#include "engine/mesh/parallel.hpp"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

void add_eighths(const Box& box, std::vector<Box>& eighths) {
    const glm::dvec3 middle = box.centre();
    for (int child = 0; child < 8; ++child) {
        Box part = box;
        for (int axis = 0; axis < 3; ++axis)
            ((child >> axis & 1) != 0 ? part.lo : part.hi)[axis] = middle[axis];
        eighths.push_back(part);
    }
}

/// The eighths of these boxes in which more than one part or cut may be the surface.
std::vector<Box> shared_eighths(const MeshSolid& solid, const std::vector<Box>& boxes,
                                const MeshWork& work) {
    constexpr std::size_t of_task = 256;
    std::vector<std::vector<Box>> found((boxes.size() + of_task - 1) / of_task);
    parallel_upward(boxes.size(), of_task, work, [&](std::size_t first, std::size_t last) {
        if (work.limit.over()) return;
        std::vector<Box> eighths;
        for (std::size_t i = first; i < last; ++i)
            add_eighths(boxes[i], eighths);
        std::vector<BoxFacts> facts(eighths.size());
        FieldOnBoxes(solid).evaluate(eighths, facts);
        for (std::size_t i = 0; i < eighths.size(); ++i) {
            const bool known = facts[i].side != BoxSide::Unknown;
            if (!known && (!facts[i].graded || facts[i].count > 1))
                found[first / of_task].push_back(eighths[i]);
        }
    });
    std::vector<Box> shared;
    for (const std::vector<Box>& part : found)
        shared.insert(shared.end(), part.begin(), part.end());
    return shared;
}

/// The solid of one leaf alone.
MeshSolid alone(const MeshSolid& solid, const SolidNode& leaf) {
    return {.parts = {solid.parts[leaf.a]},
            .nodes = {{.kind = SolidNode::Kind::Leaf, .a = 0, .sign = leaf.sign}},
            .surface_parts = 1,
            .cuts = solid.cuts,
            .uniforms = solid.uniforms,
            .box = solid.box};
}

enum class Keeping : std::uint8_t { Unknown, Kept, Dropped, Mixed };

/// Leaves the components of a leaf's mesh that are the solid's surface; false: one is in part.
bool keep_components(const MeshSolid& solid, const SolidNode& leaf, TriangleMesh& mesh,
                     const MeshWork& work) {
    std::vector<glm::dvec3> points;
    points.reserve(mesh.vertices.size());
    for (const MeshVertex& vertex : mesh.vertices)
        points.push_back(vertex.point);
    const std::vector<SolidValue> values = field_at(solid, points, work);
    const std::vector<std::uint32_t> components = components_of(mesh);
    std::vector<Keeping> keeping(mesh.vertices.size());
    for (std::size_t v = 0; v < values.size(); ++v) {
        const bool own = mesh.vertices[v].part == 0 && values[v].part == leaf.a;
        const Keeping wish = own ? Keeping::Kept : Keeping::Dropped;
        Keeping& all = keeping[components[v]];
        all = all == Keeping::Unknown || all == wish ? wish : Keeping::Mixed;
    }
    if (std::ranges::find(keeping, Keeping::Mixed) != keeping.end()) return false;
    std::erase_if(mesh.triangles,
                  [&](const Triangle& t) { return keeping[components[t[0]]] == Keeping::Dropped; });
    drop_unused(mesh);
    for (MeshVertex& vertex : mesh.vertices)
        vertex.part = leaf.a;
    return true;
}

void add_mesh(const TriangleMesh& mesh, TriangleMesh& all) {
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const Triangle& t : mesh.triangles)
        all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

void add_report(const MeshReport& report, MeshReport& all) {
    all.cells += report.cells;
    all.proved += report.proved;
    all.unproved += report.unproved;
    all.rough += report.rough;
    all.places.insert(all.places.end(), report.places.begin(), report.places.end());
    all.rough_places.insert(all.rough_places.end(), report.rough_places.begin(),
                            report.rough_places.end());
    all.smallest_cell = std::min(all.smallest_cell, report.smallest_cell);
    all.cut = all.cut || report.cut;
    all.dense = all.dense || report.dense;
    all.isotopic = all.isotopic && report.isotopic;
    all.deviation = std::max(all.deviation, report.deviation);
    all.thinned_from += report.thinned_from;
}

}  // namespace

std::optional<double> gap_between_parts(const MeshSolid& solid, const MeshWork& work) {
    constexpr int deepest = 10;
    constexpr std::size_t most_boxes = 500'000;
    // Boxes along curves where surfaces meet get twice as many with each level; those between
    // sheets four times, until they get fewer at once.
    constexpr int first_judged = 5;
    int doublings = 0;
    if (solid.parts.size() < 2) return std::nullopt;
    std::vector<Box> boxes{solid.box};
    for (int level = 1; level <= deepest; ++level) {
        const auto before = static_cast<double>(boxes.size());
        const double edge = 0.5 * boxes.front().size();
        boxes = shared_eighths(solid, boxes, work);
        if (work.limit.over() || boxes.size() > most_boxes) return std::nullopt;
        if (boxes.empty()) return edge;
        const double growth = static_cast<double>(boxes.size()) / before;
        doublings = level >= first_judged && growth > 1.5 && growth < 2.6 ? doublings + 1 : 0;
        if (doublings == 2) return std::nullopt;
    }
    return std::nullopt;
}

std::optional<MadeMesh> mesh_of_parts(const MeshSolid& solid, const MeshOptions& options,
                                      double gap) {
    std::vector<SolidNode> leaves;
    std::ranges::copy_if(solid.nodes, std::back_inserter(leaves),
                         [](const SolidNode& node) { return node.kind == SolidNode::Kind::Leaf; });
    MadeMesh all;
    all.report.smallest_cell = solid.box.size();
    all.report.isotopic = true;
    all.report.unchanged = false;
    all.report.tolerance = options.tolerance;
    MeshOptions own = options;
    // Sheets must not meet.
    own.tolerance = std::min(options.tolerance, 0.5 * gap);
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        own.limit = options.limit.share(1, static_cast<int>(leaves.size() - i));
        MadeMesh made = make_mesh(alone(solid, leaves[i]), own);
        const MeshWork work{.threads = options.threads, .limit = options.limit};
        if (!keep_components(solid, leaves[i], made.mesh, work)) return std::nullopt;
        add_mesh(made.mesh, all.mesh);
        add_report(made.report, all.report);
    }
    if (options.limit.cancelled()) return MadeMesh();
    for (auto* const places : {&all.report.places, &all.report.rough_places})
        std::ranges::stable_sort(*places, std::ranges::greater(), &UnprovedPlace::cells);
    return all;
}

}  // namespace zeroset
