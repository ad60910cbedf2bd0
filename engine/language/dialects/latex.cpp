#include "engine/language/dialects/latex.hpp"

#include "engine/base/text.hpp"
#include "engine/language/dialects/parts.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace zeroset {
namespace {

using Words = std::string_view;

constexpr int most_nested_sums = 20;
constexpr std::size_t longest_group = 1'000;  // bytes of an index or an end of a sum

/// Relations, by which an equation is told from a part of one.
constexpr std::array<Words, 12> relations{"\\ne", "\\neq", "\\approx", "=",     "<",    ">",
                                          "\\le", "\\ge",  "\\leq",    "\\geq", "\\lt", "\\gt"};
/// Environments whose lines may be parts of one equation.
constexpr std::array<Words, 7> line_environments{"align",    "aligned",  "split",   "gather",
                                                 "multline", "eqnarray", "gathered"};

/// The letters of a command of LaTeX at the start of a text, behind its backslash.
Words command_at(Words text) {
    if (!text.starts_with('\\')) return {};
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto* const end = std::ranges::find_if_not(text.substr(1), is_letter);
    return text.substr(1, static_cast<std::size_t>(end - text.begin()) - 1);
}

/// A group in braces or one sign at the start of a text: its inside, and the length of all.
struct Group {
    Words inside;
    std::size_t length;
};

std::optional<Group> group_at(Words text) {
    const std::size_t blanks = blank_length(text);
    text = text.substr(blanks);
    if (text.empty()) return std::nullopt;
    if (text.front() != '{') {
        const std::size_t length = 1 + command_at(text).size();
        return Group{.inside = text.substr(0, length), .length = blanks + length};
    }
    const auto closer = closing_bracket(text.substr(0, longest_group));
    if (!closer) return std::nullopt;
    return Group{.inside = trimmed(text.substr(1, *closer - 1)), .length = blanks + *closer + 1};
}

/// A sum or product: its index, ends, and the length of its sign with them.
struct BigSign {
    Words function;
    Words index, lo, hi;
    std::size_t length = 0;
};

std::optional<BigSign> big_sign_at(Words text) {
    const Words name = command_at(text);
    if (name != "sum" && name != "prod") return std::nullopt;
    BigSign sign{.function = name == "sum" ? "sum(" : "prod(", .index = {}, .lo = {}, .hi = {}};
    std::size_t at = 1 + name.size();
    const auto skip_blanks = [&] { at += blank_length(text.substr(at)); };
    skip_blanks();
    if (command_at(text.substr(at)) == "limits") at += 7;
    for (int i = 0; i < 2; ++i) {
        skip_blanks();
        const bool is_below = text.substr(at).starts_with('_');
        if (!is_below && !text.substr(at).starts_with('^')) return std::nullopt;
        const auto group = group_at(text.substr(at + 1));
        if (!group) return std::nullopt;
        at += 1 + group->length;
        const std::size_t equals = group->inside.find('=');
        if (is_below && equals == Words::npos) return std::nullopt;
        if (is_below) {
            sign.index = trimmed(group->inside.substr(0, equals));
            sign.lo = trimmed(group->inside.substr(equals + 1));
        } else {
            sign.hi = group->inside;
        }
    }
    if (sign.index.empty() || sign.lo.empty() || sign.hi.empty()) return std::nullopt;
    sign.length = at;
    return sign;
}

/// Whether a command ends the product that a sum is of.
bool ends_summand(Words command) {
    return command == "end" || std::ranges::any_of(relations, [&](Words relation) {
               return relation.starts_with('\\') && relation.substr(1) == command;
           });
}

/// The length of the product that a sum is of: up to a sign outside brackets that ends it.
std::size_t summand_length(Words text) {
    int depth = 0;
    bool has_factor = false;
    for (std::size_t at = 0; at < text.size();) {
        const Words rest = text.substr(at);
        const Words command = command_at(rest);
        const char sign = rest.front();
        const bool is_delimiter = command == "left" || command == "right";
        const bool closes = Words(")]}").contains(sign);
        const bool ends = rest.starts_with("\\\\") || (!command.empty() && ends_summand(command)) ||
                          closes || (has_factor && Words("+-").contains(sign)) ||
                          Words("=<>&,;\n\v").contains(sign);
        if (depth == 0 && ends) return at;
        if (Words("([{").contains(sign)) ++depth;
        if (closes) --depth;
        has_factor = has_factor || (!is_delimiter && !Words(" \t+-").contains(sign));
        const std::size_t escape = sign == '\\' ? 2 : 1;
        at += command.empty() ? escape : 1 + command.size();
    }
    return text.size();
}

class LatexWriter {
public:
    explicit LatexWriter(SourceText& words) : words_(words) {}

