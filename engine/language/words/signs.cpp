#include "engine/language/words/signs.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace zeroset {
namespace {

constexpr Sign space{.kind = TokenKind::Symbol, .text = ""};
constexpr Sign symbol(std::string_view text) { return {.kind = TokenKind::Symbol, .text = text}; }
constexpr Sign name(std::string_view text) { return {.kind = TokenKind::Name, .text = text}; }
constexpr Sign number(std::string_view text) { return {.kind = TokenKind::Number, .text = text}; }

constexpr std::array operator_signs{
    std::pair{U'×', symbol("*")},    std::pair{U'·', symbol("*")},
    std::pair{U'⋅', symbol("*")},    std::pair{U'∙', symbol("*")},
    std::pair{U'•', symbol("*")},    std::pair{U'∗', symbol("*")},
    std::pair{U'÷', symbol("/")},    std::pair{U'∕', symbol("/")},
    std::pair{U'⁄', symbol("/")},    std::pair{U'−', symbol("-")},
    std::pair{U'–', symbol("-")},    std::pair{U'—', symbol("-")},
    std::pair{U'≤', symbol("<=")},   std::pair{U'⩽', symbol("<=")},
    std::pair{U'≥', symbol(">=")},   std::pair{U'⩾', symbol(">=")},
    std::pair{U'≠', symbol("!=")},   std::pair{U'∣', symbol("|")},
    std::pair{U'⌊', symbol("⌊")},    std::pair{U'⌋', symbol("⌋")},
    std::pair{U'⌈', symbol("⌈")},    std::pair{U'⌉', symbol("⌉")},
    std::pair{U'ℜ', name("Re")},     std::pair{U'ℑ', name("Im")},
    std::pair{U'√', name("√")},      std::pair{U'∛', name("∛")},
    std::pair{U'∧', name("and")},    std::pair{U'∨', name("or")},
    std::pair{U'¬', name("not")},    std::pair{U'½', number("0.5")},
    std::pair{U'¼', number("0.25")}, std::pair{U'¾', number("0.75")},
};

/// A Greek letter and its LaTeX name. Of them pi, tau, theta, phi and rho have a meaning.
struct Greek {
    char32_t code;
    std::string_view command;
    std::string_view text;

