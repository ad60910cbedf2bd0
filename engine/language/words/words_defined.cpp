#include "engine/language/words/words_defined.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/vocabulary/functions.hpp"
#include "engine/language/vocabulary/parse_notes.hpp"
#include "engine/language/words/signs.hpp"
#include "engine/language/words/words_candidates.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace zeroset {
namespace {

constexpr std::array<std::string_view, 23> type_words{
    "float", "double", "int",   "real",   "const",   "let",    "var",   "val",
    "def",   "auto",   "local", "static", "declare", "lowp",   "highp", "mediump",
    "vec2",  "vec3",   "vec4",  "bool",   "float2",  "float3", "float4"};

/// Whether a name is one letter, ASCII or not; such names are never split.
bool is_letter_name(std::string_view name) {
    return name.size() == 1 || code_point_at(name, 0).length == name.size();
}

/// Whether a name is one of a coordinate of the point, or of the fourth one.
bool is_coordinate(const std::string& name) { return is_place(name) || name == "t" || name == "w"; }

/// The factors joined by "*", but by a space after a function: "sin x".
std::string product_of(const std::vector<std::string>& factors) {
    constexpr std::size_t longest = 40;
    std::string product;
    bool follows_function = false;
    for (const std::string& factor : factors) {
        if (product.size() > longest) return product + "...";
        if (!product.empty()) product += follows_function ? ' ' : '*';
        product += factor;
        follows_function = find_fixed_function(factor) != nullptr;
    }
    return product;
}

/// Whether the value of a function has a name in it that an argument, or a product of some, may be.
bool mentions_argument(const Candidate& candidate) {
    return std::ranges::any_of(candidate.value, [&](const Token& token) {
        const std::string name = plain_name(token.text);
        return token.kind == TokenKind::Name && find_function(name) == nullptr &&
               std::ranges::any_of(candidate.arguments, [&](const std::string& argument) {
                   return name.contains(argument);
               });
    });
}

/// Whether a name is known as a function's, though the language lacks it or reads it later: erfi,
/// T_2, Chebyshev's polynomial, and J_2, a Bessel function.
bool is_known_by_name(std::string_view name) {
    constexpr std::array<std::string_view, 5> names{"erfi", "Ai", "Bi", "Si", "Ci"};
    return std::ranges::find(names, name) != names.end() || polynomial_degree(name) ||
           bessel_function(name) != nullptr;
}

/// Whether a function's value has a coordinate in it, but none of its arguments, which are
/// coordinates: erf(x) = z.
bool relates_coordinates(const Candidate& candidate) {
    constexpr std::string_view axes = "xyz";
    const bool of_axes = std::ranges::all_of(candidate.arguments, [&](const std::string& argument) {
        return argument.size() == 1 && axes.contains(argument);
    });
    return of_axes && !mentions_argument(candidate) &&
           std::ranges::any_of(candidate.value, [&](const Token& token) {
               return token.kind == TokenKind::Name &&
                      token.text.find_first_not_of(axes) == std::string_view::npos;
           });
}

}  // namespace

std::optional<int> polynomial_degree(std::string_view plain_name) {
    constexpr int highest = 20;  // its coefficients are exact
    if (plain_name.size() < 3 || plain_name[1] != '_' ||
        !std::string_view("TUPHL").contains(plain_name[0]))
        return std::nullopt;
    const std::string digits(plain_name.substr(2));
    const bool is_number =
        !digits.empty() && digits.size() <= 2 && std::ranges::all_of(digits, is_digit);
    const int degree = is_number ? std::stoi(digits) : highest + 1;
    return degree <= highest ? std::optional(degree) : std::nullopt;
}

const Function* bessel_function(std::string_view plain_name) {
    if (plain_name.size() < 3 || plain_name[1] != '_') return nullptr;
    constexpr std::size_t most_digits = 2;
    const std::string_view order = plain_name.substr(2);
    const bool is_number = order.size() <= most_digits && std::ranges::all_of(order, is_digit);
    if (!is_number && order != "n" && order != "m" && order != "k") return nullptr;
    switch (plain_name[0]) {
        case 'J': return find_function("besselj");
        case 'Y': return find_function("bessely");
        case 'I': return find_function("besseli");
        case 'K': return find_function("besselk");
        default: return nullptr;
    }
}

