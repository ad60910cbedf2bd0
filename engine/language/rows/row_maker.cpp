#include "engine/language/rows/row_maker.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"

#include <algorithm>
#include <utility>

namespace zeroset {

ParseError RowMaker::error_without_place(std::size_t statement) const {
    const FreeNames& names = reader_.names();
    const bool capital =
        names.has_parameter("X") || names.has_parameter("Y") || names.has_parameter("Z");
    const StatementSyntax& syntax = reader_.tree().statements[statement];
    std::string hint = tr("type an equation such as x^2 + y^2 + z^2 = 1");
    if (capital) hint = tr("write them as small letters");
    if (names.has_parameter("p")) hint = tr("for a point p type p = (x, y, z) in a row of its own");
    if (syntax.leading_sign != '\0')
        hint = filled(tr("to go on with the line above end that with {0}"),
                      {std::string(1, syntax.leading_sign)});
    return {.offset = syntax.offset,
            .reason = tr("there is no x, y or z in it, so it is no surface"),
            .hint = hint};
}

RowResult RowMaker::surface(std::size_t statement, NodeId root, bool solid) {
    GraphValues& values = reader_.values();
    const Node& top = values.builder().node(root);
    const bool is_restricted = top.op == Op::Where;
    if (!values.uses_space(is_restricted ? top.a : root))
        return std::unexpected(error_without_place(statement));
    if (is_restricted && values.never_holds(top.b))
        return values.failure(offset_of(statement), tr("its condition never holds"));
    return RowSurface{.statement = statement, .root = root, .solid = solid};
}

RowResult RowMaker::patch(std::size_t statement, PatchKind kind, const std::array<NodeId, 3>& point,
                          std::string text) {
    GraphValues& values = reader_.values();
    // The condition of a meeting holds the box.
    const auto box = kind == PatchKind::Meeting ? std::nullopt : box_of(statement);
    const NodeId root = make_patch(values.builder(), kind, point, box);
    if (!values.done(root, offset_of(statement))) return values.failure();
    return RowSurface{.statement = statement, .root = root, .text = std::move(text)};
}

std::optional<RowBox> RowMaker::box_of(std::size_t statement) const {
    const std::size_t offset = offset_of(statement);
    const auto found = std::ranges::find_if(
        cuts_, [&](const CutText& cut) { return cut.begin <= offset && offset < cut.end; });
    return found == cuts_.end() ? std::nullopt : std::optional(found->box);
}

std::optional<NodeId> RowMaker::inside_box(std::size_t statement) {
    const auto box = box_of(statement);
    if (!box) return std::nullopt;
    ExprBuilder& builder = reader_.values().builder();
    std::optional<NodeId> all;
    for (std::size_t k = 0; k < 3; ++k) {
        const NodeId at = builder.variable(static_cast<int>(k));
        for (const NodeId one :
             {make_call(builder, Op::LessEqual, builder.constant(box->at(2 * k)), at),
              make_call(builder, Op::LessEqual, at, builder.constant(box->at(2 * k + 1)))})
            all = all ? make_call(builder, Op::And, *all, one) : one;
    }
    return all;
}

std::expected<void, ParseError> RowMaker::cut(RowSurface& surface) {
    GraphValues& values = reader_.values();
    ExprBuilder& builder = values.builder();
    const Node root = builder.node(surface.root);
    if (root.op == Op::Field || !box_of(surface.statement)) return {};
    if (surface.text.empty())
        surface.text = equation_text(builder.finish(surface.root, reader_.names().parameters()));
    NodeId condition = *inside_box(surface.statement);
    const bool is_restricted = root.op == Op::Where;
    if (is_restricted) condition = make_call(builder, Op::And, root.b, condition);
    surface.root = make_call(builder, Op::Where, is_restricted ? root.a : surface.root, condition);
    if (!values.done(surface.root, offset_of(surface.statement))) return values.failure();
    return {};
}

}  // namespace zeroset
