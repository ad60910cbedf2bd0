#include "pipeline/finish_picture.hpp"

#include "engine/annotate/axis_shapes.hpp"
#include "engine/annotate/card_style.hpp"
#include "engine/annotate/contour_labels.hpp"
#include "engine/annotate/hidden.hpp"
#include "engine/annotate/label_font.hpp"
#include "engine/annotate/legend.hpp"
#include "engine/annotate/markers.hpp"
#include "engine/annotate/paint.hpp"
#include "engine/image/background.hpp"
#include "engine/image/rgba_image.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

AxesChoice axes_choice(const Document& document) {
    return {.axes = document.axes, .clip_box = document.clip_box, .grid = document.grid};
}

bool needs_legend(const FrameSubject& subject) {
    return subject.legend && (subject.coloring.by != ColorBy::Plain || subject.section_values);
}

glm::dvec2 canvas_of(const ImageSize& size) { return {size.width, size.height}; }

Shapes axes_over(const Framebuffer& shown, const ImageSize& size, const FrameSubject& subject) {
    const Document& document = subject.document;
    const double em = label_em(size.width, size.height);
    const AxesView view{.clip = document.clip,
                        .camera = subject.camera,
                        .up = document.up,
                        .width = size.width,
                        .height = size.height,
                        .em = em,
                        .names = document.axis_names,
                        .of_pi = subject.of_pi};
    const Axes axes = make_axes(view, axes_choice(document), shown);
    if (subject.transparent) return axis_shapes(axes, axis_style_on_anything(em));
    const Background background = document.light.background.value_or(Background());
    return axis_shapes(axes, axis_style_on(background, em));
}

Shapes markers_over(const Framebuffer& shown, const ImageSize& size, const FrameSubject& subject,
                    const CardStyle& style) {
    std::vector<MarkedPoint> points;
    points.reserve(subject.document.markers.size() + subject.points.size());
    for (const Marker& marker : subject.document.markers)
        points.push_back({.at = marker.at, .words = name_of(marker)});
    const ViewFrame view(subject.camera);
    for (const ShownPoint& point : subject.points) {
        if (point.name.empty()) continue;
        points.push_back(
            {.at = before_ball(view, point.at, point.radius), .words = point.name, .dot = false});
    }
    return marker_shapes(
        points, {.frame = shown, .camera = subject.camera, .size = canvas_of(size)}, style);
}

Shapes legend_over(const ImageSize& size, const FrameSubject& subject, const CardStyle& style) {
    if (!needs_legend(subject)) return {};
    const Coloring& coloring = subject.coloring;
    const Legend legend = legend_of(coloring, subject.document.coloring.expression);
    const std::optional<Legend> sections = subject.section_values.transform(section_legend);
    const CornerLegend corner{.legend = coloring.by == ColorBy::Plain ? nullptr : &legend,
                              .sections = sections ? &*sections : nullptr};
    const glm::dvec2 canvas = canvas_of(size);
    const glm::dvec2 margin(style.unit);
    return legend_shapes(corner, canvas - margin, canvas - 2.0 * margin, style);
}

bool has_contour_labels(const FrameSubject& subject) {
    const SurfaceLines& lines = subject.coloring.lines;
    return lines.labels && !lines.contours.empty();
}

Shapes labels_over(const Framebuffer& shown, const ImageSize& size, const FrameSubject& subject,
                   const CardStyle& style) {
    return contour_label_shapes({.frame = shown,
                                 .camera = subject.camera,
                                 .lines = subject.coloring.lines,
                                 .uniforms = subject.uniforms,
                                 .size = canvas_of(size)},
                                style);
}

}  // namespace

bool has_marks(const FrameSubject& subject) {
    const bool names_points = std::ranges::any_of(
        subject.points, [](const ShownPoint& point) { return !point.name.empty(); });
    return axes_choice(subject.document).any() || !subject.document.markers.empty() ||
           names_points || needs_legend(subject) || has_contour_labels(subject);
}

PictureMarks::PictureMarks(LabelFont font, Shapes shapes, int height, bool transparent)
    : font_(std::move(font)),
      shapes_(std::move(shapes)),
      height_(height),
      transparent_(transparent) {}

std::expected<PictureMarks, std::string> PictureMarks::make(const Framebuffer& shown,
                                                            const ImageSize& size,
                                                            const FrameSubject& subject) {
    auto font = LabelFont::load();
    if (!font) return std::unexpected(font.error());
    const CardStyle style =
        card_style_for(size.width, size.height,
                       [&](std::string_view words, double em) { return font->width(words, em); });
    Shapes shapes = axes_over(shown, size, subject);
    append(shapes, labels_over(shown, size, subject, style));
    append(shapes, markers_over(shown, size, subject, style));
    append(shapes, legend_over(size, subject, style));
    return PictureMarks(std::move(*font), std::move(shapes), size.height, subject.transparent);
}

void PictureMarks::paint(Framebuffer& band, int row) const {
    constexpr std::uint32_t opaque = 0xFF000000U;
    Framebuffer marks(band.width, band.height);
    std::ranges::fill(marks.color, 0U);
    paint_shapes(marks, row == 0 ? shapes_ : moved(shapes_, {0.0, -row}), font_);
    for (int y = 0; y < band.height; ++y) {
        const auto background = background_color(band.background, row + y, height_);
        for (std::size_t at = band.index(0, y); at < band.index(0, y + 1); ++at) {
            if (marks.color[at] >> 24U == 0) continue;
            const std::uint32_t under =
                transparent_ ? drawn_color(band, band, at, background) : band.color[at] | opaque;
            band.color[at] = blended(under, marks.color[at], 1.0);
        }
    }
    band.blank_rows.clear();
}

std::expected<std::shared_ptr<const Framebuffer>, std::string> finish_picture(
    std::shared_ptr<const Framebuffer> frame, const FrameSubject& subject) {
    if (!has_marks(subject)) return frame;
    const auto marks =
        PictureMarks::make(*frame, {.width = frame->width, .height = frame->height}, subject);
    if (!marks) return std::unexpected(marks.error());
    auto picture = std::make_shared<Framebuffer>(*frame);
    marks->paint(*picture, 0);
    return picture;
}

}  // namespace zeroset
