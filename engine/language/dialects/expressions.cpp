#include "engine/language/dialects/expressions.hpp"

#include "engine/base/text.hpp"
#include "engine/language/dialects/names_in_text.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

constexpr int most_nested_calls = 50;              // calls within calls that are rewritten
constexpr int most_unclosed = 100;                 // calls without an end that are looked at
constexpr std::size_t longest_sign = 24;           // bytes of a sign such as \[CurlyPhi]
constexpr std::size_t longest_rewritten = 20'000;  // bytes of a call that is rewritten

using Words = std::string_view;

/// Sums and products of other programs, and what they are called here.
constexpr std::array sums = std::to_array<std::pair<Words, Words>>({{"Sum", "sum("},
                                                                    {"sum", "sum("},
                                                                    {"add", "sum("},
                                                                    {"summation", "sum("},
                                                                    {"symsum", "sum("},
                                                                    {"Product", "prod("},
                                                                    {"product", "prod("},
                                                                    {"prod", "prod("},
                                                                    {"mul", "prod("},
                                                                    {"symprod", "prod("}});

/// An index and its ends; without the lower one it runs from 1, or of Python's range from 0.
struct IndexRange {
    Words name, lo, hi;
    bool is_open = false;  ///< the last one is below `hi`
};

std::optional<IndexRange> index_range(Words argument) {
    if (const auto range = named_range(argument))
        return IndexRange{.name = range->name, .lo = range->lo, .hi = range->hi};
    const auto inside = in_brackets(argument);
    if (!inside) return std::nullopt;
    const auto parts = split_outside(*inside, ',');
    if (parts.size() != 2 || !is_word(parts[0])) return std::nullopt;
    return IndexRange{.name = parts[0], .lo = {}, .hi = parts[1]};
}

/// The body and the range of `f for i in range(1, 4)`.
std::optional<std::pair<Words, IndexRange>> generator(Words inside) {
    const std::size_t at = find_outside(inside, "for");
    if (at == Words::npos) return std::nullopt;
    Words behind = trimmed(inside.substr(at + 3));
    const std::size_t name = word_length(behind);
    const Words index = behind.substr(0, name);
    behind = trimmed(behind.substr(name));
    if (name == 0 || !behind.starts_with("in")) return std::nullopt;
    behind = trimmed(behind.substr(2));
    if (!behind.starts_with("range")) return std::nullopt;
    const auto ends = in_brackets(behind.substr(5));
    if (!ends) return std::nullopt;
    const auto parts = split_outside(*ends, ',');
    if (parts.size() > 2) return std::nullopt;
    return std::pair(trimmed(inside.substr(0, at)),
                     IndexRange{.name = index,
                                .lo = parts.size() == 2 ? parts[0] : Words(),
                                .hi = parts.back(),
                                .is_open = true});
}

bool is_true(Words condition) {
    return condition == "True" || condition == "true" || condition == "otherwise";
}

/// The length of a word, of a number with its letters, as 1e5, or of one sign.
std::size_t other_length(Words text) {
    if (const std::size_t word = word_length(text); word > 0) return word;
    const std::size_t digits = text.find_first_not_of("0123456789.eE");
    return std::clamp<std::size_t>(digits, 1, text.size());
}

/// Whether %pi or %e of Maxima is at `at`, not a remainder.
bool is_constant_of_maxima(Words text, std::size_t at) {
    if (text[at] != '%') return false;
    const Words name = text.substr(at + 1, word_length(text.substr(at + 1)));
    const Words before = trimmed(text.substr(0, at));
    return (name == "pi" || name == "e" || name == "phi") &&
           (before.empty() || Words("+-*/^(,=<>").contains(before.back()));
}

/// Conditions and values; the last one may have no condition, or neither: 0.
using Cases = std::vector<std::pair<Words, Words>>;

