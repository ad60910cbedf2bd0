#include "engine/language/rows/patch_reader.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace zeroset {
namespace {

/// The first number of the parameters that stand for the variables of a row while it is looked at.
constexpr int first_variable = variable_w + 1 + static_cast<int>(ProgramLimits::parameters);

constexpr const char* example = "(u cos v, u sin v, v), 0 < u < 1, 0 < v < 2 pi";

bool is_ascending(std::string_view marks) {
    return marks.find_first_not_of("<l") == std::string_view::npos;
}

bool is_descending(std::string_view marks) {
    return marks.find_first_not_of(">g") == std::string_view::npos;
}

bool is_axis_name(std::string_view name) { return name == "x" || name == "y" || name == "z"; }

const LocalName* innermost(const std::vector<LocalName>& names) {
    return names.empty() ? nullptr : &names.back();
}

}  // namespace

/// One row: its ranges, and the values that its variables have while it is read. All functions
/// return nothing or false after an error, which is in the values.
class PatchReader::OneRow {
public:
    OneRow(PatchReader& of, std::size_t statement, const Ranges& ranges)
        : reader_(of.reader_),
          values_(of.reader_.values()),
          index_(statement),
          ranges_(ranges),
          point_(of.point_in(reader_.tree().statements[statement])),
          scope_(of.variables_.going_by(names_of(ranges))) {}

    /// The variables themselves, as parameters of their own.
    std::optional<std::vector<LocalName>> bind_names();
    /// The values of the variables: x and y of the graph run over [0, 1] for them.
    std::optional<std::vector<LocalName>> bind_ranges();
    /// The point that the row is; nothing, and perhaps no error, where it is no vector of 3.
    std::optional<std::array<NodeId, 3>> point_over(const std::vector<LocalName>& variables);
    /// Whether each range goes by variables of ranges before it alone; `names`: from bind_names.
    bool check_order(const std::vector<LocalName>& names);
    /// The first of the usual names of variables that the row uses without saying what it is;
    /// empty: there is none.
    [[nodiscard]] std::string open_variable() const;
    /// How the row is read: the vector and the ranges, with every operator written out.
    std::string text(const std::array<NodeId, 3>& point, const std::vector<LocalName>& names,
                     const ReadingText& writer);

private:
    static std::vector<std::string> names_of(const Ranges& ranges);
    [[nodiscard]] Context with(const LocalName* innermost_name) {
        return {.statement = index_, .scope = innermost_name, .row = &scope_};
    }

    ExpressionReader& reader_;
    GraphValues& values_;
    std::size_t index_;
    const Ranges& ranges_;
    SyntaxId point_;
    RowScope scope_;
};

std::vector<std::string> PatchReader::OneRow::names_of(const Ranges& ranges) {
    std::vector<std::string> names;
    names.reserve(ranges.size());
    for (const Ranged& range : ranges)
        names.push_back(range.name);
    return names;
}

std::optional<std::vector<LocalName>> PatchReader::OneRow::bind_names() {
    std::vector<LocalName> names;
    names.reserve(ranges_.size());
    for (const Ranged& range : ranges_) {
        const LocalName* const outer = innermost(names);
        const NodeId variable =
            values_.builder().variable(first_variable + static_cast<int>(names.size()));
        if (!values_.done(variable, range.offset)) return std::nullopt;
        names.push_back({.name = range.name, .value = {.id = variable}, .outer = outer});
    }
    return names;
}

std::optional<std::vector<LocalName>> PatchReader::OneRow::bind_ranges() {
    ExprBuilder& builder = values_.builder();
    std::vector<LocalName> shares;
    shares.reserve(ranges_.size());
    for (const Ranged& range : ranges_) {
        const LocalName* const outer = innermost(shares);
        scope_.bind(outer);
        const auto lo = reader_.number(range.lo, with(outer));
        const auto hi = lo ? reader_.number(range.hi, with(outer)) : std::nullopt;
        if (!hi) return std::nullopt;
        const NodeId width = make_subtract(builder, *hi, *lo);
        const NodeId share = builder.variable(static_cast<int>(shares.size()));
        const NodeId value = make_add(builder, *lo, make_multiply(builder, width, share));
        if (!values_.done(value, range.offset)) return std::nullopt;
        const auto& constant = values_.facts(width).constant;
        if (constant && constant->hi <= 0.0) {
            return values_.fail(
                range.offset, filled(tr("the range of {0} is empty"), {range.name}),
                filled(tr("type the lower end first: {0}"), {"0 < " + range.name + " < 1"}));
        }
        shares.push_back({.name = range.name, .value = {.id = value}, .outer = outer});
    }
    return shares;
}

