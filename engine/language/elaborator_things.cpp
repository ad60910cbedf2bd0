// Rows that are made of points: segments, vectors and polygons.

#include "engine/base/translation.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/patch_graph.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/elaborator.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

constexpr std::size_t most_corners = 200;
/// How far corners that are numbers may be from the plane of the first ones, in parts of their
/// distances: what is more than rounding is noted, what is more than typing is refused.
constexpr double rounding = 1e-9;
constexpr double flat = 1e-3;

/// a b, without what a part that is 0 or 1 makes superfluous: coordinates are finite.
NodeId times(ExprBuilder& builder, NodeId a, NodeId b) {
    const auto left = exact_value(builder, a);
    const auto right = exact_value(builder, b);
    if (left == 0.0 || right == 0.0) return builder.constant(0.0);
    if (left == 1.0) return b;
    return right == 1.0 ? a : make_multiply(builder, a, b);
}

/// a - b, where one of them may be 0.
NodeId without(ExprBuilder& builder, NodeId a, NodeId b) {
    if (exact_value(builder, b) == 0.0) return a;
    return exact_value(builder, a) == 0.0 ? make_negate(builder, b) : make_subtract(builder, a, b);
}

std::string call_of(const Function& thing) {
    return std::string(thing.name) + "(" + std::string(thing.arguments) + ")";
}

}  // namespace

/// The error for a thing that is used as a value.
std::nullopt_t Elaborator::refuse_thing(const Syntax& syntax) {
    return fail(syntax.offset,
                filled(tr("{0} is drawn by itself, and is no value"), {call_of(*syntax.function)}),
                tr("type it alone in a row"));
}

Elaborator::Point Elaborator::difference(const Point& a, const Point& b) {
    Point result{};
    for (std::size_t k = 0; k < 3; ++k)
        result.at(k) = without(builder_, a.at(k), b.at(k));
    return result;
}

Elaborator::Point Elaborator::cross(const Point& a, const Point& b) {
    Point result{};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3;
        const std::size_t j = (k + 2) % 3;
        result.at(k) =
            without(builder_, times(builder_, a.at(i), b.at(j)), times(builder_, a.at(j), b.at(i)));
    }
    return result;
}

NodeId Elaborator::dot(const Point& a, const Point& b) {
    NodeId sum = times(builder_, a[0], b[0]);
    for (std::size_t k = 1; k < 3; ++k) {
        const NodeId next = times(builder_, a.at(k), b.at(k));
        const bool adds = exact_value(builder_, next) != 0.0;
        if (adds) sum = exact_value(builder_, sum) == 0.0 ? next : make_add(builder_, sum, next);
    }
    return sum;
}

/// Whether all parts of a vector are known to be 0.
bool Elaborator::is_zero(const Point& way, std::size_t offset) {
    return std::ranges::all_of(way, [&](NodeId id) {
        return done(id, offset).has_value() && values_.middle_of(id) == 0.0;
    });
}

/// Makes sure that an argument of a thing is a point of numbers.
bool Elaborator::check_corner(const Value& value, const Syntax& call, std::size_t place) {
    const std::size_t offset = tree_[call.operands[place]].offset;
    const auto point = value.point();
    if (!point) {
        fail(offset,
             filled(tr("{0} is made of points of 3 numbers, and this is {1}"),
                    {call_of(*call.function), value.described()}),
             filled(tr("type a point such as {0}, or the name of one"), {"(1, 2, 3)"}));
        return false;
    }
    if (std::ranges::none_of(*point, [&](NodeId id) { return values_.uses_space(id); }))
        return true;
    fail(offset,
         filled(tr("{0} is made of points that are numbers, not of x, y and z"),
                {call_of(*call.function)}),
         filled(tr("type a point such as {0}, or the name of one"), {"(1, 2, 3)"}));
    return false;
}

