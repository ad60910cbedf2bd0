#include "engine/annotate/axes.hpp"

#include "engine/annotate/ticks.hpp"
#include "engine/view/image_plane.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// Ticks are at least about so far apart, and labels this far from their axis, in em.
constexpr double tick_distance_em = 4.5;
constexpr double label_offset_em = 1.1;
constexpr double tick_length_em = 0.3;
constexpr double name_offset_em = 1.0;
constexpr double label_height_em = 1.0;
constexpr double label_gap_em = 0.35;
/// Squares of the grid along the box's longest edge, at most.
constexpr double most_squares = 16.0;

struct Segment {
    glm::dvec3 from, to;

    [[nodiscard]] glm::dvec3 at(double t) const { return from + t * (to - from); }
};

/// The part [from, to] of the parameters 0 to 1.
struct VisiblePart {
    double from = 0.0, to = 1.0;

    /// Leaves where the linear function with these values at 0 and 1 is not below 0.
    void clip(double at_0, double at_1) {
        if (at_0 < 0 && at_1 < 0) to = -1.0;
        const double root = at_0 / (at_0 - at_1);
        if (at_0 < 0 && at_1 >= 0) from = std::max(from, root);
        if (at_0 >= 0 && at_1 < 0) to = std::min(to, root);
    }
    [[nodiscard]] bool empty() const { return !(from < to); }
};

struct Rectangle {
    glm::dvec2 lo, hi;

    [[nodiscard]] bool meets(const Rectangle& other) const {
        return lo.x < other.hi.x && other.lo.x < hi.x && lo.y < other.hi.y && other.lo.y < hi.y;
    }
};

class AxesMaker {
public:
    AxesMaker(const AxesView& view, const Framebuffer& shown)
        : view_(view),
          plane_(view.camera, {.width = view.width, .height = view.height}),
          shown_(shown) {}

    void add_grid();
    void add_clip_box();
    void add_axes();
    Axes take() { return std::move(made_); }

private:
    [[nodiscard]] VisiblePart visible_part(const Segment& segment) const;
    [[nodiscard]] bool is_hidden(const glm::dvec3& point, const glm::dvec2& pixel) const;
    void add_line(const Segment& segment, LineKind kind);
    void add_ticks(int axis, const Segment& segment, const VisiblePart& part);
    void add_tick(int axis, const Segment& segment, double value, double step);
    void add_name(int axis, const Segment& segment, const VisiblePart& part);
    void add_label(AxisLabel label);
    [[nodiscard]] Segment axis_segment(int axis) const;
    [[nodiscard]] glm::dvec2 half_size(const std::string& text) const;
    [[nodiscard]] glm::dvec2 direction_at(const Segment& segment, const glm::dvec3& point) const;

    const AxesView& view_;
    ImagePlane plane_;
    const Framebuffer& shown_;
    Axes made_;
    std::vector<Rectangle> taken_;  ///< by labels
};

LineKind kind_of_axis(int axis) { return static_cast<LineKind>(axis); }

VisiblePart AxesMaker::visible_part(const Segment& segment) const {
    const glm::dvec3 from = plane_.homogeneous(segment.from);
    const glm::dvec3 to = plane_.homogeneous(segment.to);
    const double aspect = static_cast<double>(view_.width) / view_.height;
    const double nearest = 1e-6 * plane_.view().half_height * plane_.view().look_distance;
    VisiblePart part;
    part.clip(from.z - nearest, to.z - nearest);
    for (const double sign : {-1.0, 1.0}) {
        part.clip(aspect * from.z + sign * from.x, aspect * to.z + sign * to.x);
        part.clip(from.z + sign * from.y, to.z + sign * to.y);
    }
    return part;
}

bool AxesMaker::is_hidden(const glm::dvec3& point, const glm::dvec2& pixel) const {
    if (shown_.width == 0) return false;
    const auto scaled = [](double at, int from, int to) {
        return std::clamp(static_cast<int>(at * to / from), 0, to - 1);
    };
    const int col = scaled(pixel.x, view_.width, shown_.width);
    const int row = scaled(pixel.y, view_.height, shown_.height);
    const auto depth = static_cast<double>(shown_.depth[shown_.index(col, row)]);
    // Depths change by about this much from pixel to pixel; and they are floats.
    const double distance = plane_.distance(point);
    const double slack = 2.0 * plane_.homogeneous(point).z / shown_.height;
    return distance > depth + slack + 1e-6 * std::abs(depth);
}