std::optional<std::array<NodeId, 3>> PatchReader::OneRow::point_over(
    const std::vector<LocalName>& variables) {
    scope_.bind(innermost(variables));
    const auto value = reader_.build(point_, with(innermost(variables)));
    return value ? value->point() : std::nullopt;
}

bool PatchReader::OneRow::check_order(const std::vector<LocalName>& names) {
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
        for (const SyntaxId end : {ranges_[i].lo, ranges_[i].hi}) {
            const auto value = reader_.number(end, with(innermost(names)));
            if (!value) return false;
            for (std::size_t later = i; later < ranges_.size(); ++later) {
                const int variable = first_variable + static_cast<int>(later);
                if (!values_.builder().finish(*value).uses_variable(variable)) continue;
                values_.fail(
                    ranges_[i].offset,
                    filled(tr("the range of {0} goes by {1}"),
                           {ranges_[i].name, ranges_[later].name}),
                    later == i ? filled(tr("type {0}"), {example})
                               : filled(tr("type the range of {0} first"), {ranges_[later].name}));
                return false;
            }
        }
    }
    return true;
}

std::string PatchReader::OneRow::open_variable() const {
    for (const NameUse& use : reader_.table().uses(index_)) {
        const std::string& name = reader_.tree()[use.at].text;
        const bool is_usual = name == "u" || name == "v" || name == "t";
        const bool is_ranged = std::ranges::find(ranges_, name, &Ranged::name) != ranges_.end();
        if (is_usual && !is_ranged && reader_.table().meant(use, index_) == nullptr) return name;
    }
    return {};
}

std::string PatchReader::OneRow::text(const std::array<NodeId, 3>& point,
                                      const std::vector<LocalName>& names,
                                      const ReadingText& writer) {
    std::vector<std::string> shown = reader_.names().parameters();
    shown.resize(ProgramLimits::parameters);
    for (const Ranged& range : ranges_)
        shown.push_back(range.name);
    std::string text = "(";
    for (std::size_t i = 0; i < point.size(); ++i)
        text += (i > 0 ? ", " : "") + writer.of(point.at(i), shown);
    text += ")";
    for (const Ranged& range : ranges_) {
        const auto lo = reader_.number(range.lo, with(innermost(names)));
        const auto hi = lo ? reader_.number(range.hi, with(innermost(names))) : std::nullopt;
        if (!hi) break;
        text += ", " + writer.of(*lo, shown) + " < " + range.name + " < " + writer.of(*hi, shown);
    }
    return text;
}

/// The point that a row shows, if it shows one: the right side of r(u, v) = (u, v, 0), 0 < u < 1,
/// 0 < v < 1; where the row has no name, all of it.
SyntaxId PatchReader::point_in(const StatementSyntax& statement) const {
    const SyntaxTree& tree = reader_.tree();
    const Syntax& relation = tree[statement.relation];
    if (statement.restrictions.empty() || relation.kind != SyntaxKind::Compare ||
        relation.marks != "=")
        return statement.relation;
    const Syntax& left = tree[relation.operands[0]];
    const bool names = (left.kind == SyntaxKind::Name && !is_axis_name(left.text)) ||
                       (left.kind == SyntaxKind::Call && left.function == nullptr);
    return names ? relation.operands[1] : statement.relation;
}