/// The points of a call, and how it is read.
std::optional<std::vector<Elaborator::Point>> Elaborator::corners_of(const Syntax& call,
                                                                     std::string& text) {
    std::vector<Point> points;
    text = std::string(call.function->name) + "(";
    if (call.operands.size() > most_corners) {
        return fail(
            tree_[call.operands[most_corners]].offset,
            filled(tr("a polygon has at most {0} corners"), {std::to_string(most_corners)}));
    }
    for (std::size_t i = 0; i < call.operands.size(); ++i) {
        const Built value = operand(call.operands[i], nullptr);
        if (!value || !check_corner(*value, call, i)) return std::nullopt;
        points.push_back(*value->point());
        text += (i > 0 ? ", " : "") + text_of(*value, parameters_);
    }
    text += ")";
    return points;
}

/// Builds a row such as segment(P, Q).
bool Elaborator::build_thing(std::size_t index, const Function& thing) {
    const StatementSyntax& statement = tree_.statements[index];
    if (!statement.restrictions.empty()) {
        fail(tree_[statement.restrictions.front()].offset,
             filled(tr("nothing stands behind {0}"), {call_of(thing)}),
             tr("cut it by a box of its own, the clip box or a section"));
        return false;
    }
    std::string text;
    const auto points = corners_of(tree_[statement.relation], text);
    if (!points) return false;
    if (thing.name == "polygon") return build_polygon(index, *points, std::move(text));
    return build_straight(index, thing, *points, std::move(text));
}

/// Builds a segment or an arrow: a point for each x in [0, 1].
bool Elaborator::build_straight(std::size_t index, const Function& thing,
                                const std::vector<Point>& ends, std::string text) {
    const Syntax& call = tree_[tree_.statements[index].relation];
    const bool is_arrow = thing.name == "vector";
    const Point way = is_arrow ? ends[1] : difference(ends[1], ends[0]);
    if (is_zero(way, call.offset)) {
        fail(tree_[call.operands[1]].offset,
             is_arrow ? tr("this vector has no length") : tr("both ends are the same point"),
             is_arrow ? tr("type a vector such as (0, 0, 1)")
                      : tr("type two different points, or one point alone"));
        return false;
    }
    if (values_.failed()) return false;
    Point at{};
    for (std::size_t k = 0; k < 3; ++k) {
        const NodeId along = make_multiply(builder_, builder_.variable(0), way.at(k));
        at.at(k) = make_add(builder_, ends[0].at(k), along);
    }
    return add_patch(index, is_arrow ? PatchKind::Arrow : PatchKind::Segment, at, std::move(text));
}

/// Whether corners that are numbers lie in one plane, as well as they were typed. Those that do not
/// quite, and those that sliders move, are taken onto the plane of best fit, and a note says so.
bool Elaborator::check_plane(const std::vector<Point>& corners, const Point& normal,
                             const Syntax& call) {
    double size = 0.0;
    for (const NodeId id : normal) {
        if (!done(id, call.offset)) return false;
        size = std::hypot(size, values_.middle_of(id).value_or(0.0));
    }
    bool is_flat = true;
    for (std::size_t i = 3; i < corners.size(); ++i) {
        const Point way = difference(corners[i], corners[0]);
        const NodeId height = dot(way, normal);
        double reach = 0.0;
        for (const NodeId id : way) {
            if (!done(id, call.offset)) return false;
            reach = std::hypot(reach, values_.middle_of(id).value_or(0.0));
        }
        if (!done(height, call.offset)) return false;
        const auto known = values_.middle_of(height);
        const double off = std::abs(known.value_or(0.0));
        is_flat = is_flat && known && off <= rounding * size * reach;
        if (!known || off <= flat * size * reach) continue;
        fail(tree_[call.operands[i]].offset,
             filled(tr("corner {0} is not in the plane of the others"), {std::to_string(i + 1)}),
             tr("type several polygons, such as triangles"));
        return false;
    }
    if (!is_flat)
        note(call.offset, tr("corners beside the plane that fits best are taken onto it"));
    return true;
}