    constexpr Greek(char32_t letter, std::string_view word, std::string_view read_as)
        : code(letter), command(word), text(read_as) {}
};
constexpr std::array greek{
    Greek{U'α', "alpha", "α"},        Greek{U'β', "beta", "β"},     Greek{U'γ', "gamma", "γ"},
    Greek{U'δ', "delta", "δ"},        Greek{U'ε', "epsilon", "ε"},  Greek{U'ϵ', "varepsilon", "ε"},
    Greek{U'ζ', "zeta", "ζ"},         Greek{U'η', "eta", "η"},      Greek{U'θ', "theta", "theta"},
    Greek{U'ϑ', "vartheta", "theta"}, Greek{U'ι', "iota", "ι"},     Greek{U'κ', "kappa", "κ"},
    Greek{U'λ', "lambda", "λ"},       Greek{U'μ', "mu", "μ"},       Greek{U'µ', "mu", "μ"},
    Greek{U'ν', "nu", "ν"},           Greek{U'ξ', "xi", "ξ"},       Greek{U'π', "pi", "pi"},
    Greek{U'ρ', "rho", "rho"},        Greek{U'ϱ', "varrho", "rho"}, Greek{U'σ', "sigma", "σ"},
    Greek{U'τ', "tau", "tau"},        Greek{U'υ', "upsilon", "υ"},  Greek{U'φ', "phi", "phi"},
    Greek{U'ϕ', "varphi", "phi"},     Greek{U'χ', "chi", "χ"},      Greek{U'ψ', "psi", "ψ"},
    Greek{U'ω', "omega", "ω"},        Greek{U'Γ', "Gamma", "Γ"},    Greek{U'Δ', "Delta", "Δ"},
    Greek{U'Θ', "Theta", "Θ"},        Greek{U'Λ', "Lambda", "Λ"},   Greek{U'Ξ', "Xi", "Ξ"},
    Greek{U'Π', "Pi", "Π"},           Greek{U'Σ', "Sigma", "Σ"},    Greek{U'Φ', "Phi", "Φ"},
    Greek{U'Ψ', "Psi", "Ψ"},          Greek{U'Ω', "Omega", "Ω"},
};

constexpr std::array commands{
    std::pair{"cdot", symbol("*")},
    std::pair{"times", symbol("*")},
    std::pair{"ast", symbol("*")},
    std::pair{"div", symbol("/")},
    std::pair{"le", symbol("<=")},
    std::pair{"leq", symbol("<=")},
    std::pair{"leqslant", symbol("<=")},
    std::pair{"ge", symbol(">=")},
    std::pair{"geq", symbol(">=")},
    std::pair{"geqslant", symbol(">=")},
    std::pair{"ne", symbol("!=")},
    std::pair{"neq", symbol("!=")},
    std::pair{"lt", symbol("<")},
    std::pair{"gt", symbol(">")},
    std::pair{"vert", symbol("|")},
    std::pair{"mid", symbol("|")},
    std::pair{"lvert", symbol("(|")},
    std::pair{"rvert", symbol("|)")},
    std::pair{"lfloor", symbol("⌊")},
    std::pair{"rfloor", symbol("⌋")},
    std::pair{"lceil", symbol("⌈")},
    std::pair{"rceil", symbol("⌉")},
    std::pair{"lbrace", symbol("{")},
    std::pair{"rbrace", symbol("}")},
    std::pair{"frac", name("\\frac")},
    std::pair{"dfrac", name("\\frac")},
    std::pair{"tfrac", name("\\frac")},
    std::pair{"cfrac", name("\\frac")},
    std::pair{"sqrt", name("\\sqrt")},
    std::pair{"land", name("and")},
    std::pair{"wedge", name("and")},
    std::pair{"lor", name("or")},
    std::pair{"vee", name("or")},
    std::pair{"lnot", name("not")},
    std::pair{"neg", name("not")},
    std::pair{"Re", name("Re")},
    std::pair{"Im", name("Im")},
    std::pair{"arg", name("arg")},
    std::pair{"sin", name("sin")},
    std::pair{"cos", name("cos")},
    std::pair{"tan", name("tan")},
    std::pair{"sec", name("sec")},
    std::pair{"csc", name("csc")},
    std::pair{"cot", name("cot")},
    std::pair{"arcsin", name("asin")},
    std::pair{"arccos", name("acos")},
    std::pair{"arctan", name("atan")},
    std::pair{"sinh", name("sinh")},
    std::pair{"cosh", name("cosh")},
    std::pair{"tanh", name("tanh")},
    std::pair{"exp", name("exp")},
    std::pair{"ln", name("ln")},
    std::pair{"log", name("log")},
    std::pair{"min", name("min")},
    std::pair{"max", name("max")},
    std::pair{"left", space},
    std::pair{"right", space},
    std::pair{"big", space},
    std::pair{"bigl", space},
    std::pair{"bigr", space},
    std::pair{"Big", space},
    std::pair{"Bigl", space},
    std::pair{"Bigr", space},
    std::pair{"quad", space},
    std::pair{"qquad", space},
    std::pair{"displaystyle", space},
    std::pair{"textstyle", space},
    std::pair{"limits", space},
    std::pair{"operatorname", space},
    std::pair{"mathrm", space},
    std::pair{"mathit", space},
    std::pair{"mathbf", space},
    std::pair{"mathsf", space},
    std::pair{"boldsymbol", space},
    std::pair{"text", space},
};

bool is_space(char32_t code) {
    return code == U'\u00A0' || (code >= U'\u2000' && code <= U'\u200B') || code == U'\u202F' ||
           code == U'\u205F' || code == U'\u2061' || code == U'\u2062' || code == U'\u3000' ||
           code == U'\uFEFF';
}

}  // namespace

