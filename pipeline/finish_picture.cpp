#include "pipeline/finish_picture.hpp"

#include "engine/annotate/axis_shapes.hpp"
#include "engine/annotate/card_style.hpp"
#include "engine/annotate/label_font.hpp"
#include "engine/annotate/legend.hpp"
#include "engine/annotate/markers.hpp"
#include "engine/annotate/paint_shapes.hpp"

#include <string_view>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

AxesChoice axes_choice(const Document& document) {
    return {.axes = document.axes, .clip_box = document.clip_box, .grid = document.grid};
}

bool needs_legend(const FrameSubject& subject) {
    return subject.legend && subject.coloring.by != ColorBy::Plain;
}

Shapes axes_over(const Framebuffer& frame, const FrameSubject& subject) {
    const Document& document = subject.document;
    const double em = label_em(frame.width, frame.height);
    const AxesView view{.clip = document.clip,
                        .camera = subject.camera,
                        .up = document.up,
                        .width = frame.width,
                        .height = frame.height,
                        .em = em};
    return axis_shapes(make_axes(view, axes_choice(document), frame), {.em = em});
}

Shapes markers_over(const Framebuffer& frame, const FrameSubject& subject, const CardStyle& style) {
    std::vector<MarkedPoint> points;
    points.reserve(subject.document.markers.size());
    for (const Marker& marker : subject.document.markers)
        points.push_back({marker.at, std::to_string(marker.number)});
    const glm::dvec2 size(frame.width, frame.height);
    return marker_shapes(points, {.frame = frame, .camera = subject.camera, .size = size}, style);
}

Shapes legend_over(const Framebuffer& frame, const FrameSubject& subject, const CardStyle& style) {
    if (!needs_legend(subject)) return {};
    const Legend legend = legend_of(subject.coloring, subject.document.coloring.expression);
    const glm::dvec2 size(frame.width, frame.height);
    const glm::dvec2 margin(style.unit);
    return legend_shapes({.legend = &legend}, size - margin, size - 2.0 * margin, style);
}

}  // namespace

std::expected<std::shared_ptr<const Framebuffer>, std::string> finish_picture(
    std::shared_ptr<const Framebuffer> frame, const FrameSubject& subject) {
    const Document& document = subject.document;
    if (!axes_choice(document).any() && document.markers.empty() && !needs_legend(subject))
        return frame;
    const auto font = LabelFont::load();
    if (!font) return std::unexpected(font.error());
    const CardStyle style =
        card_style_for(frame->width, frame->height,
                       [&](std::string_view words, double em) { return font->width(words, em); });
    Shapes shapes = axes_over(*frame, subject);
    append(shapes, markers_over(*frame, subject, style));
    append(shapes, legend_over(*frame, subject, style));
    auto picture = std::make_shared<Framebuffer>(*frame);
    paint_shapes(*picture, shapes, *font);
    return picture;
}

}  // namespace zeroset
