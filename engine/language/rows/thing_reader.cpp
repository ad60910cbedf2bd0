// Points of things, segments and vectors.

#include "engine/language/rows/thing_reader.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/expressions/calls.hpp"

#include <algorithm>
#include <utility>

namespace zeroset {
namespace {

constexpr std::size_t most_corners = 200;

}  // namespace

bool ThingReader::may_read(std::size_t statement) const {
    const SyntaxTree& tree = reader_.tree();
    const Syntax& relation = tree[tree.statements[statement].relation];
    return relation.kind == SyntaxKind::Call && relation.function != nullptr &&
           relation.function->is_thing();
}

/// Whether all parts of a vector are known to be 0.
bool ThingReader::is_zero(const VectorNodes& way, std::size_t offset) {
    return std::ranges::all_of(way, [&](NodeId id) {
        return values_.done(id, offset).has_value() && values_.middle_of(id) == 0.0;
    });
}

/// Makes sure that an argument of a thing is a point of numbers.
bool ThingReader::check_corner(const BuiltValue& value, const Syntax& call, std::size_t place) {
    const std::size_t offset = reader_.tree()[call.operands[place]].offset;
    const auto point = value.point();
    if (!point) {
        values_.fail(offset,
                     filled(tr("{0} is made of points of 3 numbers, and this is {1}"),
                            {call_of(*call.function), value.described()}),
                     filled(tr("type a point such as {0}, or the name of one"), {"(1, 2, 3)"}));
        return false;
    }
    if (std::ranges::none_of(*point, [&](NodeId id) { return values_.uses_space(id); }))
        return true;
    values_.fail(offset,
                 filled(tr("{0} is made of points that are numbers, not of x, y and z"),
                        {call_of(*call.function)}),
                 filled(tr("type a point such as {0}, or the name of one"), {"(1, 2, 3)"}));
    return false;
}

/// The points of a call, and how it is read.
std::optional<ThingReader::Corners> ThingReader::corners_of(const Syntax& call,
                                                            std::size_t statement,
                                                            std::string& text) {
    Corners points;
    text = std::string(call.function->name) + "(";
    if (call.operands.size() > most_corners) {
        return values_.fail(
            reader_.tree()[call.operands[most_corners]].offset,
            filled(tr("a polygon has at most {0} corners"), {std::to_string(most_corners)}));
    }
    for (std::size_t i = 0; i < call.operands.size(); ++i) {
        const auto value = reader_.operand(call.operands[i], {.statement = statement});
        if (!value || !check_corner(*value, call, i)) return std::nullopt;
        points.push_back(*value->point());
        text += (i > 0 ? ", " : "") + text_.of(*value);
    }
    text += ")";
    return points;
}

RowResult ThingReader::read(std::size_t statement) {
    const StatementSyntax& row = reader_.tree().statements[statement];
    const Syntax& call = reader_.tree()[row.relation];
    if (!row.restrictions.empty()) {
        return values_.failure(reader_.tree()[row.restrictions.front()].offset,
                               filled(tr("nothing stands behind {0}"), {call_of(*call.function)}),
                               tr("cut it by a box of its own, the clip box or a section"));
    }
    std::string text;
    const auto corners = corners_of(call, statement, text);
    if (!corners) return values_.failure();
    if (call.function->name == "polygon") return polygon(statement, *corners, std::move(text));
    return straight(statement, *corners, std::move(text));
}

/// A segment or an arrow: a point for each x in [0, 1].
RowResult ThingReader::straight(std::size_t statement, const Corners& ends, std::string text) {
    ExprBuilder& builder = values_.builder();
    const Syntax& call = reader_.tree()[reader_.tree().statements[statement].relation];
    const bool is_arrow = call.function->name == "vector";
    const VectorNodes way = is_arrow ? ends[1] : make_difference(builder, ends[1], ends[0]);
    if (is_zero(way, call.offset)) {
        return values_.failure(
            reader_.tree()[call.operands[1]].offset,
            is_arrow ? tr("this vector has no length") : tr("both ends are the same point"),
            is_arrow ? tr("type a vector such as (0, 0, 1)")
                     : tr("type two different points, or one point alone"));
    }
    if (values_.failed()) return values_.failure();
    VectorNodes at{};
    for (std::size_t k = 0; k < 3; ++k) {
        const NodeId along = make_multiply(builder, builder.variable(0), way.at(k));
        at.at(k) = make_add(builder, ends[0].at(k), along);
    }
    return maker_.patch(statement, is_arrow ? PatchKind::Arrow : PatchKind::Segment, at,
                        std::move(text));
}

}  // namespace zeroset
