#include "engine/annotate/axes.hpp"

#include "engine/annotate/ruler.hpp"
#include "engine/annotate/ticks.hpp"
#include "engine/view/image_plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// Ticks are at least about so far apart where a unit is seen longest.
constexpr double tick_distance_em = 4.5;
/// Ticks nearer to one another than this are left out, but for those with numbers.
constexpr double least_distance_em = 0.6;
/// Lines shorter than this have no numbers.
constexpr double least_ruler_em = 1.6;
constexpr double tick_length_em = 0.4;
constexpr double number_height_em = 0.73;
constexpr double label_height_em = 1.0;
constexpr double label_gap_em = 0.35;
/// Squares of the grid along the box's longest edge, at most.
constexpr double most_squares = 16.0;

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
    [[nodiscard]] int up_axis() const;
    [[nodiscard]] Segment axis_segment(int axis) const;
    [[nodiscard]] glm::dvec2 direction_at(const Segment& segment, const glm::dvec3& point) const;
    [[nodiscard]] std::optional<Ruler> ruler_along(int axis, const Segment& segment) const;
    [[nodiscard]] TickStep own_step(const Ruler& ruler) const;
    bool add_ruler(const Ruler& ruler, const TickStep& step);
    bool add_numbers(const Ruler& ruler, const TickStep& step, double width_em);
    void add_tick(const Ruler& ruler, const glm::dvec2& at, bool hidden);
    void add_name(const Ruler& ruler, double numbers_em, double width_em);
    bool add_label(AxisLabel label);
    [[nodiscard]] glm::dvec2 half_size(const std::string& text) const;

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

/// The axis that `up` is nearest to.
int AxesMaker::up_axis() const {
    const glm::dvec3 size = glm::abs(view_.up);
    return size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
}