/// Adds the ranges a < u < b that a condition gives; false if it says something else.
bool PatchReader::add_ranges(SyntaxId id, Ranges& ranges) const {
    const SyntaxTree& tree = reader_.tree();
    const Syntax& syntax = tree[id];
    if (syntax.kind == SyntaxKind::And) {
        return std::ranges::all_of(syntax.operands,
                                   [&](SyntaxId part) { return add_ranges(part, ranges); });
    }
    if (syntax.kind != SyntaxKind::Compare || syntax.operands.size() != 3) return false;
    const Syntax& middle = tree[syntax.operands[1]];
    if (middle.kind != SyntaxKind::Name || is_axis_name(middle.text)) return false;
    const bool ascends = is_ascending(syntax.marks);
    if (!ascends && !is_descending(syntax.marks)) return false;
    ranges.push_back({.name = middle.text,
                      .lo = syntax.operands[ascends ? 0 : 2],
                      .hi = syntax.operands[ascends ? 2 : 0],
                      .offset = syntax.offset});
    return true;
}

bool PatchReader::may_read(std::size_t statement) const {
    const StatementSyntax& syntax = reader_.tree().statements[statement];
    const SyntaxId point = point_in(syntax);
    const SyntaxKind kind = reader_.tree()[point].kind;
    if (kind == SyntaxKind::Vector && point == syntax.relation) return true;
    if (is_condition(kind) || syntax.restrictions.empty()) return false;
    if (!reader_.table().is_bundle(point)) return false;
    Ranges ranges;
    return std::ranges::all_of(syntax.restrictions,
                               [&](SyntaxId id) { return add_ranges(id, ranges); });
}

std::expected<PatchReader::Ranges, ParseError> PatchReader::ranges_of(
    const StatementSyntax& statement) const {
    GraphValues& values = reader_.values();
    Ranges ranges;
    for (const SyntaxId id : statement.restrictions) {
        if (add_ranges(id, ranges)) continue;
        return values.failure(
            reader_.tree()[id].offset, tr("only ranges of its variables stand behind a point"),
            filled(tr("type {0}, and cut it by the clip box or a section"), {example}));
    }
    for (auto range = ranges.begin(); range != ranges.end(); ++range) {
        const bool again = std::any_of(
            ranges.begin(), range, [&](const Ranged& other) { return other.name == range->name; });
        if (again)
            return values.failure(range->offset, filled(tr("{0} has two ranges"), {range->name}));
    }
    if (ranges.size() > 2) {
        return values.failure(ranges[2].offset, tr("a surface has two variables, and a curve one"),
                              filled(tr("type {0}"), {example}));
    }
    return ranges;
}

RowResult PatchReader::read(std::size_t statement) {
    GraphValues& values = reader_.values();
    const StatementSyntax& syntax = reader_.tree().statements[statement];
    const auto ranges = ranges_of(syntax);
    if (!ranges) return std::unexpected(ranges.error());
    OneRow row(*this, statement, *ranges);
    const auto names = row.bind_names();
    if (!names) return values.failure();
    const auto typed = row.point_over(*names);
    const std::string hint = filled(tr("type {0}"), {example});
    if (!typed && !values.failed()) {
        return values.failure(
            syntax.offset, tr("a row with ranges of variables is a point of three numbers"), hint);
    }
    if (!typed) return values.failure();
    if (std::ranges::any_of(*typed, [&](NodeId id) { return values.uses_space(id); })) {
        return values.failure(syntax.offset,
                              tr("a point is given by numbers and variables with a range, not by "
                                 "x, y and z"),
                              hint);
    }
    if (!row.check_order(*names)) return values.failure();
    const std::string open = ranges->size() < 2 ? row.open_variable() : std::string();
    if (!open.empty())
        return values.failure(syntax.offset, filled(tr("{0} has no range"), {open}), hint);
    std::string text = row.text(*typed, *names, text_);
    const auto shares = row.bind_ranges();
    const auto point = shares ? row.point_over(*shares) : std::nullopt;
    if (!point) return values.failure();
    constexpr std::array kinds{PatchKind::Point, PatchKind::Curve, PatchKind::Surface};
    return maker_.patch(statement, kinds.at(ranges->size()), *point, std::move(text));
}

}  // namespace zeroset
