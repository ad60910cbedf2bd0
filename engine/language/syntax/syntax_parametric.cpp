#include "engine/language/syntax/syntax_parametric.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace zeroset {
namespace {

bool is_axis(std::string_view name) { return name == "x" || name == "y" || name == "z"; }

class CoordinateJoiner {
public:
    explicit CoordinateJoiner(SyntaxTree& tree) : tree_(tree) {}

    void join() {
        constexpr std::size_t most_ranges = 2;
        for (std::size_t i = 0; i < tree_.statements.size() && ranges_.size() <= most_ranges; ++i)
            look_at(i);
        const bool all =
            std::ranges::all_of(values_, [](const auto& value) { return value.has_value(); });
        const bool is_one_row = used_.size() == 1;
        if (!all || is_double_ || ranges_.size() > most_ranges || (ranges_.empty() && !is_one_row))
            return;
        StatementSyntax& first = tree_.statements[used_.front()];
        const std::size_t offset = tree_[first.relation].offset;
        tree_.nodes.push_back({.kind = SyntaxKind::Vector,
                               .offset = offset,
                               .text = {},
                               .operands = {*values_[0], *values_[1], *values_[2]},
                               .marks = {}});
        first.relation = static_cast<SyntaxId>(tree_.nodes.size() - 1);
        first.restrictions = ranges_;
        for (std::size_t i = used_.size(); i-- > 1;)
            tree_.statements.erase(tree_.statements.begin() +
                                   static_cast<std::ptrdiff_t>(used_[i]));
    }

private:
    /// Takes a statement that gives coordinates and ranges and nothing else.
    void look_at(std::size_t statement) {
        const StatementSyntax& syntax = tree_.statements[statement];
        auto values = values_;
        auto ranges = ranges_;
        bool takes = take(syntax.relation, values, ranges);
        for (const SyntaxId id : syntax.restrictions)
            takes = takes && take(id, values, ranges);
        if (!takes) return;
        values_ = values;
        ranges_ = std::move(ranges);
        used_.push_back(statement);
    }

    bool take(SyntaxId id, std::array<std::optional<SyntaxId>, 3>& values,
              std::vector<SyntaxId>& ranges) {
        const Syntax& syntax = tree_[id];
        if (syntax.kind != SyntaxKind::Compare) return false;
        const Syntax& left = tree_[syntax.operands[0]];
        const bool names = left.kind == SyntaxKind::Name ||
                           (left.kind == SyntaxKind::Call && left.function == nullptr);
        if (syntax.marks == "=" && names && is_axis(left.text)) {
            auto& value = values.at(static_cast<std::size_t>(left.text[0] - 'x'));
            if (names_axis(syntax.operands[1])) return false;
            is_double_ = is_double_ || value.has_value();
            value = syntax.operands[1];
            return true;
        }
        const bool is_range = syntax.operands.size() == 3 &&
                              syntax.marks.find_first_not_of("<l>g") == std::string::npos;
        if (!is_range) return false;
        const Syntax& middle = tree_[syntax.operands[1]];
        if (middle.kind != SyntaxKind::Name || is_axis(middle.text)) return false;
        ranges.push_back(id);
        return true;
    }

    [[nodiscard]] bool names_axis(SyntaxId root) const {
        std::vector<SyntaxId> pending{root};
        while (!pending.empty()) {
            const Syntax& syntax = tree_[pending.back()];
            pending.pop_back();
            if (syntax.kind == SyntaxKind::Name && is_axis(syntax.text)) return true;
            pending.insert(pending.end(), syntax.operands.begin(), syntax.operands.end());
        }
        return false;
    }

    SyntaxTree& tree_;
    std::array<std::optional<SyntaxId>, 3> values_;
    std::vector<SyntaxId> ranges_;
    std::vector<std::size_t> used_;  ///< statements that become one, in order
    bool is_double_ = false;         ///< a coordinate is given twice
};

}  // namespace

void join_coordinates(SyntaxTree& tree) { CoordinateJoiner(tree).join(); }

}  // namespace zeroset