/// Adds the segment as pieces of which each is hidden or not, found pixel by pixel.
void AxesMaker::add_line(const Segment& segment, LineKind kind) {
    const VisiblePart part = visible_part(segment);
    if (part.empty()) return;
    const Segment seen{.from = segment.at(part.from), .to = segment.at(part.to)};
    const glm::dvec3 start = plane_.homogeneous(seen.from);
    const glm::dvec3 end = plane_.homogeneous(seen.to);
    const glm::dvec2 from = plane_.pixel(start);
    const glm::dvec2 to = plane_.pixel(end);
    const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to))));
    std::optional<bool> hidden;
    for (int i = 0; i < steps; ++i) {
        const double s = (i + 0.5) / steps;
        // Even steps in the image are uneven ones in the world.
        const double t = s * start.z / (s * start.z + (1.0 - s) * end.z);
        const bool now = is_hidden(seen.at(t), glm::mix(from, to, s));
        if (hidden != now) {
            const glm::dvec2 here = glm::mix(from, to, static_cast<double>(i) / steps);
            if (hidden) made_.lines.back().to = here;
            made_.lines.push_back({.from = here, .to = to, .kind = kind, .hidden = now});
        }
        hidden = now;
    }
}

void AxesMaker::add_clip_box() {
    for (int corner = 0; corner < 8; ++corner) {
        const auto place = [&](int bits) {
            glm::dvec3 point;
            for (int i = 0; i < 3; ++i)
                point[i] = (bits >> i & 1) != 0 ? view_.clip.hi[i] : view_.clip.lo[i];
            return point;
        };
        for (int axis = 0; axis < 3; ++axis) {
            const int other = corner | 1 << axis;
            if (other != corner)
                add_line({.from = place(corner), .to = place(other)}, LineKind::ClipBox);
        }
    }
}

/// The values at lo, at all multiples of the step between, and at hi.
std::vector<double> stops(double lo, double hi, double step) {
    std::vector<double> values{lo};
    for (double k = std::floor(lo / step) + 1; k * step < hi; ++k)
        values.push_back(k * step);
    values.push_back(hi);
    return values;
}

void AxesMaker::add_grid() {
    const glm::dvec3 size = glm::abs(view_.up);
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const double level = view_.up[axis] > 0 ? view_.clip.lo[axis] : view_.clip.hi[axis];
    const glm::dvec3& stretch = view_.camera.stretch;
    const double drawn_step = stretched(view_.clip, stretch).size() / most_squares;
    for (const int across : {(axis + 1) % 3, (axis + 2) % 3}) {
        const double step = tick_step(drawn_step / stretch[across]);
        for (const double value : stops(view_.clip.lo[across], view_.clip.hi[across], step)) {
            Segment line{.from = view_.clip.lo, .to = view_.clip.hi};
            line.from[axis] = line.to[axis] = level;
            line.from[across] = line.to[across] = value;
            add_line(line, LineKind::Grid);
        }
    }
}

Segment AxesMaker::axis_segment(int axis) const {
    const glm::dvec3 through = glm::clamp(glm::dvec3(0.0), view_.clip.lo, view_.clip.hi);
    Segment segment{.from = through, .to = through};
    segment.from[axis] = view_.clip.lo[axis];
    segment.to[axis] = view_.clip.hi[axis];
    return segment;
}

/// The direction of the segment in the image, length 1.
glm::dvec2 AxesMaker::direction_at(const Segment& segment, const glm::dvec3& point) const {
    const glm::dvec3 place = plane_.homogeneous(point);
    const glm::dvec3 along = plane_.homogeneous(segment.to) - plane_.homogeneous(segment.from);
    const glm::dvec2 turn(along.x * place.z - place.x * along.z,
                          place.y * along.z - along.y * place.z);
    const double length = glm::length(turn);
    return length > 0 ? turn / length : glm::dvec2(1, 0);
}

/// The direction across `along` in which labels lie: below what runs across the image, left of what
/// runs up.
glm::dvec2 below(const glm::dvec2& along) {
    const glm::dvec2 aside(-along.y, along.x);
    const bool across = std::abs(along.x) >= std::abs(along.y);
    return (across ? aside.y < 0 : aside.x > 0) ? -aside : aside;
}

/// Half the room that a label takes.
glm::dvec2 AxesMaker::half_size(const std::string& text) const {
    return 0.5 * view_.em *
           glm::dvec2(label_width_em(text) + label_gap_em, label_height_em + label_gap_em);
}

