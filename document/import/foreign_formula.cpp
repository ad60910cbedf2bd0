#include "document/import/foreign_formula.hpp"

#include "document/import/imported.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <span>
#include <utility>

namespace zeroset {
namespace {

using ReadTerm = std::expected<ForeignTerm, TermError>;

/// Signs that stand between operands, from those that bind least to those that bind most.
using Signs = std::initializer_list<std::string_view>;
struct Level {
    std::array<std::string_view, 8> signs;
};
constexpr std::array<Level, 5> levels{{
    {{"|", "||"}},
    {{"&", "&&"}},
    {{"=", "==", "!=", "<", ">", "<=", ">="}},
    {{"+", "-"}},
    {{"*", "/", "%"}},
}};
constexpr std::size_t comparisons = 2;

/// Precedence of what a term is written as: that of its level, or one of these.
constexpr std::size_t prefix_level = levels.size();
constexpr std::size_t power_level = prefix_level + 1;
constexpr std::size_t operand_level = power_level + 1;

std::size_t level_of_sign(std::string_view sign) {
    for (std::size_t level = 0; level < levels.size(); ++level) {
        if (std::ranges::find(levels[level].signs, sign) != levels[level].signs.end()) return level;
    }
    return operand_level;
}

std::size_t level_of(const ForeignTerm& term) {
    switch (term.kind) {
        case TermKind::Chain: return level_of_sign(term.signs[1]);
        case TermKind::Prefix: return prefix_level;
        case TermKind::Power: return power_level;
        case TermKind::Number: return term.text.starts_with('-') ? prefix_level : operand_level;
        case TermKind::Name:
        case TermKind::Call: break;
    }
    return operand_level;
}

class Reader {
public:
    Reader(TokenReader& tokens, const Dialect& dialect) : tokens_(tokens), dialect_(dialect) {}

    ReadTerm chain(std::size_t level) {
        if (level == levels.size()) return prefix();
        ReadTerm first = chain(level + 1);
        if (!first) return first;
        ForeignTerm result = std::move(*first);
        bool is_chain = false;
        while (is_sign_of(level)) {
            const ScriptToken sign = tokens_.next();
            ReadTerm operand = chain(level + 1);
            if (!operand) return operand;
            if (!is_chain) {
                ForeignTerm begun{.kind = TermKind::Chain, .line = result.line};
                begun.operands.push_back(std::move(result));
                begun.signs.emplace_back();
                result = std::move(begun);
                is_chain = true;
            }
            result.operands.push_back(std::move(*operand));
            result.signs.emplace_back(sign.text);
        }
        return result;
    }

private:
    [[nodiscard]] bool is_sign_of(std::size_t level) const {
        const ScriptToken& token = tokens_.peek();
        if (token.kind != ScriptKind::Sign) return false;
        if (token.text == "=" && !dialect_.equals_is_condition) return false;
        return level_of_sign(token.text) == level;
    }

    [[nodiscard]] std::unexpected<TermError> error(std::string reason) const {
        return std::unexpected(TermError{.line = tokens_.line(), .reason = std::move(reason)});
    }

    ReadTerm prefix() {
        const std::size_t line = tokens_.line();
        if (++depth_ > most_depth) return error(tr("the formula is nested too deeply"));
        ReadTerm result = signed_operand(line);
        --depth_;
        return result;
    }

    ReadTerm signed_operand(std::size_t line) {
        if (tokens_.take_sign("+")) return prefix();
        const bool minus = tokens_.at_sign("-");
        if (!minus && !tokens_.at_sign("!")) return power();
        std::string sign(tokens_.next().text);
        ReadTerm operand = minus && dialect_.minus_before_power ? tight_operand() : prefix();
        if (!operand) return operand;
        ForeignTerm result{.kind = TermKind::Prefix, .text = std::move(sign), .line = line};
        result.operands.push_back(std::move(*operand));
        if (minus && dialect_.minus_before_power) return powers_of(std::move(result));
        return result;
    }

    /// The operand of a minus that binds more tightly than ^.
    ReadTerm tight_operand() {
        if (tokens_.at_sign("-") || tokens_.at_sign("+")) return prefix();
        return operand();
    }

    ReadTerm power() {
        ReadTerm base = operand();
        if (!base) return base;
        return powers_of(std::move(*base));
    }

    ReadTerm powers_of(ForeignTerm base) {
        ReadTerm result(std::move(base));
        for (int powers = 1; result && tokens_.at_sign("^"); ++powers) {
            if (powers > most_depth) return error(tr("the formula is nested too deeply"));
            tokens_.next();
            result = power_of(std::move(*result));
        }
        return result;
    }

    ReadTerm power_of(ForeignTerm base) {
        ReadTerm exponent = dialect_.power_from_left ? sign_and_operand() : prefix();
        if (!exponent) return exponent;
        ForeignTerm result{.kind = TermKind::Power, .line = base.line};
        result.operands.push_back(std::move(base));
        result.operands.push_back(std::move(*exponent));
        return result;
    }

    /// An exponent without the powers that follow it.
    ReadTerm sign_and_operand() {
        const std::size_t line = tokens_.line();
        if (!tokens_.take_sign("-")) return operand();
        ReadTerm inner = operand();
        if (!inner) return inner;
        ForeignTerm result{.kind = TermKind::Prefix, .text = "-", .line = line};
        result.operands.push_back(std::move(*inner));
        return result;
    }

