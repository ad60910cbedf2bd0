// Polygons: the part of a plane within corners.

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/rows/thing_reader.hpp"

#include <glm/glm.hpp>

#include <cmath>
#include <utility>

namespace zeroset {
namespace {

/// How far corners that are numbers may be from the plane of the first ones, in parts of their
/// distances: what is more than rounding is noted, what is more than typing is refused.
constexpr double rounding = 1e-9;
constexpr double flat = 1e-3;

}  // namespace

/// Whether corners that are numbers lie in one plane, as well as they were typed. Those that do not
/// quite, and those that sliders move, are taken onto the plane of best fit, and a note says so.
bool ThingReader::check_plane(const Corners& corners, const VectorNodes& normal,
                              const Syntax& call) {
    ExprBuilder& builder = values_.builder();
    double size = 0.0;
    for (const NodeId id : normal) {
        if (!values_.done(id, call.offset)) return false;
        size = std::hypot(size, values_.middle_of(id).value_or(0.0));
    }
    bool is_flat = true;
    for (std::size_t i = 3; i < corners.size(); ++i) {
        const VectorNodes way = make_difference(builder, corners[i], corners[0]);
        const NodeId height = make_dot(builder, way, normal);
        double reach = 0.0;
        for (const NodeId id : way) {
            if (!values_.done(id, call.offset)) return false;
            reach = std::hypot(reach, values_.middle_of(id).value_or(0.0));
        }
        if (!values_.done(height, call.offset)) return false;
        const auto known = values_.middle_of(height);
        const double off = std::abs(known.value_or(0.0));
        is_flat = is_flat && known && off <= rounding * size * reach;
        if (!known || off <= flat * size * reach) continue;
        values_.fail(
            reader_.tree()[call.operands[i]].offset,
            filled(tr("corner {0} is not in the plane of the others"), {std::to_string(i + 1)}),
            tr("type several polygons, such as triangles"));
        return false;
    }
    if (!is_flat)
        values_.note(call.offset, tr("corners beside the plane that fits best are taken onto it"));
    return true;
}

/// Whether each corner is known to be on the inner side of each edge. In numbers: nodes would be as
/// many as the square of the corners.
bool ThingReader::is_convex(const Corners& corners, const VectorNodes& normal) const {
    if (corners.size() == 3) return true;
    const auto numbers_of = [&](const VectorNodes& point) -> std::optional<glm::dvec3> {
        glm::dvec3 numbers(0.0);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto middle = values_.middle_of(point.at(k));
            if (!middle) return std::nullopt;
            numbers[static_cast<int>(k)] = *middle;
        }
        return numbers;
    };
    const auto up = numbers_of(normal);
    if (!up) return false;
    std::vector<glm::dvec3> places;
    for (const VectorNodes& corner : corners) {
        const auto place = numbers_of(corner);
        if (!place) return false;
        places.push_back(*place);
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        const glm::dvec3 inwards = glm::cross(*up, places[(i + 1) % places.size()] - places[i]);
        for (const glm::dvec3& place : places) {
            if (glm::dot(inwards, place - places[i]) < 0.0) return false;
        }
    }
    return true;
}

/// The condition that (x, y, z), moved along the normal, is in a polygon: on the inner side of all
/// edges, or where a ray from it crosses an odd number of them, so that a sign that each crossing
/// turns ends below 0.
NodeId ThingReader::inside_polygon(const Corners& corners, const VectorNodes& normal, bool convex) {
    ExprBuilder& builder = values_.builder();
    const auto both = [&](NodeId a, NodeId b) { return make_call(builder, Op::And, a, b); };
    const auto no = [&](NodeId a) { return make_call(builder, Op::Not, a); };
    const auto less = [&](NodeId a, NodeId b) { return make_call(builder, Op::Less, a, b); };
    const NodeId zero = builder.constant(0.0);
    const VectorNodes place = make_place(builder);
    const auto between = [&](const VectorNodes& from, const VectorNodes& to) {
        return make_difference(builder, to, from);
    };
    const VectorNodes up = between(corners[0], corners[1]);
    const auto height = [&](const VectorNodes& of) {
        return make_dot(builder, up, between(corners[0], of));
    };
    const NodeId at = height(place);
    std::optional<NodeId> all;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const VectorNodes& from = corners[i];
        const VectorNodes& to = corners[(i + 1) % corners.size()];
        const VectorNodes inwards = make_cross(builder, normal, between(from, to));
        const NodeId side = make_dot(builder, inwards, between(from, place));
        if (convex) {
            const NodeId inner = less(zero, side);
            all = all ? both(*all, inner) : inner;
            continue;
        }
        const NodeId above_from = less(height(from), at);
        const NodeId above_to = less(height(to), at);
        const NodeId up_left = both(both(above_from, no(above_to)), less(zero, side));
        const NodeId down_right = both(both(above_to, no(above_from)), less(side, zero));
        const NodeId crosses = make_call(builder, Op::Or, up_left, down_right);
        const NodeId turned =
            make_call(builder, Op::If, crosses, builder.constant(-1.0), builder.constant(1.0));
        all = all ? make_multiply(builder, *all, turned) : turned;
    }
    return convex ? *all : less(*all, zero);
}

/// Builds a polygon as the equation of its plane, restricted to where it is.
RowResult ThingReader::polygon(std::size_t statement, const Corners& corners, std::string text) {
    ExprBuilder& builder = values_.builder();
    const Syntax& call = reader_.tree()[reader_.tree().statements[statement].relation];
    const auto edge = [&](std::size_t i) {
        return make_difference(builder, corners[i], corners[0]);
    };
    // Newell's normal: of twice the area's length.
    const VectorNodes second = edge(1);
    VectorNodes normal = make_cross(builder, second, edge(2));
    for (std::size_t i = 2; i + 1 < corners.size(); ++i) {
        const VectorNodes from = edge(i);
        normal = make_sum(builder, normal, make_cross(builder, from, edge(i + 1)));
    }
    if (is_zero(normal, call.offset)) {
        return values_.failure(call.offset,
                               tr("this polygon has no area: its corners lie on a line"),
                               tr("type corners of which three are on no line"));
    }
    if (values_.failed() || !check_plane(corners, normal, call)) return values_.failure();
    VectorNodes middle = corners[0];
    if (corners.size() > 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            NodeId sum = corners[0].at(k);
            for (std::size_t i = 1; i < corners.size(); ++i)
                sum = make_add(builder, sum, corners[i].at(k));
            const NodeId count = builder.constant(static_cast<double>(corners.size()));
            middle.at(k) = make_divide(builder, sum, count);
        }
    }
    const VectorNodes place = make_place(builder);
    const NodeId f = make_dot(builder, normal, make_difference(builder, place, middle));
    const NodeId inside = inside_polygon(corners, normal, is_convex(corners, normal));
    const NodeId root = make_call(builder, Op::Where, f, inside);
    if (!values_.done(root, call.offset)) return values_.failure();
    RowResult result = maker_.surface(statement, root);
    if (result) {
        result->text = std::move(text);
        result->sheet = true;
    }
    return result;
}

}  // namespace zeroset