CodePoint code_point_at(std::string_view text, std::size_t start) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[start + i]); };
    const unsigned first = byte(0);
    const std::size_t length = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : first >= 0xC0U ? 2 : 1;
    constexpr char32_t none = 0xFFFD;
    if (first < 0x80U) return {.code = first, .length = 1};
    if (length == 1 || start + length > text.size()) return {.code = none, .length = 1};
    char32_t code = first & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) return {.code = none, .length = 1};
        code = code << 6U | (byte(i) & 0x3FU);
    }
    return {.code = code, .length = length};
}

std::optional<Sign> sign_of(char32_t code) {
    if (is_space(code)) return space;
    const auto* const found =
        std::ranges::find(operator_signs, code, &std::pair<char32_t, Sign>::first);
    if (found != operator_signs.end()) return found->second;
    const auto* const letter = std::ranges::find(greek, code, &Greek::code);
    if (letter != greek.end()) return name(letter->text);
    return std::nullopt;
}

bool is_greek(char32_t code) { return std::ranges::find(greek, code, &Greek::code) != greek.end(); }

char superscript_digit(char32_t code) {
    constexpr std::u32string_view raised = U"⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁽⁾";
    const std::size_t at = raised.find(code);
    return at == std::u32string_view::npos ? '\0' : std::string_view("0123456789+-()")[at];
}

char32_t plain_letter(char32_t code) {
    constexpr char32_t first_latin = 0x1D400;  // alphabets of 26 capital and 26 small letters
    constexpr char32_t first_greek = 0x1D6A8;  // alphabets of 58: capital, nabla, small, others
    constexpr char32_t end_of_greek = 0x1D7CB;
    if (code == U'ℎ') return U'h';
    if (code >= first_latin && code < first_latin + 13 * 52) {
        const char32_t letter = (code - first_latin) % 52;
        return letter < 26 ? U'A' + letter : U'a' + letter - 26;
    }
    if (code < first_greek || code >= end_of_greek) return 0;
    const char32_t letter = (code - first_greek) % 58;
    if (letter < 25) return U'Α' + letter;
    if (letter > 25 && letter < 51) return U'α' + letter - 26;
    return letter < 52 ? 0 : U"ϵϑκϕϱπ"[letter - 52];
}

char32_t sign_without_meaning(std::string_view command) {
    constexpr std::array<std::pair<std::string_view, char32_t>, 14> known{{{"pm", U'±'},
                                                                           {"mp", U'∓'},
                                                                           {"sum", U'∑'},
                                                                           {"prod", U'∏'},
                                                                           {"int", U'∫'},
                                                                           {"iint", U'∫'},
                                                                           {"oint", U'∫'},
                                                                           {"partial", U'∂'},
                                                                           {"nabla", U'∇'},
                                                                           {"infty", U'∞'},
                                                                           {"in", U'∈'},
                                                                           {"notin", U'∉'},
                                                                           {"subset", U'⊂'},
                                                                           {"forall", U'∀'}}};
    const auto* const found =
        std::ranges::find(known, command, &std::pair<std::string_view, char32_t>::first);
    return found == known.end() ? 0 : found->second;
}

char subscript_digit(char32_t code) {
    const bool lowered = code >= U'₀' && code <= U'₉';
    return lowered ? static_cast<char>('0' + (code - U'₀')) : '\0';
}

std::optional<Sign> sign_of_command(std::string_view command) {
    for (const auto& [spelling, sign] : commands) {
        if (spelling == command) return sign;
    }
    const auto* const letter = std::ranges::find(greek, command, &Greek::command);
    if (letter != greek.end()) return name(letter->text);
    return std::nullopt;
}

}  // namespace zeroset