/// Whether each corner is known to be on the inner side of each edge. In numbers: nodes would be as
/// many as the square of the corners.
bool Elaborator::is_convex(const std::vector<Point>& corners, const Point& normal) {
    if (corners.size() == 3) return true;
    const auto numbers_of = [&](const Point& point) -> std::optional<glm::dvec3> {
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
    for (const Point& corner : corners) {
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
NodeId Elaborator::inside_polygon(const std::vector<Point>& corners, const Point& normal,
                                  bool convex) {
    const auto both = [&](NodeId a, NodeId b) { return make_call(builder_, Op::And, a, b); };
    const auto no = [&](NodeId a) { return make_call(builder_, Op::Not, a); };
    const auto less = [&](NodeId a, NodeId b) { return make_call(builder_, Op::Less, a, b); };
    const NodeId zero = builder_.constant(0.0);
    const Point place{builder_.variable(0), builder_.variable(1), builder_.variable(2)};
    const Point up = difference(corners[1], corners[0]);
    const auto height = [&](const Point& of) { return dot(up, difference(of, corners[0])); };
    const NodeId at = height(place);
    std::optional<NodeId> all;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point& from = corners[i];
        const Point& to = corners[(i + 1) % corners.size()];
        const NodeId side = dot(cross(normal, difference(to, from)), difference(place, from));
        if (convex) {
            const NodeId inner = less(zero, side);
            all = all ? both(*all, inner) : inner;
            continue;
        }
        const NodeId above_from = less(height(from), at);
        const NodeId above_to = less(height(to), at);
        const NodeId up_left = both(both(above_from, no(above_to)), less(zero, side));
        const NodeId down_right = both(both(above_to, no(above_from)), less(side, zero));
        const NodeId crosses = make_call(builder_, Op::Or, up_left, down_right);
        const NodeId turned =
            make_call(builder_, Op::If, crosses, builder_.constant(-1.0), builder_.constant(1.0));
        all = all ? make_multiply(builder_, *all, turned) : turned;
    }
    return convex ? *all : less(*all, zero);
}

/// Builds a polygon as the equation of its plane, restricted to where it is.
bool Elaborator::build_polygon(std::size_t index, const std::vector<Point>& corners,
                               std::string text) {
    const Syntax& call = tree_[tree_.statements[index].relation];
    // Newell's normal: of twice the area's length.
    Point normal = cross(difference(corners[1], corners[0]), difference(corners[2], corners[0]));
    for (std::size_t i = 2; i + 1 < corners.size(); ++i) {
        const Point next =
            cross(difference(corners[i], corners[0]), difference(corners[i + 1], corners[0]));
        for (std::size_t k = 0; k < 3; ++k)
            normal.at(k) = make_add(builder_, normal.at(k), next.at(k));
    }
    if (is_zero(normal, call.offset)) {
        fail(call.offset, tr("this polygon has no area: its corners lie on a line"),
             tr("type corners of which three are on no line"));
        return false;
    }
    if (values_.failed() || !check_plane(corners, normal, call)) return false;
    Point middle = corners[0];
    if (corners.size() > 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            NodeId sum = corners[0].at(k);
            for (std::size_t i = 1; i < corners.size(); ++i)
                sum = make_add(builder_, sum, corners[i].at(k));
            const NodeId count = builder_.constant(static_cast<double>(corners.size()));
            middle.at(k) = make_divide(builder_, sum, count);
        }
    }
    const Point place{builder_.variable(0), builder_.variable(1), builder_.variable(2)};
    const NodeId f = dot(normal, difference(place, middle));
    const NodeId inside = inside_polygon(corners, normal, is_convex(corners, normal));
    const NodeId root = make_call(builder_, Op::Where, f, inside);
    if (values_.failed() || !done(root, call.offset) || !add_surface(index, root)) return false;
    surfaces_.back().text = std::move(text);
    surfaces_.back().sheet = true;
    return true;
}

}  // namespace zeroset