void AxesMaker::add_grid() {
    const int axis = up_axis();
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

/// The line along an axis with the side at which its numbers stand: away from the box's middle, or
/// for a line through that, below. Nothing where hardly any of it is seen.
std::optional<Ruler> AxesMaker::ruler_along(int axis, const Segment& segment) const {
    const VisiblePart part = visible_part(segment);
    if (part.empty()) return std::nullopt;
    const glm::dvec2 from = plane_.pixel(plane_.homogeneous(segment.at(part.from)));
    const glm::dvec2 to = plane_.pixel(plane_.homogeneous(segment.at(part.to)));
    Ruler ruler{.axis = axis,
                .segment = segment,
                .part = part,
                .aside = below(direction_at(segment, segment.at(0.5 * (part.from + part.to)))),
                .length_px = glm::distance(from, to)};
    ruler.length = ruler.highest() - ruler.lowest();
    if (ruler.length_px < least_ruler_em * view_.em) return std::nullopt;
    if (const auto centre = plane_.pixel_of(view_.clip.centre())) {
        const double away = glm::dot(0.5 * (from + to) - *centre, ruler.aside);
        if (away < -0.5 * view_.em) ruler.aside = -ruler.aside;
    }
    return ruler;
}

/// The step that suits the line alone: a finer one where it would have less than three ticks, and
/// there is room.
TickStep AxesMaker::own_step(const Ruler& ruler) const {
    const bool of_pi = view_.of_pi.at(static_cast<std::size_t>(ruler.axis));
    const double em = ruler.length_px / view_.em;
    const double ticks = std::max(em / tick_distance_em, std::min(2.0, em / least_ruler_em));
    TickStep step = tick_step_of(ruler.length / ticks, of_pi);
    constexpr double finer = 0.4;  // of 1, 2 and 5 the next smaller
    const double least = least_ruler_em / em * ruler.length;
    while (ruler.last(step) - ruler.first(step) < 2.0 && finer * step.length() > 0.8 * least)
        step = tick_step_of(finer * step.length(), of_pi);
    return step;
}

/// How much of a label of this size, in em, there is along a direction in the image.
double extent_along(const glm::dvec2& direction, double width_em) {
    return std::abs(direction.x) * width_em + std::abs(direction.y) * number_height_em;
}

/// How far apart the middles of two labels with these widths, in em, must be in a direction.
double apart_em(const glm::dvec2& direction, double width_em, double other_em) {
    const glm::dvec2 along = glm::max(glm::abs(direction), 1e-9);
    return std::min((0.5 * (width_em + other_em) + label_gap_em) / along.x,
                    (label_height_em + label_gap_em) / along.y);
}

/// Adds ticks, numbers and the name beside a line; false where no number has room.
bool AxesMaker::add_ruler(const Ruler& ruler, const TickStep& step) {
    double width_em = 0.0;
    for (const double k : {ruler.first(step), ruler.last(step)})
        width_em = std::max(width_em, label_width_em(tick_label(k, step)));
    if (!add_numbers(ruler, step, width_em)) return false;
    add_name(ruler, tick_length_em + label_gap_em + 0.5 * extent_along(ruler.aside, width_em),
             width_em);
    return true;
}

bool AxesMaker::add_numbers(const Ruler& ruler, const TickStep& step, double width_em) {
    // Numbers stand at every tick, or every second, fifth, tenth, so that they do not touch.
    const double tick_px = step.length() * ruler.length_px / ruler.length;
    const glm::dvec2 along(ruler.aside.y, ruler.aside.x);
    const double needed_px = view_.em * apart_em(along, width_em, width_em);
    const double every = std::max(1.0, tick_step(std::max(needed_px / tick_px, 1.0)));
    const bool has_room = tick_px >= least_distance_em * view_.em;
    bool any = false;
    for (double k = ruler.first(step); k <= ruler.last(step); ++k) {
        const bool has_number = std::fmod(k, every) == 0.0;
        if (!has_number && !has_room) continue;
        glm::dvec3 point = ruler.segment.from;
        point[ruler.axis] = k * step.length();
        const auto pixel = plane_.pixel_of(point);
        if (!pixel) continue;
        const bool hidden = is_hidden(point, *pixel);
        add_tick(ruler, *pixel, hidden);
        if (!has_number) continue;
        const std::string text = tick_label(k, step);
        const double reach_em =
            tick_length_em + label_gap_em + 0.5 * extent_along(ruler.aside, label_width_em(text));
        any |= add_label({.middle = *pixel + reach_em * view_.em * ruler.aside,
                          .text = text,
                          .kind = kind_of_axis(ruler.axis),
                          .hidden = hidden});
    }
    return any;
}

void AxesMaker::add_tick(const Ruler& ruler, const glm::dvec2& at, bool hidden) {
    made_.lines.push_back({.from = at,
                           .to = at + tick_length_em * view_.em * ruler.aside,
                           .kind = kind_of_axis(ruler.axis),
                           .hidden = hidden});
}

/// Adds the axis's name beside the middle of the line, or another place of it, beyond its numbers,
/// whose middles are so far away and which are so wide.
void AxesMaker::add_name(const Ruler& ruler, double numbers_em, double width_em) {
    const std::string& name = view_.names.at(static_cast<std::size_t>(ruler.axis));
    if (name.empty()) return;
    const glm::dvec2 half = half_size(name);
    const glm::dvec2 size(view_.width, view_.height);
    const double reach_em =
        numbers_em + apart_em(ruler.aside, width_em, label_width_em(name)) + 0.01;
    for (const double place : {0.5, 0.75, 0.25, 0.95, 0.05}) {
        const double t = std::lerp(ruler.part.from, ruler.part.to, place);
        const glm::dvec3 point = ruler.segment.at(t);
        const glm::dvec2 pixel = plane_.pixel(plane_.homogeneous(point));
        const glm::dvec2 middle = pixel + reach_em * view_.em * ruler.aside;
        if (add_label({.middle = glm::clamp(middle, half, glm::max(half, size - half)),
                       .text = name,
                       .kind = kind_of_axis(ruler.axis),
                       .hidden = is_hidden(point, pixel)}))
            return;
    }
}

/// Adds the axes themselves, and their numbers at the box's outline; where that is out of sight, at
/// the axes. All have one step, as they have one scale, but for those that it leaves with less than
/// two ticks, and those of multiples of pi.
void AxesMaker::add_axes() {
    std::array<std::optional<Ruler>, 3> rulers;
    const auto edges = outer_edges(view_.clip, plane_, up_axis());
    const Ruler* longest = nullptr;  ///< the one along which a unit is seen longest
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        add_line(axis_segment(axis), kind_of_axis(axis));
        if (edges.at(k)) rulers.at(k) = ruler_along(axis, *edges.at(k));
        if (rulers.at(k)) add_line(*edges.at(k), kind_of_axis(axis));
        if (!rulers.at(k)) rulers.at(k) = ruler_along(axis, axis_segment(axis));
        if (!rulers.at(k) || view_.of_pi.at(k)) continue;
        if (longest == nullptr || rulers.at(k)->px_per_unit() > longest->px_per_unit())
            longest = &*rulers.at(k);
    }
    const glm::dvec3& scale = view_.camera.stretch;
    const TickStep common = longest != nullptr ? own_step(*longest) : TickStep();
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        if (!rulers.at(k)) continue;
        const auto step_of = [&](const Ruler& ruler) {
            const bool suits = !view_.of_pi.at(k) && scale[axis] == scale[longest->axis] &&
                               ruler.last(common) > ruler.first(common);
            return suits ? common : own_step(ruler);
        };
        if (add_ruler(*rulers.at(k), step_of(*rulers.at(k)))) continue;
        if (const auto own = ruler_along(axis, axis_segment(axis))) add_ruler(*own, step_of(*own));
    }
}

/// Adds the label; false where there is no room for it.
bool AxesMaker::add_label(AxisLabel label) {
    const glm::dvec2 half = half_size(label.text);
    const Rectangle place{.lo = label.middle - half, .hi = label.middle + half};
    const bool inside = place.lo.x >= 0 && place.lo.y >= 0 && place.hi.x <= view_.width &&
                        place.hi.y <= view_.height;
    const auto meets = [&](const Rectangle& other) { return place.meets(other); };
    if (!inside || std::ranges::any_of(taken_, meets)) return false;
    taken_.push_back(place);
    made_.labels.push_back(std::move(label));
    return true;
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
