#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/syntax/syntax_parser.hpp"
#include "engine/language/words/words.hpp"

#include <algorithm>
#include <array>

// Calls of polynomials with names, and factorials.

namespace zeroset {

/// The number of arguments in the bracket at this index; 0: there is none.
std::size_t SyntaxParser::arguments_at(std::size_t opener) const {
    if (!is_symbol(tokens_[opener], {"(", "["})) return 0;
    int open = 0;
    std::size_t count = 1;
    for (std::size_t at = opener; tokens_[at].kind != TokenKind::End; ++at) {
        if (is_symbol(tokens_[at], {"(", "[", "{"})) ++open;
        if (is_symbol(tokens_[at], {")", "]", "}"}) && --open == 0) break;
        if (open == 1 && is_symbol(tokens_[at], {","})) ++count;
    }
    return count;
}

/// Whether the name at this index is T_n, U_n, P_n, H_n or L_n and called: the bracket stands
/// directly behind it, and it is no name of the text, nor a point P_2(1, 2, 3). T_0 and T_1 are
/// parameters unless one of a higher degree is called in the text, and so with the others.
bool SyntaxParser::is_polynomial(std::size_t at, int degree) {
    const Token& token = tokens_[at];
    const Token& opener = tokens_[at + 1];
    if (!is_symbol(opener, {"(", "["}) || !adjacent(token, opener)) return false;
    if (defined_.find(full_name(token), token.offset)) return false;
    const char letter = token.text[0] == 'U' ? 'T' : token.text[0];
    if (letter != 'T' && arguments_at(at + 1) != 1) return false;
    if (degree >= 2) return true;
    const auto [known, is_new] = calls_polynomial_.try_emplace(letter, false);
    for (std::size_t i = 0; is_new && !known->second && i < tokens_.size(); ++i) {
        if (tokens_[i].kind != TokenKind::Name) continue;
        const char other = tokens_[i].text[0] == 'U' ? 'T' : tokens_[i].text[0];
        const auto higher =
            other == letter ? polynomial_degree(full_name(tokens_[i])) : std::nullopt;
        known->second = higher && *higher >= 2 && is_polynomial(i, *higher);
    }
    return known->second;
}

/// Reads a call of a spherical harmonic, a Bessel function or a polynomial by a letter, whose name
/// has just been taken; nothing where it is none.
std::optional<SyntaxParser::Parsed> SyntaxParser::call_by_letter(const Token& token,
                                                                 const std::string& name) {
    if (const auto call = harmonic_at(token)) return harmonic(token, *call);
    if (const Function* const bessel = bessel_function(name); bessel && is_bessel(at_ - 1))
        return bessel_call(token, *bessel);
    const auto degree = polynomial_degree(name);
    if (!degree || !is_polynomial(at_ - 1, *degree)) return std::nullopt;
    return polynomial_of(token, *degree);
}

/// Reads P_n(a), H_n(a), L_n(a), T_n(a) or U_n(a), which is legendre(n, a) and so on.
SyntaxParser::Parsed SyntaxParser::polynomial_of(const Token& token, int degree) {
    static constexpr std::array<std::array<std::string_view, 3>, 5> others{
        {{"P", "legendre", "Legendre"},
         {"H", "hermite", "Hermite"},
         {"L", "laguerre", "Laguerre"},
         {"T", "chebyshev", "Chebyshev"},
         {"U", "chebyshev_u", "Chebyshev"}}};
    const auto& other =
        *std::ranges::find_if(others, [&](const auto& row) { return row[0] == token.text; });
    const std::string name = full_name(token);
    const Token& opener = next();
    const List values = arguments();
    if (!values || !close(opener)) return std::nullopt;
    if (values->size() != 1) {
        return fail(token, filled(tr("{0} takes 1 argument, not {1}"),
                                  {name, std::to_string(values->size())}));
    }
    tree_.notes.add(token.offset, filled(tr("{0} is {1}'s polynomial; for a product type {2}"),
                                         {name, other[2], name + "*(...)"}));
    const SyntaxId count = add(SyntaxKind::Number, token.offset, {}, {}, std::to_string(degree));
    return add_call(*find_function(other[1]), token.offset, {count, values->front()});
}

/// Reads the rest of n!, which is prod(i, i, 1, n).
SyntaxParser::Parsed SyntaxParser::factorial(SyntaxId of) {
    const std::size_t offset = take().offset;
    const auto index = [&] { return add(SyntaxKind::Name, offset, {}, {}, "factor of n!"); };
    const SyntaxId factor = index();
    const SyntaxId one = add(SyntaxKind::Number, offset, {}, {}, "1");
    const std::vector<SyntaxId> operands{factor, index(), one, of};
    return add_call(*find_function("prod"), offset, operands);
}

/// Where the call of a spherical harmonic begins whose name has just been taken, and its degree and
/// order: Y_2^1(a, b), Y_2^{-1}(a, b) or Y_{21}(a, b).
std::optional<SyntaxParser::Harmonic> SyntaxParser::harmonic_at(const Token& token) const {
    const std::string degree = subscript_text(token);
    const auto is_number = [](std::string_view text) {
        return !text.empty() && text.size() < 3 && std::ranges::all_of(text, is_digit);
    };
    if (token.text != "Y" || !is_number(degree) || defined_.find(full_name(token), token.offset))
        return std::nullopt;
    std::size_t at = at_;
    const auto skips = [&](std::string_view symbol) {
        const bool is_next = is_symbol(tokens_[at], {symbol});
        at += is_next ? 1 : 0;
        return is_next;
    };
    Harmonic found{.opener = 0, .degree = degree, .order = {}, .is_negative = false};
    if (skips("^")) {
        const bool has_brace = skips("{");
        found.is_negative = skips("-");
        if (tokens_[at].kind == TokenKind::Number) found.order = tokens_[at++].text;
        if (has_brace && !skips("}")) return std::nullopt;
    } else if (degree.size() == 2) {
        found.degree = degree.substr(0, 1);
        found.order = degree.substr(1);
    }
    found.opener = at;
    return is_number(found.order) && arguments_at(at) == 2 ? std::optional(found) : std::nullopt;
}

SyntaxParser::Parsed SyntaxParser::harmonic(const Token& token, const Harmonic& of) {
    at_ = of.opener;
    const Token& opener = next();
    const List angles = arguments();
    if (!angles || !close(opener)) return std::nullopt;
    tree_.notes.add(token.offset,
                    filled(tr("{0} is the spherical harmonic; its first angle is the one from the "
                              "z-axis"),
                           {full_name(token)}));
    const SyntaxId degree = add(SyntaxKind::Number, token.offset, {}, {}, of.degree);
    SyntaxId order = add(SyntaxKind::Number, token.offset, {}, {}, of.order);
    if (of.is_negative) order = add(SyntaxKind::Negate, token.offset, {order});
    return add_call(*find_function("spherical_harmonic"), token.offset,
                    {degree, order, (*angles)[0], (*angles)[1]});
}

}  // namespace zeroset
