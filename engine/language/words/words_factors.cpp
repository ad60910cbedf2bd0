// The product that a name would be if it were not defined, and what a definition depends on.

#include "engine/expr/spelling.hpp"
#include "engine/language/vocabulary/functions.hpp"
#include "engine/language/words/signs.hpp"
#include "engine/language/words/words_candidates.hpp"
#include "engine/language/words/words_defined.hpp"

#include <algorithm>

namespace zeroset {

/// Length of the defined name that ends in a digit and starts the text; 0: there is none.
std::size_t Candidates::defined_start(std::string_view text, std::string_view whole) const {
    constexpr std::size_t longest = 64;
    for (std::size_t length = std::min(text.size(), longest); length > 1; --length) {
        const bool ends =
            is_digit(text[length - 1]) && (length == text.size() || is_letter(text[length]));
        const std::string_view start = text.substr(0, length);
        if (ends && start != whole && uses_.contains(start)) return length;
    }
    return 0;
}

/// Takes the letters at the start of the text, or one Greek letter, with their subscript.
bool Candidates::take_factors(std::string_view& text, std::vector<std::string>& factors) const {
    const auto is_part = [](char c) { return is_letter(c) || is_digit(c); };
    const auto take = [&](auto predicate) {
        const auto* const end = std::ranges::find_if_not(text, predicate);
        const auto taken = text.substr(0, static_cast<std::size_t>(end - text.begin()));
        text.remove_prefix(taken.size());
        return taken;
    };
    const bool letters = is_letter(text[0]);
    const std::size_t length = letters ? 0 : code_point_at(text, 0).length;
    if (length == 1) return false;
    const std::string_view run = letters ? take(is_letter) : text.substr(0, length);
    if (!letters) text.remove_prefix(length);
    std::string subscript;
    if (text.size() > 1 && text[0] == '_' && text[1] != '_') {
        text.remove_prefix(1);
        subscript = is_digit(text[0]) ? take(is_digit) : take(is_part);
    }
    const std::vector<std::size_t> lengths =
        letters ? vocabulary_.pieces(run, !subscript.empty()) : std::vector{run.size()};
    std::size_t begin = 0;
    for (const std::size_t piece : lengths) {
        factors.emplace_back(run.substr(begin, piece));
        begin += piece;
    }
    if (!lengths.empty() && !subscript.empty()) factors.back() += "_" + subscript;
    return !lengths.empty();
}

std::vector<std::string> Candidates::factors(std::string_view name) const {
    constexpr std::size_t longest = 1000;
    std::vector<std::string> factors;
    if (name.size() > longest) return factors;
    for (std::string_view rest = name; !rest.empty();) {
        const std::size_t defined = defined_start(rest, name);
        if (defined > 0) {
            factors.emplace_back(rest.substr(0, defined));
            rest.remove_prefix(defined);
        } else if (is_digit(rest[0])) {  // as in sin2x
            if (factors.empty() || find_fixed_function(factors.back()) == nullptr) return {};
            const std::size_t length = std::min(rest.find_first_not_of("0123456789"), rest.size());
            factors.emplace_back(rest.substr(0, length));
            rest.remove_prefix(length);
        } else if (!take_factors(rest, factors)) {
            return {};
        }
    }
    return factors;
}

bool Candidates::is_known_factor(const std::string& factor) const {
    return factor.size() > 1 ? uses_.contains(factor) : vocabulary_.has_letter(factor[0]);
}

bool Candidates::is_constant(const Candidate& candidate) const {
    return std::ranges::none_of(candidate.value, [&](const Token& token) {
        if (token.kind != TokenKind::Name) return false;
        const std::string name = plain_name(token.text);
        if (find_function(name) != nullptr || is_logic_word(name)) return false;
        if (uses_.contains(name) && !is_place(name)) return false;
        if (is_built_in_value(name)) return is_place(name);
        return name.find_first_of("xyz") != std::string::npos;
    });
}

bool Candidates::depends_on_arguments_only(const Candidate& candidate) const {
    bool uses_argument = false;
    for (const Token& token : candidate.value) {
        if (token.kind != TokenKind::Name) continue;
        const std::string name = plain_name(token.text);
        if (std::ranges::find(candidate.arguments, name) != candidate.arguments.end()) {
            uses_argument = true;
            continue;
        }
        const bool constant = is_built_in(name) && !is_place(name) && name != "w" && name != "t";
        if (!constant) return false;
    }
    return uses_argument;
}

}  // namespace zeroset
