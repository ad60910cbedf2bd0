#include "pipeline/fit_view.hpp"

#include "document/framing.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/measure/extent.hpp"
#include "pipeline/picture_request.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace zeroset {

namespace {

/// The heights of a graph z = f(x, y) over a box, at points of a grid; empty for another surface.
std::vector<double> heights_over(const Expr& surface, const Box& box) {
    const Node& root = surface.nodes().back();
    const Node& up = surface.node(root.a);
    if (root.op != Op::Subtract || up.op != Op::Variable || up.number != 2) return {};
    constexpr int count = 32;  // steps along each side
    std::vector<double> heights;
    for (int i = 0; i <= count; ++i) {
        for (int k = 0; k <= count; ++k) {
            const double x = std::lerp(box.lo.x, box.hi.x, i / double{count});
            const double y = std::lerp(box.lo.y, box.hi.y, k / double{count});
            const double height = -value_at(surface, {x, y, 0.0, 0.0}).value;
            if (std::isfinite(height)) heights.push_back(height);
        }
    }
    return heights;
}

/// Makes a box reach over most of these heights, in z.
void take_heights(std::vector<double>& heights, Box& box) {
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
    const double most = 2.0 * std::max(box.hi.x - box.lo.x, box.hi.y - box.lo.y);
    const double half = std::min(0.5 * (hi - lo) + margin, 0.5 * most);
    const double middle = 0.5 * (lo + hi);
    box.lo.z = middle - half;
    box.hi.z = middle + half;
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
    take_heights(heights, box);
    return box;
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