void AxesMaker::add_axes() {
    for (int axis = 0; axis < 3; ++axis) {
        const Segment segment = axis_segment(axis);
        add_line(segment, kind_of_axis(axis));
        add_name(axis, segment, visible_part(segment));
    }
    for (int axis = 0; axis < 3; ++axis) {
        const Segment segment = axis_segment(axis);
        add_ticks(axis, segment, visible_part(segment));
    }
}

/// Adds the axis's name beyond its end; where that is out of sight, beside the last of it that is
/// seen, within the image.
void AxesMaker::add_name(int axis, const Segment& segment, const VisiblePart& part) {
    const std::string& name = view_.names.at(static_cast<std::size_t>(axis));
    if (part.empty() || name.empty()) return;
    const glm::dvec3 point = segment.at(part.to);
    const glm::dvec2 end = plane_.pixel(plane_.homogeneous(point));
    const glm::dvec2 along = direction_at(segment, point);
    const double wider = 0.5 * std::max(label_width_em(name) - 1.0, 0.0);
    const glm::dvec2 away = (name_offset_em + std::abs(along.x) * wider) * view_.em * along;
    const glm::dvec2 half = half_size(name);
    const glm::dvec2 size(view_.width, view_.height);
    const glm::dvec2 middle = glm::clamp(end + away, half, glm::max(half, size - half));
    const bool at_end = part.to >= 1.0;
    const glm::dvec2 aside = at_end ? glm::dvec2(0.0) : label_offset_em * view_.em * below(along);
    add_label({.middle = glm::clamp(middle + aside, half, glm::max(half, size - half)),
               .text = name,
               .kind = kind_of_axis(axis),
               .hidden = is_hidden(point, end)});
}

void AxesMaker::add_ticks(int axis, const Segment& segment, const VisiblePart& part) {
    if (part.empty()) return;
    const glm::dvec3 from = segment.at(part.from);
    const glm::dvec3 to = segment.at(part.to);
    const double length_px =
        glm::distance(plane_.pixel(plane_.homogeneous(from)), plane_.pixel(plane_.homogeneous(to)));
    const double ticks = length_px / (tick_distance_em * view_.em);
    if (!(ticks >= 1.0)) return;
    const double step = tick_step((to[axis] - from[axis]) / ticks);
    for (double k = std::ceil(from[axis] / step); k * step <= to[axis]; ++k)
        add_tick(axis, segment, k * step, step);
}

void AxesMaker::add_tick(int axis, const Segment& segment, double value, double step) {
    glm::dvec3 point = segment.from;
    point[axis] = value;
    const auto pixel = plane_.pixel_of(point);
    if (!pixel) return;
    const glm::dvec2 aside = below(direction_at(segment, point));
    const LineKind kind = kind_of_axis(axis);
    const bool hidden = is_hidden(point, *pixel);
    const glm::dvec2 half = 0.5 * tick_length_em * view_.em * aside;
    made_.lines.push_back(
        {.from = *pixel - half, .to = *pixel + half, .kind = kind, .hidden = hidden});
    const std::string text = tick_text(value, step);
    const double reach =
        label_offset_em + std::abs(aside.x) * 0.5 * std::max(label_width_em(text) - 1.0, 0.0);
    add_label({.middle = *pixel + reach * view_.em * aside,
               .text = text,
               .kind = kind,
               .hidden = hidden});
}

/// Adds the label unless there is no room for it.
void AxesMaker::add_label(AxisLabel label) {
    const glm::dvec2 half = half_size(label.text);
    const Rectangle place{.lo = label.middle - half, .hi = label.middle + half};
    const bool inside = place.lo.x >= 0 && place.lo.y >= 0 && place.hi.x <= view_.width &&
                        place.hi.y <= view_.height;
    const auto meets = [&](const Rectangle& other) { return place.meets(other); };
    if (!inside || std::ranges::any_of(taken_, meets)) return;
    taken_.push_back(place);
    made_.labels.push_back(std::move(label));
}

}  // namespace

Axes make_axes(const AxesView& view, const AxesChoice& choice, const Framebuffer& shown) {
    AxesMaker maker(view, shown);
    if (choice.grid) maker.add_grid();
    if (choice.clip_box) maker.add_clip_box();
    if (choice.axes) maker.add_axes();
    return maker.take();
}

}  // namespace zeroset
