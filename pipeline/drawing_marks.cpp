#include "pipeline/drawing_marks.hpp"

#include "document/framing.hpp"
#include "document/look.hpp"
#include "engine/annotate/axes.hpp"
#include "engine/annotate/hidden.hpp"
#include "engine/annotate/ticks.hpp"
#include "engine/render/render.hpp"
#include "engine/view/image_plane.hpp"
#include "pipeline/periodic_axes.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

/// Axes are placed in whole units of the page, so many to a point.
constexpr double units_per_pt = 16.0;
/// Pixels along the longer side of the picture that tells what surfaces hide.
constexpr double picture_side = 700.0;
constexpr double marker_pt = 3.0;
constexpr std::uint32_t marker_color = 0x1F5FC4;

double letters_pt(const PageSize& page) {
    return std::clamp(std::min(page.width, page.height) / 36.0, 5.0, 9.0);
}

double width_pt(LineKind kind) {
    switch (kind) {
        case LineKind::AxisX:
        case LineKind::AxisY:
        case LineKind::AxisZ: return 0.7;
        case LineKind::ClipBox: return 0.5;
        case LineKind::Grid: return 0.35;
    }
    return 0.0;
}

/// The colour on white paper, as 0xRRGGBB.
std::uint32_t on_paper(LineKind kind) {
    const AxisColors& colors = axes_on_light;
    const std::uint32_t color = kind == LineKind::ClipBox ? colors.clip_box
                                : kind == LineKind::Grid
                                    ? colors.grid
                                    : colors.axes.at(static_cast<std::size_t>(kind));
    const std::uint32_t alpha = color >> 24U;
    std::uint32_t mixed = 0;
    for (const unsigned shift : {0U, 8U, 16U}) {
        const std::uint32_t channel = color >> shift & 0xFFU;
        mixed = mixed << 8U | (channel * alpha + 255U * (255U - alpha)) / 255U;
    }
    return mixed;
}

Framebuffer picture_of(const PictureRequest& request, const PageSize& page,
                       const TimeLimit& limit) {
    const double scale = picture_side / std::max(page.width, page.height);
    const auto side = [scale](double length) {
        return std::max(1, static_cast<int>(std::lround(scale * length)));
    };
    Framebuffer frame(side(page.width), side(page.height));
    TraceSettings settings = request.settings;
    settings.shadows = settings.soft_light = false;
    settings.antialias = Antialias::None;
    settings.reflections = 0;
    render_frame(scene_of(request), request.camera, settings, frame, {.limit = limit});
    return frame;
}

AxesView view_of(const Document& document, const PictureRequest& request, const PageSize& page) {
    return {.clip = document.clip,
            .camera = request.camera,
            .up = document.up,
            .width = static_cast<int>(std::lround(units_per_pt * page.width)),
            .height = static_cast<int>(std::lround(units_per_pt * page.height)),
            .em = units_per_pt * letters_pt(page),
            .names = document.axis_names,
            .of_pi = periodic_axes(*request.formula->program)};
}

void add_markers(const Document& document, const PictureRequest& request, const PageSize& page,
                 const Framebuffer& shown, DrawnMarks& marks) {
    const AxesView view = view_of(document, request, page);
    const ImagePlane plane(request.camera, {.width = view.width, .height = view.height});
    for (const Marker& marker : document.markers) {
        const auto place = plane.pixel_of(marker.at);
        if (!place || is_behind(shown, plane.view(), marker.at)) continue;
        const glm::dvec2 at = *place / units_per_pt;
        const double em = letters_pt(page);
        const std::string words = name_of(marker);
        marks.lines.push_back({.from = at, .to = at, .width_pt = marker_pt, .color = marker_color});
        marks.texts.push_back(
            {.words = words,
             .middle = at + em * glm::dvec2(0.5 * label_width_em(words) + 0.4, -0.6),
             .em_pt = em,
             .color = marker_color});
    }
}

}  // namespace

DrawnMarks drawing_marks(const Document& document, const PictureRequest& request,
                         const PageSize& page, const TimeLimit& limit) {
    DrawnMarks marks;
    if (!draws_box(document) && document.markers.empty()) return marks;
    const Framebuffer shown = picture_of(request, page, limit);
    const AxesChoice choice{
        .axes = document.axes, .clip_box = document.clip_box, .grid = document.grid};
    const Axes axes = make_axes(view_of(document, request, page), choice, shown);
    for (const AxisLine& line : axes.lines) {
        marks.lines.push_back({.from = line.from / units_per_pt,
                               .to = line.to / units_per_pt,
                               .width_pt = width_pt(line.kind),
                               .color = on_paper(line.kind),
                               .hidden = line.hidden});
    }
    for (const AxisLabel& label : axes.labels) {
        marks.texts.push_back({.words = label.text,
                               .middle = label.middle / units_per_pt,
                               .em_pt = letters_pt(page),
                               .color = on_paper(label.kind)});
    }
    add_markers(document, request, page, shown, marks);
    return marks;
}

}  // namespace zeroset
