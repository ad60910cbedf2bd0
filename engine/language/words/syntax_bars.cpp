#include "engine/language/words/syntax_bars.hpp"

#include "engine/base/translation.hpp"
#include "engine/language/vocabulary/functions.hpp"
#include "engine/language/vocabulary/parse_notes.hpp"
#include "engine/language/vocabulary/words_vocabulary.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace zeroset {
namespace {

enum class Role : std::uint8_t { Unknown, Opens, Closes, Or };

class BarReader {
public:
    BarReader(std::span<const Token> tokens, std::span<const Bar> bars, const BarPlace& place,
              Notes& notes)
        : tokens_(tokens),
          bars_(bars),
          place_(place),
          notes_(notes),
          roles_(bars.size(), Role::Unknown) {}

    std::vector<std::size_t> bars_that_mean_or() {
        std::vector<std::size_t> result;
        std::size_t open = 0;
        for (std::size_t i = 0; i < bars_.size(); ++i) {
            if (!stands_behind_operand(i)) {
                roles_[i] = Role::Opens;
                ++open;
            } else if (open > 0) {
                roles_[i] = Role::Closes;
                --open;
            } else if (means_or(i)) {
                result.push_back(bars_[i].at);
                roles_[i] = Role::Or;
                if (is_double(i)) roles_[++i] = Role::Or;
            } else {
                roles_[i] = Role::Opens;
                ++open;
            }
        }
        return result;
    }

private:
    /// Whether bar i directly follows bar i - 1, with or without a space between.
    [[nodiscard]] bool is_next(std::size_t i) const {
        return i > 0 && bars_[i - 1].at + 1 == bars_[i].at;
    }
    [[nodiscard]] bool is_double(std::size_t i) const {
        return i + 1 < bars_.size() && is_next(i + 1) &&
               !has_space_before(tokens_, bars_[i + 1].at);
    }
    [[nodiscard]] bool stands_behind_operand(std::size_t i) const {
        if (is_next(i)) return roles_[i - 1] == Role::Closes;
        return bars_[i].at > 0 && ends_operand(tokens_[bars_[i].at - 1]);
    }

    /// The bar that closes the absolute value which bar i would open.
    [[nodiscard]] std::optional<std::size_t> closer_of(std::size_t i) const {
        constexpr std::size_t farthest = 100;
        int open = 1;
        bool last_closes = false;
        const std::size_t end = std::min(bars_.size(), i + farthest);
        for (std::size_t k = i + 1; k < end; ++k) {
            const bool closes = is_next(k) ? last_closes : ends_operand(tokens_[bars_[k].at - 1]);
            open += closes ? -1 : 1;
            if (open == 0) return k;
            last_closes = closes;
        }
        return std::nullopt;
    }

    /// Whether bar i means "or"; it must follow an operand and be outside absolute values.
    [[nodiscard]] bool means_or(std::size_t i) const {
        const Token& next = tokens_[bars_[i].at + (is_double(i) ? 2 : 1)];
        if (!begins_operand(next) && !is_symbol(next, {"+", "-", "|"})) return false;
        const std::optional<std::size_t> closer = closer_of(i);
        if (!closer || bars_[*closer].comparisons > bars_[i].comparisons) return true;
        if (place_.is_condition && place_.comparisons == 0) return true;
        note_spaces(i, *closer);
        return false;
    }

    /// Notes bars with a space inside: x |y| z has none; a | b | c has, and may have meant "or".
    void note_spaces(std::size_t i, std::size_t closer) const {
        const bool doubled = is_double(i);
        const std::size_t begin = bars_[i].at + (doubled ? 1 : 0);
        const std::size_t end = bars_[closer].at;
        const std::size_t last = end - (doubled ? 1 : 0);
        const bool spaced = has_space_before(tokens_, bars_[i].at) &&
                            has_space_before(tokens_, begin + 1) &&
                            has_space_before(tokens_, last) && has_space_before(tokens_, end + 1);
        if (!spaced || !begins_operand(tokens_[end + 1])) return;
        notes_.add(tokens_[bars_[i].at].offset,
                   tr("| ... | is an absolute value here; for a choice type or"));
    }

    std::span<const Token> tokens_;
    std::span<const Bar> bars_;
    BarPlace place_;
    Notes& notes_;
    std::vector<Role> roles_;
};

}  // namespace

bool ends_operand(const Token& token) {
    if (token.kind == TokenKind::Number || token.kind == TokenKind::Superscript ||
        token.kind == TokenKind::Part)
        return true;
    if (token.kind == TokenKind::Name) {
        return !is_logic_word(token.text) && token.text[0] != '\\' &&
               find_fixed_function(token.text) == nullptr;
    }
    return is_symbol(token, {")", "]", "}", "|)", "⌋", "⌉"});
}

bool begins_operand(const Token& token) {
    if (token.kind == TokenKind::Number || token.kind == TokenKind::Volume) return true;
    if (token.kind == TokenKind::Name) return !is_connective(token);
    return is_symbol(token, {"(", "[", "{", "(|", "⌊", "⌈", "!", "~"});
}

bool has_space_before(std::span<const Token> tokens, std::size_t at) {
    return at > 0 && at < tokens.size() && !adjacent(tokens[at - 1], tokens[at]);
}

std::vector<std::size_t> bars_that_mean_or(std::span<const Token> tokens, std::span<const Bar> bars,
                                           const BarPlace& place, Notes& notes) {
    return BarReader(tokens, bars, place, notes).bars_that_mean_or();
}

}  // namespace zeroset
