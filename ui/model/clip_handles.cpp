#include "ui/model/clip_handles.hpp"

#include "engine/view/pixel_ray.hpp"
#include "ui/model/drag_places.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace zeroset::ui {
namespace {

/// A line is seen end-on where the sine of its angle with the ray is below this.
constexpr double end_on = 0.12;
/// Where a section's arrow ends and the handle is that moves it, as a part of the stem.
constexpr double arrow_part = 0.68;
/// A drag takes nothing farther than this, in sizes of the box.
constexpr double farthest = 20.0;
constexpr double thinnest = 1e-3;  ///< of the box's size
/// A normal that is turned this near an axis becomes it.
constexpr double almost_axis = 0.9994;

/// In the drawn world (Camera).
glm::dvec3 ray_direction(const ViewFrame& view, const glm::dvec3& point) {
    return view.parallel() ? view.forward : glm::normalize(view.stretch * point - view.eye);
}

bool is_end_on(const ViewFrame& view, const glm::dvec3& at, const glm::dvec3& along) {
    const glm::dvec3 drawn = glm::normalize(view.stretch * along);
    return glm::length(glm::cross(drawn, ray_direction(view, at))) < end_on;
}

/// Drawn lengths per height of the picture where the point is.
double height_at(const ViewFrame& view, const glm::dvec3& point) {
    return 2.0 * view.homogeneous(point).z;
}

glm::dvec2 vector(const ViewPoint& place) { return {place.x, place.y}; }

/// How far along a line from `at` the point is that shows nearest to `place`, measured along the
/// line in the picture. Nothing beyond its vanishing point.
std::optional<double> along_line(const ViewFrame& view, const glm::dvec3& at,
                                 const glm::dvec3& along, const ViewPoint& place) {
    const glm::dvec3 from = view.homogeneous(at);
    const glm::dvec3 step = view.homogeneous(at + along) - from;
    const glm::dvec2 course = glm::normalize(glm::dvec2(step) * from.z - glm::dvec2(from) * step.z);
    const double aim = 2.0 * glm::dot(vector(place), course);
    const double slope = glm::dot(glm::dvec2(step), course) - aim * step.z;
    const double s = (aim * from.z - glm::dot(glm::dvec2(from), course)) / slope;
    const bool before_eye = slope > 0 && from.z + s * step.z > 0;
    return before_eye ? std::optional(s) : std::nullopt;
}

glm::dvec3 face_normal(std::size_t face) {
    glm::dvec3 normal(0.0);
    normal[static_cast<int>(face / 2)] = face % 2 == 1 ? 1.0 : -1.0;
    return normal;
}

glm::dvec3 face_middle(const Box& box, std::size_t face) {
    const int axis = static_cast<int>(face / 2);
    glm::dvec3 middle = box.centre();
    middle[axis] = face % 2 == 1 ? box.hi[axis] : box.lo[axis];
    return middle;
}

/// Point of the section nearest to the middle of the box.
glm::dvec3 section_middle(const Section& section, const Box& box) {
    const glm::dvec3 centre = box.centre();
    return centre + (section.offset - glm::dot(section.normal, centre)) * section.normal;
}

void add_ball(std::vector<Handle>& handles, const Ball& ball, const ViewFrame& view) {
    // Off the axes, so that no face's handle stands there.
    const glm::dvec3 outward = std::numbers::sqrt2 / 2 * (view.right + view.up);
    const glm::dvec3 rim = ball.centre + ball.radius * outward;
    handles.push_back(
        {.id = {.part = HandlePart::BallCentre}, .from = ball.centre, .at = ball.centre});
    handles.push_back({.id = {.part = HandlePart::BallRadius}, .from = rim, .at = rim});
}

void add_section(std::vector<Handle>& handles, std::size_t index, const Clipping& clipping,
                 const ViewFrame& view, double stem) {
    const Section& section = clipping.region.sections[index];
    const glm::dvec3 from = section_middle(section, clipping.clip);
    const double drawn = glm::length(view.stretch * section.normal);
    const glm::dvec3 reach = stem * height_at(view, from) / drawn * section.normal;
    if (!is_end_on(view, from, section.normal)) {
        handles.push_back({.id = {.part = HandlePart::SectionPlace, .index = index},
                           .from = from,
                           .at = from + arrow_part * reach,
                           .along = section.normal});
    }
    handles.push_back({.id = {.part = HandlePart::SectionTilt, .index = index},
                       .from = from,
                       .at = from + reach});
}

double distance_to_stem(const glm::dvec2& from, const glm::dvec2& at, const glm::dvec2& cursor) {
    const glm::dvec2 stem = at - from;
    const double squared = glm::dot(stem, stem);
    const double part =
        squared > 0 ? std::clamp(glm::dot(cursor - from, stem) / squared, 0.0, 1.0) : 1.0;
    return glm::distance(cursor, from + part * stem);
}

glm::dvec3 rounded(const glm::dvec3& point, double pixel) {
    return {rounded_to_pixel(point.x, pixel), rounded_to_pixel(point.y, pixel),
            rounded_to_pixel(point.z, pixel)};
}

Box moved_face(const Box& start, std::size_t face, double place, const DragKeys& keys,
               const glm::dvec3& stretch) {
    const int axis = static_cast<int>(face / 2);
    const bool upper = face % 2 == 1;
    const double gap = thinnest * stretched(start, stretch).size() / stretch[axis];
    const double middle = start.centre()[axis];
    const bool both = keys.shift || keys.ctrl;
    const double limit = both    ? middle + (upper ? 0.5 : -0.5) * gap
                         : upper ? start.lo[axis] + gap
                                 : start.hi[axis] - gap;
    Box box = start;
    (upper ? box.hi : box.lo)[axis] = upper ? std::max(place, limit) : std::min(place, limit);
    if (!both) return box;
    const double half = std::abs((upper ? box.hi : box.lo)[axis] - middle);
    const double factor = 2.0 * half / (start.hi[axis] - start.lo[axis]);
    if (keys.ctrl) return scaled(start, factor);
    (upper ? box.lo : box.hi)[axis] = upper ? middle - half : middle + half;
    return box;
}

/// The direction of the 26 to faces, edges and corners of a cube nearest to `normal`.
glm::dvec3 even_direction(const glm::dvec3& normal) {
    glm::dvec3 best(0.0);
    for (int i = 0; i < 27; ++i) {
        const glm::dvec3 candidate(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (candidate == glm::dvec3(0.0)) continue;
        const glm::dvec3 direction = glm::normalize(candidate);
        if (glm::dot(direction, normal) > glm::dot(best, normal)) best = direction;
    }
    return best;
}

glm::dvec3 settled(const glm::dvec3& normal, const DragKeys& keys) {
    const glm::dvec3 even = even_direction(normal);
    const bool is_axis = glm::dot(even, even) == 1.0 && std::abs(even.x + even.y + even.z) == 1.0;
    const bool near_axis = is_axis && glm::dot(even, normal) > almost_axis;
    return keys.shift || near_axis ? even : normal;
}

/// From the middle of a ball to where the ray through `place` meets it, on the side towards the eye
/// or away from it as `was` is; to the rim for rays that pass. Length 1, in the drawn world, as
/// `radius` and `was` are.
glm::dvec3 turned(const ViewFrame& view, const glm::dvec3& middle, double radius,
                  const glm::dvec3& was, const ViewPoint& place) {
    const PixelRay ray = pixel_ray(view, place);
    const glm::dvec3 to = ray.origin - view.stretch * middle;
    const double nearest = -glm::dot(to, ray.direction);
    const glm::dvec3 aside = to + nearest * ray.direction;
    const double half = std::sqrt(std::max(radius * radius - glm::dot(aside, aside), 0.0));
    const bool behind = glm::dot(was, ray_direction(view, middle)) > 0;
    return glm::normalize(aside + (behind ? half : -half) * ray.direction);
}

/// Where a held handle is to go.
struct Aim {
    const ViewFrame& view;
    ViewPoint place;
    double pixel;  ///< in the drawn world

    /// A pixel's part of the typed lengths along a direction.
    [[nodiscard]] double pixel_along(const glm::dvec3& direction) const {
        return pixel / glm::length(view.stretch * direction);
    }
};

/// How far the handle goes along its line, within bounds.
std::optional<double> moved_by(const HandleDrag& drag, const Aim& aim) {
    const auto s = along_line(aim.view, drag.handle.at, drag.handle.along, aim.place);
    if (!s) return std::nullopt;
    const double most = farthest * drag.start.clip.size();
    return std::clamp(*s, -most, most);
}

Clipping with_face(const HandleDrag& drag, const Aim& aim, const DragKeys& keys) {
    const auto s = moved_by(drag, aim);
    if (!s) return drag.last;
    const Handle& handle = drag.handle;
    const int axis = static_cast<int>(handle.id.index / 2);
    const double place =
        rounded_to_pixel((handle.at + *s * handle.along)[axis], aim.pixel_along(handle.along));
    Clipping result = drag.start;
    result.clip = moved_face(drag.start.clip, handle.id.index, place, keys, aim.view.stretch);
    return result;
}

Clipping with_centre(const HandleDrag& drag, const Aim& aim) {
    Clipping result = drag.start;
    glm::dvec3& centre = result.region.ball->centre;
    centre = rounded(across_view(aim.view, centre, aim.place), aim.pixel);
    return result;
}

Clipping with_radius(const HandleDrag& drag, const Aim& aim) {
    Clipping result = drag.start;
    Ball& ball = *result.region.ball;
    const glm::dvec3 rim = across_view(aim.view, ball.centre, aim.place);
    ball.radius = std::max(rounded_to_pixel(glm::distance(rim, ball.centre), aim.pixel), aim.pixel);
    return result;
}

Clipping with_place(const HandleDrag& drag, const Aim& aim) {
    const auto s = moved_by(drag, aim);
    if (!s) return drag.last;
    Clipping result = drag.start;
    double& offset = result.region.sections[drag.handle.id.index].offset;
    offset = rounded_to_pixel(offset + *s, aim.pixel_along(drag.handle.along));
    return result;
}

Clipping with_tilt(const HandleDrag& drag, const Aim& aim, const DragKeys& keys) {
    Clipping result = drag.start;
    Section& section = result.region.sections[drag.handle.id.index];
    const glm::dvec3& stretch = aim.view.stretch;
    const glm::dvec3 middle = drag.handle.from;
    const double radius = glm::length(stretch * (drag.handle.at - middle));
    const glm::dvec3 drawn = turned(aim.view, middle, radius, stretch * section.normal, aim.place);
    section.normal = settled(glm::normalize(drawn / stretch), keys);
    section.offset =
        rounded_to_pixel(glm::dot(section.normal, middle), aim.pixel_along(section.normal));
    return result;
}

}  // namespace

std::vector<Handle> clip_handles(const Clipping& clipping, const ViewFrame& view, double stem) {
    std::vector<Handle> handles;
    for (std::size_t face = 0; face < 6; ++face) {
        const glm::dvec3 at = face_middle(clipping.clip, face);
        const glm::dvec3 along = face_normal(face);
        if (is_end_on(view, at, along)) continue;
        handles.push_back({.id = {.part = HandlePart::BoxFace, .index = face},
                           .from = at,
                           .at = at,
                           .along = along});
    }
    if (clipping.region.ball) add_ball(handles, *clipping.region.ball, view);
    for (std::size_t i = 0; i < clipping.region.sections.size(); ++i)
        add_section(handles, i, clipping, view, stem);
    return handles;
}

std::optional<Handle> handle_under(std::span<const Handle> handles, const ViewFrame& view,
                                   const ViewPoint& cursor, double reach) {
    std::optional<Handle> found;
    for (const Handle& handle : handles) {
        const auto from = place_in_view(view, handle.from);
        const auto at = place_in_view(view, handle.at);
        if (!from || !at) continue;
        // The ball at the tip, not the plane's middle, turns a section.
        const bool has_stem = handle.id.part == HandlePart::SectionPlace;
        const double off = distance_to_stem(vector(has_stem ? from->place : at->place),
                                            vector(at->place), vector(cursor));
        if (off > reach) continue;
        reach = off;
        found = handle;
    }
    return found;
}

HandleDrag grabbed(const Handle& handle, const Clipping& clipping, const ViewFrame& view,
                   const ViewPoint& cursor) {
    const auto seen = place_in_view(view, handle.at);
    return {.handle = handle,
            .start = clipping,
            .last = clipping,
            .off = seen ? seen->place - cursor : ViewShift()};
}

Clipping dragged(const HandleDrag& drag, const ViewFrame& view, const ViewPoint& cursor,
                 int height_px, const DragKeys& keys) {
    const Aim aim{.view = view,
                  .place = cursor + drag.off,
                  .pixel = height_at(view, drag.handle.at) / height_px};
    switch (drag.handle.id.part) {
        case HandlePart::BoxFace: return with_face(drag, aim, keys);
        case HandlePart::BallCentre: return with_centre(drag, aim);
        case HandlePart::BallRadius: return with_radius(drag, aim);
        case HandlePart::SectionPlace: return with_place(drag, aim);
        case HandlePart::SectionTilt: return with_tilt(drag, aim, keys);
    }
    return drag.last;
}

void hold(std::vector<Handle>& handles, const HandleDrag& drag, const Clipping& clipping) {
    const HandleId id = drag.handle.id;
    if (id.part != HandlePart::SectionTilt || id.index >= clipping.region.sections.size()) return;
    const glm::dvec3 normal = clipping.region.sections[id.index].normal;
    const double stem = glm::distance(drag.handle.at, drag.handle.from);
    for (Handle& handle : handles) {
        const bool tilts = handle.id == id;
        if (!tilts && handle.id != HandleId{.part = HandlePart::SectionPlace, .index = id.index})
            continue;
        handle.from = drag.handle.from;
        handle.at = handle.from + (tilts ? stem : arrow_part * stem) * normal;
    }
}

}  // namespace zeroset::ui