/// The cases of piecewise(c, a, d, b, e).
Cases cases_of_maple(Words inside) {
    const auto parts = split_outside(inside, ',');
    Cases cases;
    for (std::size_t i = 0; i + 1 < parts.size(); i += 2)
        cases.emplace_back(parts[i], parts[i + 1]);
    if (parts.size() % 2 == 1) cases.emplace_back(Words(), parts.back());
    return cases;
}

/// The cases of {{a, c}, {b, d}}, e or of (a, c), (e, True); none where it is neither.
Cases cases_of_pairs(Words inside) {
    auto pairs = split_outside(inside, ',');
    const bool is_list = inside.starts_with('{');
    const Words otherwise = is_list && pairs.size() == 2 ? pairs[1] : Words();
    if (is_list) {
        const auto list = in_brackets(pairs[0]);
        if (!list || pairs.size() > 2) return {};
        pairs = split_outside(*list, ',');
    }
    Cases cases;
    for (const Words pair : pairs) {
        const auto of = in_brackets(pair);
        const auto both = of ? split_outside(*of, ',') : std::vector<Words>();
        if (both.size() != 2) return {};
        cases.emplace_back(is_true(both[1]) ? Words() : both[1], both[0]);
    }
    if (is_list) cases.emplace_back(Words(), otherwise);
    return cases;
}

}  // namespace

bool ExpressionWriter::is_function(std::string_view name) const {
    return is_function_in(text_.typed(), name);
}

std::string_view ExpressionWriter::value_of(std::string_view name) const {
    return list_in(text_.typed(), name);
}

std::string ExpressionWriter::words_of(std::string_view expression) const {
    SourceText words(expression);
    ExpressionWriter(words).write(expression);
    return words.words();
}

void ExpressionWriter::write(std::string_view expression) {
    if (write_choice(expression)) return;
    std::size_t kept = 0;  // what is before it has been written
    for (std::size_t at = 0; at < expression.size();) {
        const auto flush = [&] { text_.keep(expression.substr(kept, at - kept)); };
        if (const std::size_t length = write_other(expression, at, flush); length > 0) {
            at += length;
            kept = at;
        } else {
            at += other_length(expression.substr(at));
        }
    }
    text_.keep(expression.substr(kept));
}

/// Writes what stands at `at` where the language writes it otherwise, and returns its length; 0: it
/// is kept. `flush` writes what is before it.
std::size_t ExpressionWriter::write_other(std::string_view expression, std::size_t at,
                                          const std::function<void()>& flush) {
    const std::string_view rest = expression.substr(at);
    const std::size_t remark = rest.starts_with("(*") ? remarks_.length(rest) : 0;
    const bool is_sign = rest.starts_with("\\[") && rest.substr(0, longest_sign).contains(']');
    if (remark > 0 || is_constant_of_maxima(expression, at)) {
        flush();
        return remark > 0 ? remark : 1;
    }
    if (is_sign) {  // Mathematica's \[Pi]
        flush();
        put(lower_case(rest.substr(2, rest.find(']') - 2)), rest);
        return rest.find(']') + 1;
    }
    if (reads_lists_ && rest.starts_with('{')) {
        const std::string_view before = trimmed(expression.substr(0, at));
        const bool is_factor = !before.empty() && !Words("+-*/^(,=<>{[").contains(before.back());
        return write_list(rest, is_factor ? "*(" : "(", flush);
    }
    const std::size_t length = word_length(rest);
    if (length == 0) return 0;
    const std::string_view word = rest.substr(0, length);
    if (const Words other = other_name(word); !other.empty()) {
        flush();
        put(other, word);
        return length;
    }
    const std::size_t opener = length + blank_length(rest.substr(length));
    const bool may_call = depth_ < most_nested_calls && unclosed_ < most_unclosed &&
                          has_foreign_expression(rest.substr(0, opener + 1));
    if (!may_call) return 0;
    const auto closer = closing_bracket(rest.substr(opener, longest_rewritten));
    unclosed_ += closer ? 0 : 1;
    if (!closer) return 0;
    const std::size_t before = text_.words().size();
    flush();
    if (write_call(word, rest.substr(opener + 1, *closer - 1))) return opener + *closer + 1;
    text_.cut_back(before);
    return 0;
}