    void write(Words text) {
        std::size_t kept = 0;
        const auto keep_up_to = [&](std::size_t at) { words_.keep(text.substr(kept, at - kept)); };
        for (std::size_t at = 0; at < text.size();) {
            const Words rest = text.substr(at);
            if (rest.front() == '&' && is_within_lines()) {
                keep_up_to(at);
                kept = at + 1;
            }
            if (!rest.starts_with('\\')) {
                has_relation_ |= Words("=<>").contains(rest.front());
                ++at;
                continue;
            }
            const auto sign = depth_ < most_nested_sums ? big_sign_at(rest) : std::nullopt;
            if (sign) {
                keep_up_to(at);
                const Words behind = rest.substr(sign->length);
                const Words summand = behind.substr(0, summand_length(behind));
                write_sum(*sign, summand);
                at += sign->length + summand.size();
                kept = at;
                continue;
            }
            if (const auto connective = connective_at(rest)) {
                keep_up_to(at);
                put(connective->inside, rest);
                at += connective->length;
                kept = at;
                continue;
            }
            const Words command = command_at(rest);
            if (rest.starts_with("\\\\") && is_within_lines()) {
                if (!has_relation_ || goes_on(text.substr(at + 2))) {
                    keep_up_to(at);
                    kept = at + 2;
                }
                has_relation_ = false;
                at += 2;
                continue;
            }
            follow(command, rest);
            at += 1 + std::max<std::size_t>(command.size(), 1);
        }
        if (kept < text.size()) words_.keep(text.substr(kept));
    }

private:
    void put(Words words, Words near) { words_.put(words, words_.offset_of(near)); }

    void write_sum(const BigSign& sign, Words summand) {
        ++depth_;
        put(sign.function, sign.index);
        write(summand);
        put(", ", sign.index);
        words_.keep(sign.index);
        put(", ", sign.lo);
        words_.keep(sign.lo);
        put(", ", sign.hi);
        words_.keep(sign.hi);
        put(")", sign.hi);
        --depth_;
    }

    /// The word in \text{ and }.
    static std::optional<Group> connective_at(Words text) {
        const Words command = command_at(text);
        if (command != "text" && command != "textrm" && command != "mathrm") return std::nullopt;
        const auto group = group_at(text.substr(1 + command.size()));
        if (!group) return std::nullopt;
        const Words word = group->inside;
        if (word != "and" && word != "or" && word != "und" && word != "oder") return std::nullopt;
        return Group{.inside = word == "and" || word == "und" ? " and " : " or ",
                     .length = 1 + command.size() + group->length};
    }

    /// Follows \\begin, \\end and relations.
    void follow(Words command, Words text) {
        has_relation_ |= std::ranges::any_of(relations, [&](Words relation) {
            return relation.starts_with('\\') && relation.substr(1) == command;
        });
        if (command == "end" && !environments_.empty()) environments_.pop_back();
        if (command != "begin") return;
        const Words name = text.substr(std::min<std::size_t>(text.size(), 7));
        const bool is_of_lines = std::ranges::any_of(line_environments, [&](Words environment) {
            const Words behind = name.substr(std::min(environment.size(), name.size()));
            return name.starts_with(environment) &&
                   (behind.starts_with('}') || behind.starts_with("*}"));
        });
        environments_.push_back(is_of_lines);
        has_relation_ = false;
    }
    /// Whether a line begins with a sign that stands between terms, and has no relation of its own.
    static bool goes_on(Words line) {
        line = trimmed(line.substr(0, std::min(line.find("\\\\"), line.find("\\end"))));
        for (const Words skipped : {"&", "\\quad", "\\qquad", "\\;", "\\,", "\\ "}) {
            if (line.starts_with(skipped)) line = trimmed(line.substr(skipped.size()));
        }
        const bool is_joined = line.starts_with('+') || line.starts_with('-');
        return is_joined && std::ranges::none_of(
                                relations, [&](Words relation) { return line.contains(relation); });
    }
    [[nodiscard]] bool is_within_lines() const {
        return !environments_.empty() && environments_.back();
    }

    SourceText& words_;
    std::vector<bool> environments_;  ///< open ones; true: of lines
    bool has_relation_ = false;       ///< in this line
    int depth_ = 0;
};

}  // namespace

SourceText latex_in_words(std::string_view typed) {
    SourceText words(typed);
    if (typed.contains('\\'))
        LatexWriter(words).write(typed);
    else
        words.keep(typed);
    return words;
}

}  // namespace zeroset
