#include "pipeline/fit_view.hpp"

#include "document/framing.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/measure/extent.hpp"
#include "pipeline/picture_request.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace zeroset {

namespace {

/// The heights of a graph z = f(x, y) over a box, at points of a grid; empty for another surface.
std::vector<double> heights_over(const Expr& surface, const Box& box,
                                 std::span<const double> parameters = {}) {
    const Node& root = surface.nodes().back();
    if (root.op != Op::Subtract) return {};
    const auto is_z = [](const Node& node) { return node.op == Op::Variable && node.number == 2; };
    const bool up_first = is_z(surface.node(root.a));
    if (!up_first && !is_z(surface.node(root.b))) return {};
    constexpr int count = 32;      // steps along each side
    constexpr double above = 1.3;  // another z, at which f(x, y) must be as at 0
    std::vector<double> heights;
    for (int i = 0; i <= count; ++i) {
        for (int k = 0; k <= count; ++k) {
            const double x = std::lerp(box.lo.x, box.hi.x, i / double{count});
            const double y = std::lerp(box.lo.y, box.hi.y, k / double{count});
            const auto side = [&](double z) {
                const double value = value_at(surface, {x, y, z, 0.0}, parameters).value;
                return up_first ? z - value : z + value;
            };
            const double height = side(0.0);
            if (!std::isfinite(height)) continue;
            if (!(std::abs(side(above) - height) <= 1e-9 * (1.0 + std::abs(height)))) return {};
            heights.push_back(height);
        }
    }
    return heights;
}

/// The height from which on most of the sorted heights are within `reach`: the lowest, or the one
/// that leaves the highest within, where hardly fewer are.
double fullest_from(const std::vector<double>& heights, double reach) {
    const auto within = [&](double from) {
        return std::ranges::upper_bound(heights, from + reach) -
               std::ranges::lower_bound(heights, from);
    };
    const auto fullest = std::ranges::max_element(heights, {}, within);
    const double hardly_fewer = 0.9 * static_cast<double>(within(*fullest));
    for (const double end : {heights.front(), heights.back() - reach}) {
        if (static_cast<double>(within(end)) >= hardly_fewer) return end;
    }
    return *fullest;
}

/// Makes a box reach over most of these heights, in z, at most so many times as high as wide.
void take_heights(std::vector<double>& heights, double most_slender, Box& box) {
    if (heights.empty()) return;
    std::ranges::sort(heights);
    const std::size_t few = heights.size() / 20;
    double lo = heights.front();
    double hi = heights.back();
    const double middle_lo = heights[few];
    const double middle_hi = heights[heights.size() - 1 - few];
    constexpr double far = 10.0;
    if (hi - lo > far * (middle_hi - middle_lo) && middle_hi > middle_lo) {
        lo = middle_lo;
        hi = middle_hi;
    }
    const double margin = std::max(0.05 * (hi - lo), 1e-3 * std::max(1.0, std::abs(hi)));
    // A graph many times as high as it is wide would be a line.
    const double most = most_slender * std::max(box.hi.x - box.lo.x, box.hi.y - box.lo.y);
    box.lo.z = lo - margin;
    box.hi.z = hi + margin;
    if (box.hi.z - box.lo.z <= most) return;
    constexpr double below = 0.02;
    box.lo.z = fullest_from(heights, (1.0 - 2.0 * below) * most) - below * most;
    box.hi.z = box.lo.z + most;
}

/// The box with its floor and ceiling at numbers of two digits, at least a quarter as high as wide.
Box rounded_heights(Box box) {
    const double least = 0.25 * (box.hi.x - box.lo.x);
    const double more = std::max(0.0, 0.5 * (least - (box.hi.z - box.lo.z)));
    const double unit = std::pow(10.0, std::floor(std::log10(box.hi.z - box.lo.z + more)) - 1.0);
    box.lo.z = std::floor((box.lo.z - more) / unit + 1e-6) * unit;
    box.hi.z = std::ceil((box.hi.z + more) / unit - 1e-6) * unit;
    return box;
}

}  // namespace

std::optional<Box> asked_box(const Program& program) {
    const auto& ends = program.box;
    if (!ends[0] && !ends[1] && !ends[2]) return std::nullopt;
    Box box;
    for (int k = 0; k < 3; ++k) {
        const auto& own = ends.at(static_cast<std::size_t>(k));
        if (!own) continue;
        box.lo[k] = own->front();
        box.hi[k] = own->back();
    }
    if (ends[2]) return box;
    std::vector<double> heights;
    for (const Expr& surface : program.surfaces)
        std::ranges::copy(heights_over(surface, box), std::back_inserter(heights));
    constexpr double most_slender = 2.0;
    take_heights(heights, most_slender, box);
    return box;
}

std::optional<Box> graph_box(const Program& program, const Document& document) {
    std::vector<double> parameters;
    parameters.reserve(program.parameters.size());
    for (const std::string& name : program.parameters)
        parameters.push_back(slider_of(document, name).value);
    Box box;
    std::vector<double> heights;
    for (const Expr& surface : program.surfaces) {
        const std::vector<double> own = heights_over(surface, box, parameters);
        if (own.empty()) return std::nullopt;
        heights.insert(heights.end(), own.begin(), own.end());
    }
    take_heights(heights, 1.0, box);
    return rounded_heights(box);
}

std::string graph_note(const Box& box) {
    return filled(tr("z from {0} to {1}, as high as the graph"),
                  {localized(short_number(box.lo.z, 4)), localized(short_number(box.hi.z, 4))});
}

std::string fit_by_itself(Document& document, const PictureRequest& request, double aspect,
                          const TimeLimit& limit) {
    if (const auto box = graph_box(*request.formula->program, document)) {
        if (*box == document.clip) return "";
        document.clip = *box;
        if (document.camera) document.camera = whole_view(*document.camera, document, aspect);
        return graph_note(*box);
    }
    const Extent extent =
        unstretched(find_extent(scene_of(request), limit), request.camera.stretch);
    if (limit.over()) return "";
    auto framing = frame_by_itself(document, extent, aspect);
    if (!framing) return "";
    const bool had_camera = document.camera.has_value();
    document = std::move(framing->document);
    if (!had_camera) document.camera.reset();
    return framing->note;
}

TimeLimit own_fitting_limit(TimeLimit limit) {
    constexpr auto most = std::chrono::seconds(3);  // a few milliseconds for most surfaces
    limit.until = std::min(limit.until, TimeLimit::Clock::now() + most);
    return limit;
}

std::string fit_view(Document& document, const PictureRequest& request, double aspect,
                     bool fits_box, const TimeLimit& limit) {
    document.camera = request.camera;
    const Extent extent =
        unstretched(find_extent(scene_of(request), limit), request.camera.stretch);
    Framing framing = frame_surfaces(document, extent, aspect, fits_box);
    document = std::move(framing.document);
    return framing.found && extent.whole ? "" : framing.note;
}

}  // namespace zeroset
