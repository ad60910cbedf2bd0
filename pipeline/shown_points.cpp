#include "pipeline/shown_points.hpp"

#include "engine/expr/patch_graph.hpp"
#include "engine/interpret/interpret.hpp"
#include "pipeline/patch_surface.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace zeroset {
namespace {

/// The name of the slider that a coordinate is; empty: it is something else.
std::string slider_name(const Expr& coordinate) {
    const Node& root = coordinate.node(coordinate.root());
    const bool is_slider = root.op == Op::Variable && root.number >= variable_w;
    return is_slider ? std::string(variable_name(root.number, coordinate.parameters())) : "";
}

}  // namespace

std::vector<ShownPoint> shown_points(const Formula* formula, const Document& document,
                                     const Camera& camera, int height_px) {
    std::vector<ShownPoint> points;
    if (formula == nullptr || formula->points.empty()) return points;
    std::vector<double> values;
    for (const std::string& name : formula->program->parameters)
        values.push_back(slider_of(document, name).value);
    for (const PointRow& of : formula->points) {
        const int id = formula->surface_rows[of.surface];
        const auto row = std::ranges::find(document.statements, id, &Statement::id);
        if (row == document.statements.end() || !row->visible) continue;
        ShownPoint point{.row = id, .name = formula->program->names[of.surface], .sliders = {}};
        bool is_somewhere = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const Expr& coordinate = of.graphs.point.at(k);
            const double at = value_at(coordinate, {0.0, 0.0, 0.0, document.w.value}, values).value;
            is_somewhere = is_somewhere && std::isfinite(at);
            point.at[static_cast<int>(k)] = at;
            point.sliders.at(k) = slider_name(coordinate);
        }
        const bool is_shown = is_somewhere && document.clip.contains(point.at) &&
                              (!row->box || row->box->contains(point.at)) &&
                              document.region.contains(point.at);
        if (!is_shown) continue;
        const ThicknessUniforms q =
            thickness_of(PatchKind::Point, row->thickness, stretched(document.clip, camera.stretch),
                         camera, height_px);
        const glm::dvec3 drawn = camera.stretch * point.at;
        point.radius = std::abs(q[0] + q[1] * drawn.x + q[2] * drawn.y + q[3] * drawn.z);
        points.push_back(std::move(point));
    }
    return points;
}

}  // namespace zeroset
