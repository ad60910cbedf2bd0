#include "engine/language/dialects/tables.hpp"

#include "engine/base/text.hpp"
#include "engine/language/dialects/parts.hpp"

#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

using Words = std::string_view;

constexpr std::size_t most_terms = 100;

/// The numbers from one to another, by steps.
std::optional<std::vector<std::string>> stepped(Words from, Words to, Words by) {
    const auto lo = number_from<double>(from);
    const auto hi = number_from<double>(to);
    const auto step = number_from<double>(by);
    if (!lo || !hi || !step || !(*step > 0)) return std::nullopt;
    const double count = std::floor((*hi - *lo) / *step + 1e-9) + 1.0;
    if (!(count >= 1.0 && count <= double{most_terms})) return std::nullopt;
    std::vector<std::string> values;
    values.reserve(static_cast<std::size_t>(count));
    for (double k = 0; k < count; ++k)
        values.push_back("(" + short_number(*lo + k * *step, 15) + ")");
    return values;
}

/// The values of {k, 3}, {k, 1, 3}, {k, 0, 1, 0.25} or {k, {a, b}}.
std::optional<std::vector<std::string>> values_of(const std::vector<Words>& range) {
    if (range.size() == 4) return stepped(range[1], range[2], range[3]);
    if (range.size() == 3) return stepped(range[1], range[2], "1");
    if (range.size() != 2) return std::nullopt;
    const auto list = in_brackets(range[1]);
    if (!list) return stepped("1", range[1], "1");
    std::vector<std::string> values;
    for (const Words value : split_outside(*list, ','))
        values.push_back("(" + std::string(value) + ")");
    return values;
}

}  // namespace

std::optional<Table> table_of(std::string_view inside) {
    const auto parts = split_outside(inside, ',');
    if (parts.size() < 2) return std::nullopt;
    Table table{.body = parts[0], .terms = {{}}};
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const auto bracketed = in_brackets(parts[i]);
        if (!bracketed || !parts[i].starts_with('{')) return std::nullopt;
        const auto range = split_outside(*bracketed, ',');
        const auto values = is_word(range[0]) ? values_of(range) : std::nullopt;
        if (!values || values->size() * table.terms.size() > most_terms) return std::nullopt;
        std::vector<Table::Term> terms;
        for (const Table::Term& outer : table.terms) {
            for (const std::string& value : *values) {
                terms.push_back(outer);
                terms.back().emplace_back(range[0], value);
            }
        }
        table.terms = std::move(terms);
    }
    return table;
}

std::optional<Table> table_in(std::string_view expression) {
    constexpr Words evaluate = "Evaluate";
    constexpr Words name = "Table";
    if (expression.starts_with(evaluate)) {
        const auto inside = in_brackets(trimmed(expression.substr(evaluate.size())));
        return inside ? table_in(trimmed(*inside)) : std::nullopt;
    }
    if (!expression.starts_with(name)) return std::nullopt;
    const auto inside = in_brackets(trimmed(expression.substr(name.size())));
    return inside ? table_of(*inside) : std::nullopt;
}

}  // namespace zeroset