bool has_foreign_expression(std::string_view text) {
    constexpr std::array<Words, 7> others{"Piecewise", "piecewise", "Rational", "Eq",
                                          "Evaluate",  "Table",     "Total"};
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = word_length(text.substr(at));
        if (length == 0) {
            ++at;
            continue;
        }
        const Words word = text.substr(at, length);
        at += length;
        const std::size_t opener = at + blank_length(text.substr(at));
        const bool calls = opener < text.size() && (text[opener] == '(' || text[opener] == '[');
        if (calls && (std::ranges::find(others, word) != others.end() ||
                      std::ranges::find(sums, word, &std::pair<Words, Words>::first) != sums.end()))
            return true;
    }
    return false;
}

std::string_view ExpressionWriter::other_name(std::string_view word) const {
    for (const Names* const names : {&renamed_, &always_renamed_}) {
        const auto other = std::ranges::find(*names, word, &std::pair<Words, Words>::first);
        if (other != names->end()) return other->second;
    }
    return {};
}

/// Writes {a, b} as (a, b), and returns its length; 0: it is no list of several.
std::size_t ExpressionWriter::write_list(std::string_view text, std::string_view opener,
                                         const std::function<void()>& flush) {
    if (depth_ >= most_nested_calls || unclosed_ >= most_unclosed) return 0;
    const auto closer = closing_bracket(text.substr(0, longest_rewritten));
    unclosed_ += closer ? 0 : 1;
    const auto parts =
        closer ? split_outside(text.substr(1, *closer - 1), ',') : std::vector<Words>();
    if (parts.size() < 2) return 0;
    flush();
    ++depth_;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        put(i == 0 ? opener : ", ", parts[i]);
        write(parts[i]);
    }
    --depth_;
    put(")", text.substr(*closer));
    return *closer + 1;
}

/// Writes a call that the language writes otherwise; false: it is kept as it is.
bool ExpressionWriter::write_call(std::string_view word, std::string_view inside) {
    ++depth_;
    const auto parts = split_outside(inside, ',');
    bool is_written = write_sum(word, inside) || write_list_by_index(word, inside);
    if (!is_written && (word == "Piecewise" || word == "piecewise"))
        is_written = write_cases(word, inside);
    if (!is_written && word == "Rational" && parts.size() == 2) {
        write_joined("((", parts[0], ")/(", parts[1], "))");
        is_written = true;
    }
    if (!is_written && word == "Evaluate") {
        put("(", inside);
        write(inside);
        put(")", inside.substr(inside.size()));
        is_written = true;
    }
    if (!is_written && word == "Eq" && parts.size() == 2) {
        write_joined("", parts[0], " = ", parts[1], "");
        is_written = true;
    }
    --depth_;
    return is_written;
}

void ExpressionWriter::write_joined(std::string_view open, std::string_view a,
                                    std::string_view sign, std::string_view b,
                                    std::string_view close) {
    put(open, a);
    write(a);
    put(sign, b);
    write(b);
    put(close, b.substr(b.size()));
}