    ReadTerm operand() {
        const ScriptToken token = tokens_.peek();
        const bool bracket = token.text == "(" || token.text == "[";
        if (token.kind == ScriptKind::Sign && bracket) {
            tokens_.next();
            ReadTerm inner = chain(0);
            if (!inner) return inner;
            if (!tokens_.take_sign(token.text == "(" ? ")" : "]"))
                return error(tr("a closing bracket is missing"));
            return inner;
        }
        if (token.kind == ScriptKind::Number) {
            tokens_.next();
            return ForeignTerm{
                .kind = TermKind::Number, .text = std::string(token.text), .line = token.line};
        }
        if (token.kind != ScriptKind::Name) return error(tr("a number or a name is missing"));
        tokens_.next();
        ForeignTerm name{
            .kind = TermKind::Name, .text = std::string(token.text), .line = token.line};
        if (!tokens_.at_sign("(")) return name;
        name.kind = TermKind::Call;
        ReadTerm call = arguments_of(std::move(name));
        const bool part = call && dialect_.parts_of_calls && tokens_.at_sign(".") &&
                          tokens_.peek(1).kind == ScriptKind::Name;
        if (!part) return call;
        tokens_.next();
        call->text += "." + std::string(tokens_.next().text);
        return call;
    }

    ReadTerm arguments_of(ForeignTerm call) {
        do {
            tokens_.next();
            if (call.operands.empty() && tokens_.at_sign(")")) break;
            ReadTerm argument = chain(0);
            if (!argument) return argument;
            call.operands.push_back(std::move(*argument));
        } while (tokens_.at_sign(","));
        if (!tokens_.take_sign(")")) return error(tr("a closing bracket is missing"));
        return call;
    }

    TokenReader& tokens_;
    const Dialect& dialect_;
    int depth_ = 0;
};

void write(std::string& text, const ForeignTerm& term, std::size_t least);

/// The sign as the language has it, where it could mean something else there.
std::string_view plain_sign(std::string_view sign) {
    if (sign == "|" || sign == "||") return "or";
    if (sign == "&" || sign == "&&") return "and";
    return sign == "=" ? "==" : sign;
}

void write_chain(std::string& text, const ForeignTerm& term) {
    const std::size_t level = level_of(term);
    const bool spaced = level != 4;
    for (std::size_t i = 0; i < term.operands.size(); ++i) {
        const std::string sign(i > 0 ? plain_sign(term.signs[i]) : "");
        if (i > 0) text += spaced ? " " + sign + " " : sign;
        // A comparison of a comparison means something else without parentheses.
        const bool loose = i == 0 && level != comparisons;
        write(text, term.operands[i], loose ? level : level + 1);
    }
}

void write_call(std::string& text, const ForeignTerm& call) {
    const std::size_t dot = std::min(call.text.find('.'), call.text.size());
    text += call.text.substr(0, dot) + "(";
    for (std::size_t i = 0; i < call.operands.size(); ++i) {
        if (i > 0) text += ", ";
        write(text, call.operands[i], 0);
    }
    text += ")" + call.text.substr(dot);
}

void write(std::string& text, const ForeignTerm& term, std::size_t least) {
    const bool bracketed = level_of(term) < least;
    if (bracketed) text += '(';
    switch (term.kind) {
        case TermKind::Number:
        case TermKind::Name: text += term.text; break;
        case TermKind::Call: write_call(text, term); break;
        case TermKind::Prefix:
            text += term.text == "!" ? "not " : term.text;
            write(text, term.operands[0], power_level);
            break;
        case TermKind::Power:
            write(text, term.operands[0], operand_level);
            text += '^';
            write(text, term.operands[1], operand_level);
            break;
        case TermKind::Chain: write_chain(text, term); break;
    }
    if (bracketed) text += ')';
}

}  // namespace

std::expected<ForeignTerm, TermError> read_term(TokenReader& tokens, const Dialect& dialect) {
    return Reader(tokens, dialect).chain(0);
}

std::expected<ForeignTerm, TermError> read_whole_term(std::string_view text,
                                                      const Dialect& dialect) {
    TokenReader tokens(script_tokens(text));
    auto term = read_term(tokens, dialect);
    if (term && !tokens.at_end()) {
        return std::unexpected(TermError{.line = tokens.line(),
                                         .reason = filled(tr("'{0}' does not continue the formula"),
                                                          {tokens.peek().text.substr(0, 20)})});
    }
    return term;
}

std::string text_of(const ForeignTerm& term) {
    std::string text;
    write(text, term, 0);
    return text;
}

void for_each_part(ForeignTerm& term, const std::function<void(ForeignTerm&)>& change) {
    for (ForeignTerm& operand : term.operands)
        for_each_part(operand, change);
    change(term);
}

ForeignTerm call_of(std::string function, std::vector<ForeignTerm> operands, std::size_t line) {
    return {.kind = TermKind::Call,
            .text = std::move(function),
            .operands = std::move(operands),
            .line = line};
}

ForeignTerm number_term(double value, std::size_t line) {
    return {.kind = TermKind::Number, .text = exact_number(value), .line = line};
}

}  // namespace zeroset