bool is_type_word(std::string_view word) {
    return std::ranges::find(type_words, word) != type_words.end();
}

bool is_plain_name(std::string_view run) {
    return std::ranges::all_of(run, [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
}

bool declares(const Token& word, const Token& next) {
    const bool follows = next.kind == TokenKind::Name && word.kind == TokenKind::Name;
    return follows && (word.text == "in" ? is_type_word(next.text) : is_type_word(word.text));
}

std::string plain_name(std::string_view run) {
    std::string name;
    bool lowered = false;
    for (std::size_t at = 0; at < run.size();) {
        const CodePoint point = code_point_at(run, at);
        const char digit = subscript_digit(point.code);
        if (digit != '\0') {
            if (!lowered) name += '_';
            name += digit;
        } else if (const auto sign = point.length > 1 ? sign_of(point.code) : std::nullopt) {
            name += sign->text;
        } else if (run[at] != '{' && run[at] != '}') {
            name += run[at];
        }
        lowered = digit != '\0';
        at += point.length;
    }
    return name;
}

std::optional<std::string_view> DefinedNames::find(std::string_view run, std::size_t offset) const {
    if (const auto known = find_plain(words_, run); known != words_.end()) return *known;
    const auto next = std::ranges::upper_bound(scopes_, offset, {}, &Scope::begin);
    if (next == scopes_.begin() || std::prev(next)->end <= offset) return std::nullopt;
    const NameSet& names = std::prev(next)->names;
    if (const auto known = find_plain(names, run); known != names.end()) return *known;
    return std::nullopt;
}

bool DefinedNames::takes(std::string_view name, std::size_t arguments) const {
    const auto function = functions_.find(name);
    return function != functions_.end() && function->second.contains(arguments);
}

/// Decides which candidates are definitions.
class DefinitionSearch {
public:
    DefinitionSearch(const Candidates& candidates, DefinedNames& result, Notes& notes)
        : candidates_(candidates), result_(result), notes_(notes) {}

    void run() {
        for (const Candidate& candidate : candidates_.all()) {
            const bool defines =
                candidate.is_function ? defines_function(candidate) : defines_value(candidate);
            if (defines) add(candidate);
        }
        for (const Candidate& candidate : candidates_.all())
            add_scope(candidate);
    }

private:
    void add(const Candidate& candidate) {
        if (candidate.is_function) {
            result_.functions_[candidate.name].insert(candidate.arguments.size());
        } else {
            result_.values_.insert(candidate.name);
        }
        if (!is_letter_name(candidate.name) && !is_built_in_value(candidate.name))
            result_.words_.insert(candidate.name);
    }
    void add_scope(const Candidate& candidate) {
        DefinedNames::Scope scope{.begin = candidate.begin, .end = candidate.end, .names = {}};
        for (const auto& names : {candidate.arguments, candidate.indices}) {
            for (const std::string& name : names) {
                const bool is_free = !is_built_in_value(name) && !is_logic_word(name);
                if (is_free && !is_letter_name(name)) scope.names.insert(name);
            }
        }
        if (!scope.names.empty()) result_.scopes_.push_back(std::move(scope));
    }

    [[nodiscard]] bool defines_value(const Candidate& candidate) const;
    [[nodiscard]] bool defines_product(const Candidate& candidate,
                                       const std::vector<std::string>& factors) const;
    [[nodiscard]] bool defines_place(const Candidate& candidate, const NameUses& uses) const;
    [[nodiscard]] bool defines_function(const Candidate& candidate) const;

    const Candidates& candidates_;
    DefinedNames& result_;
    Notes& notes_;
};

bool DefinitionSearch::defines_value(const Candidate& candidate) const {
    const std::string& name = candidate.name;
    if (name.empty() || name == "x" || name == "y" || name == "z" || is_logic_word(name)) {
        return false;
    }
    if (candidate.is_certain || is_letter_name(name)) return true;
    if (is_built_in_value(name)) return false;  // decided later, when all statements are known
    if (const Function* const function = find_fixed_function(name)) {
        const NameUses uses = candidates_.uses(name);
        const bool elementary = function->op && function->takes(1);  // sin = 2 is a mistake
        return uses.all > uses.calls || !elementary;
    }
    const std::vector<std::string> factors = candidates_.factors(name);
    return factors.size() < 2 || defines_product(candidate, factors);
}

/// Whether cx = 0.1 defines cx rather than a product: another statement uses cx, the product would
/// be no surface, or the letter c occurs nowhere else.
bool DefinitionSearch::defines_product(const Candidate& candidate,
                                       const std::vector<std::string>& factors) const {
    const auto is_xyz = [](const std::string& factor) {
        return factor == "x" || factor == "y" || factor == "z" || is_digit(factor[0]) ||
               find_fixed_function(factor) != nullptr;
    };
    const bool is_letter_known = std::ranges::any_of(factors, [&](const std::string& factor) {
        return !is_built_in(factor) && candidates_.is_known_factor(factor);
    });
    const std::string& name = candidate.name;
    const bool used = candidates_.uses(name).all > 0;
    const bool of_places_only = std::ranges::all_of(factors, is_xyz);  // as in xy = 1
    if (!used && (of_places_only || !candidates_.is_constant(candidate))) return false;
    const bool is_no_surface = std::ranges::none_of(factors, is_place);
    const bool defines = used || is_no_surface || (!is_letter_known && candidates_.has_equations());
    const bool is_plain =
        defines ? (used || is_no_surface) && !is_letter_known && !of_places_only : is_letter_known;
    if (is_plain) return defines;
    const std::string product = product_of(factors);
    notes_.add(
        candidate.begin,
        defines ? filled(tr("{0} is a name of its own here; otherwise type {1}"), {name, product})
                : filled(tr("{0} is read as {1} here; to define the name type {2}"),
                         {name, product, name + " := ..."}));
    return defines;
}

/// Whether r(x, y) = ... or phi(x, y, z) = ... defines a function of that name, and is no equation.
bool DefinitionSearch::defines_place(const Candidate& candidate, const NameUses& uses) const {
    const std::string& name = candidate.name;
    const bool of_coordinates = std::ranges::all_of(candidate.arguments, is_coordinate);
    // phi(x, y, z) = ... is a function that is 0 on a surface, as papers have it.
    const bool is_axis = name == "x" || name == "y" || name == "z";
    if (!is_axis && candidate.arguments.size() == 3 && of_coordinates) return true;
    const bool called = uses.calls > 0;
    if (!called && of_coordinates) {
        result_.places_.insert(candidate.name_offset);
        notes_.add(candidate.begin, filled(tr("read as {0}; for the product type {1}"),
                                           {name + " = ...", name + "*(...)"}));
        return false;
    }
    return called || candidate.arguments.size() > 1;
}

bool DefinitionSearch::defines_function(const Candidate& candidate) const {
    const std::string& name = candidate.name;
    if (candidate.is_certain) return true;
    const bool is_log = name.starts_with("log_") && is_digit(name[4]);
    if (is_log && candidates_.uses(name).calls == 0) return false;  // log_2(x) = y is an equation
    const NameUses uses = candidates_.uses(name);
    const Function* const word = find_function(name);
    if (is_letter_name(name) && !is_built_in_value(name)) {
        // W(x) = z is an equation of Lambert's W.
        const bool is_special = word != nullptr && word->is_special();
        return !is_special || mentions_argument(candidate) || uses.calls > 0;
    }
    if (is_place(name)) return defines_place(candidate, uses);
    if (is_built_in_value(name)) return uses.calls > 0 || candidate.arguments.size() > 1;
    if (word != nullptr && word->is_word())
        return mentions_argument(candidate);  // else it is an equation, as sphere(p, r) = 1
    if (find_fixed_function(name) != nullptr) {
        return uses.calls > 0 && candidates_.depends_on_arguments_only(candidate);
    }
    if (candidate.arguments.size() > 1 || uses.calls > 0) return true;
    if (is_known_by_name(name) && relates_coordinates(candidate)) return false;
    const std::vector<std::string> factors = candidates_.factors(name);
    if (factors.size() < 2) return true;
    const bool is_formula = std::ranges::all_of(factors, is_coordinate) ||
                            std::ranges::any_of(factors, [](const std::string& factor) {
                                return find_fixed_function(factor) != nullptr;
                            });
    return !is_formula;
}

DefinedNames::DefinedNames(std::span<const Token> tokens, std::size_t counted_end, Notes& notes) {
    const Candidates candidates(tokens, counted_end);
    DefinitionSearch(candidates, *this, notes).run();
}

}  // namespace zeroset