/// Writes Sum[f, {i, 1, 3}], sum(f, i = 1..3), sum(f for i in range(3)) and their like as sum(f, i,
/// 1, 3).
bool ExpressionWriter::write_sum(std::string_view word, std::string_view inside) {
    const auto* const known = std::ranges::find(sums, word, &std::pair<Words, Words>::first);
    if (known == sums.end()) return false;
    const auto parts = split_outside(inside, ',');
    std::string_view body = parts[0];
    std::vector<IndexRange> ranges;
    if (const auto of = generator(inside)) {
        body = of->first;
        ranges.push_back(of->second);
    } else if (word.starts_with("sym") && parts.size() == 4) {
        ranges.push_back({.name = parts[1], .lo = parts[2], .hi = parts[3]});
    } else {
        for (std::size_t i = 1; i < parts.size(); ++i) {
            const auto range = index_range(parts[i]);
            if (!range) return false;
            ranges.push_back(*range);
        }
    }
    if (ranges.empty()) return false;
    // SymPy's first range is the innermost one, Mathematica's the last.
    if (parts.size() > 2 && parts[1].starts_with('(')) std::ranges::reverse(ranges);
    for (std::size_t i = 0; i < ranges.size(); ++i)
        put(known->second, word);
    write(body);
    // The last range is the innermost one.
    for (std::size_t i = ranges.size(); i-- > 0;) {
        const IndexRange& range = ranges[i];
        put(", ", range.name);
        text_.keep(range.name);
        put(range.lo.empty() ? (range.is_open ? ", 0, " : ", 1, ") : ", ", range.name);
        if (!range.lo.empty()) {
            write(range.lo);
            put(", ", range.hi);
        }
        write(range.hi);
        put(range.is_open ? " - 1)" : ")", range.hi);
    }
    return true;
}

void ExpressionWriter::with_term(const Table::Term& term, const std::function<void()>& write) {
    const Names before = renamed_;
    renamed_.insert(renamed_.begin(), term.begin(), term.end());
    write();
    renamed_ = before;
}

/// Writes Table[f, {k, 1, 3}] as the list of its terms, and Total[list] as sum(list).
bool ExpressionWriter::write_list_by_index(std::string_view word, std::string_view inside) {
    if (word == "Total") {
        const auto list = inside.starts_with('{') ? in_brackets(inside) : std::nullopt;
        put(list ? "sum([" : "sum(", inside);
        write(list.value_or(inside));
        put(list ? "])" : ")", inside.substr(inside.size()));
        return true;
    }
    const auto table = word == "Table" ? table_of(inside) : std::nullopt;
    if (!table) return false;
    for (std::size_t i = 0; i < table->terms.size(); ++i) {
        put(i == 0 ? "[" : ", ", table->body);
        with_term(table->terms[i], [&] { write(table->body); });
    }
    put("]", inside.substr(inside.size()));
    return true;
}

/// Writes Piecewise[{{a, c}, {b, d}}, e], Piecewise((a, c), (e, True)) and piecewise(c, a, d, b, e)
/// as {c: a, d: b, e}.
bool ExpressionWriter::write_cases(std::string_view word, std::string_view inside) {
    const auto cases = word == "piecewise" ? cases_of_maple(inside) : cases_of_pairs(inside);
    if (cases.empty()) return false;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto& [condition, value] = cases[i];
        put(i == 0 ? "{" : ", ", value.empty() ? word : value);
        if (!condition.empty()) {
            write(condition);
            put(": ", value);
        }
        if (value.empty())
            put("0", word);
        else
            write(value);
    }
    put("}", inside.substr(inside.size()));
    return true;
}

/// Writes Python's `a if c else b` as a choice.
bool ExpressionWriter::write_choice(std::string_view expression) {
    const std::size_t at =
        depth_ < most_nested_calls ? find_outside(expression, "if") : Words::npos;
    if (at == Words::npos || trimmed(expression.substr(0, at)).empty()) return false;
    const std::string_view behind = expression.substr(at + 2);
    const std::size_t other = find_outside(behind, "else");
    if (other == Words::npos) return false;
    ++depth_;
    put("((", expression);
    write(trimmed(behind.substr(0, other)));
    put(") ? (", expression);
    write(trimmed(expression.substr(0, at)));
    put(") : (", behind.substr(other));
    write(trimmed(behind.substr(other + 4)));
    put("))", expression.substr(expression.size()));
    --depth_;
    return true;
}

}  // namespace zeroset
