#include "engine/language/vocabulary/functions.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/constants.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

constexpr std::pair<std::string_view, std::string_view> other_spellings[] = {
    {"arcsin", "asin"},
    {"arccos", "acos"},
    {"arctan", "atan"},
    {"arctg", "atan"},
    {"arcsinh", "asinh"},
    {"arccosh", "acosh"},
    {"arctanh", "atanh"},
    {"arsinh", "asinh"},
    {"arcosh", "acosh"},
    {"artanh", "atanh"},
    {"ArcTan", "atan"},  // Mathematica's, whose two arguments are in reverse order
    {"Log", "log"},
    {"arctan2", "atan2"},
    {"sgn", "sign"},
    {"fabs", "abs"},
    {"fmin", "min"},
    {"fmax", "max"},
    {"lg", "log10"},
    {"sen", "sin"},
    {"frac", "fract"},
    {"rint", "round"},
    {"lerp", "mix"},
    {"clip", "clamp"},
    {"power", "pow"},
    {"maximum", "max"},
    {"minimum", "min"},
    {"fabsf", "abs"},
    {"sqrtf", "sqrt"},
    {"powf", "pow"},
    {"expf", "exp"},
    {"logf", "log"},
    {"sinf", "sin"},
    {"cosf", "cos"},
    {"tanf", "tan"},
    {"atan2f", "atan2"},
    {"floorf", "floor"},
    {"fmodf", "fmod"},
    {"fminf", "min"},
    {"fmaxf", "max"},
    {"tg", "tan"},
    {"ctg", "cot"},
    {"cosec", "csc"},
    {"ceiling", "ceil"},
    {"norm", "length"},
    {"intersection", "intersect"},
    {"difference", "subtract"},
    {"product", "prod"},
    {"nthroot", "root"},
    {"perlin", "noise"},
    {"gradient_noise", "noise"},
    {"worley", "cellular"},
    {"wyvill", "blobs"},
    {"soft_objects", "blobs"},
    {"metaball", "metaballs"},
    {"surd", "root"},
    {"real", "Re"},
    {"imag", "Im"},
    {"Arg", "arg"},
    {"Conjugate", "conj"},
    {"conjugate", "conj"},
    {"LegendreP", "legendre"},
    {"legendreP", "legendre"},
    {"eval_legendre", "legendre"},
    {"HermiteH", "hermite"},
    {"hermiteH", "hermite"},
    {"eval_hermite", "hermite"},
    {"LaguerreL", "laguerre"},
    {"laguerreL", "laguerre"},
    {"eval_laguerre", "laguerre"},
    {"ChebyshevT", "chebyshev"},
    {"chebyshevT", "chebyshev"},
    {"eval_chebyt", "chebyshev"},
    {"ChebyshevU", "chebyshev_u"},
    {"chebyshevU", "chebyshev_u"},
    {"eval_chebyu", "chebyshev_u"},
    {"SphericalHarmonicY", "spherical_harmonic"},
    {"sph_harm_y", "spherical_harmonic"},
    {"Erf", "erf"},
    {"Erfc", "erfc"},
    {"Γ", "gamma"},
    {"Gamma", "gamma"},
    {"GAMMA", "gamma"},
    {"tgamma", "gamma"},
    {"gammaln", "lgamma"},
    {"lngamma", "lgamma"},
    {"lnGAMMA", "lgamma"},
    {"LogGamma", "loggamma"},
    {"log_gamma", "lgamma"},
    {"psi", "digamma"},
    {"Psi", "digamma"},
    {"ψ", "digamma"},
    {"Beta", "beta"},
    {"Zeta", "zeta"},
    {"ζ", "zeta"},
    {"W", "lambertw"},
    {"W_0", "lambertw"},
    {"LambertW", "lambertw"},
    {"lambert_w", "lambertw"},
    {"lambertW", "lambertw"},
    {"ProductLog", "lambertw"},
    {"BesselJ", "besselj"},
    {"bessel_j", "besselj"},
    {"bessel_J", "besselj"},
    {"jv", "besselj"},
    {"jn", "besselj"},
    {"besj0", "j0"},
    {"besj1", "j1"},
    {"J0", "j0"},
    {"J1", "j1"},
    {"BesselY", "bessely"},
    {"bessel_y", "bessely"},
    {"bessel_Y", "bessely"},
    {"yv", "bessely"},
    {"yn", "bessely"},
    {"besy0", "y0"},
    {"besy1", "y1"},
    {"Y0", "y0"},
    {"Y1", "y1"},
    {"BesselI", "besseli"},
    {"bessel_i", "besseli"},
    {"bessel_I", "besseli"},
    {"iv", "besseli"},
    {"besi0", "i0"},
    {"besi1", "i1"},
    {"I0", "i0"},
    {"I1", "i1"},
    {"BesselK", "besselk"},
    {"bessel_k", "besselk"},
    {"bessel_K", "besselk"},
    {"kv", "besselk"},
    {"besk0", "k0"},
    {"besk1", "k1"},
    {"K0", "k0"},
    {"K1", "k1"},
    {"besjn", "besselj"},
    {"besyn", "bessely"},
    {"besin", "besseli"},
    {"Sinc", "sinc"},
    {"UnitStep", "heaviside"},
    {"HeavisideTheta", "heaviside"},
    {"√", "sqrt"},
    {"∛", "cbrt"},
};

constexpr std::pair<Op, Op> inverses[] = {
    {Op::Sin, Op::Asin},   {Op::Cos, Op::Acos},   {Op::Tan, Op::Atan},
    {Op::Sinh, Op::Asinh}, {Op::Cosh, Op::Acosh}, {Op::Tanh, Op::Atanh},
};

std::string_view arguments_of(Op op, int arity) {
    if (op == Op::Atan2) return "y, x";
    if (op == Op::If) return "condition, a, b";
    if (op == Op::Where) return "a, condition";
    if (op == Op::Min || op == Op::Max) return "a, b, ...";
    return arity == 1 ? "a" : "a, b";
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Function> make_table() {
    std::vector<Function> table;
    for (const OpInfo& info : operators()) {
        if (info.notation != Notation::Call) continue;
        const bool folds = info.op == Op::Min || info.op == Op::Max;
        table.push_back({.name = info.spelling,
                         .least = info.arity,
                         .most = folds ? -1 : info.arity,
                         .arguments = arguments_of(info.op, info.arity),
                         .meaning = info.about,
                         .op = info.op,
                         .composed = std::nullopt});
    }
#define ZEROSET_FUNCTION(id, word, fewest, greatest, list, about) \
    table.push_back({.name = (word),                              \
                     .least = (fewest),                           \
                     .most = (greatest),                          \
                     .arguments = (list),                         \
                     .meaning = (about),                          \
                     .op = std::nullopt,                          \
                     .composed = Composed::id});
#include "engine/language/vocabulary/functions.def"
#undef ZEROSET_FUNCTION
    const auto count = [](std::string_view arguments) {
        const bool goes_on = arguments.ends_with("...");
        return (goes_on ? 0 : 1) + static_cast<int>(std::ranges::count(arguments, ','));
    };
#define ZEROSET_LIBRARY(word, list, about, formula) \
    table.push_back({.name = (word),                \
                     .least = count(list),          \
                     .most = count(list),           \
                     .arguments = (list),           \
                     .meaning = (about),            \
                     .op = std::nullopt,            \
                     .composed = std::nullopt,      \
                     .body = (formula)});
#include "engine/language/vocabulary/library.def"
#undef ZEROSET_LIBRARY
#define ZEROSET_WORD(part, word, list, letters, about, formula)                          \
    table.push_back({.name = (word),                                                     \
                     .least = count(list) - ((letters)[0] == 'p' ? 1 : 0),               \
                     .most = std::string_view(list).ends_with("...") ? -1 : count(list), \
                     .arguments = (list),                                                \
                     .meaning = (about),                                                 \
                     .op = std::nullopt,                                                 \
                     .composed = std::nullopt,                                           \
                     .body = (formula),                                                  \
                     .kinds = (letters),                                                 \
                     .section = WordSection::part});
#include "engine/language/vocabulary/shapes.def"
#undef ZEROSET_WORD
#define ZEROSET_WRITTEN(part, id, word, fewest, greatest, list, about) \
    table.push_back({.name = (word),                                   \
                     .least = (fewest),                                \
                     .most = (greatest),                               \
                     .arguments = (list),                              \
                     .meaning = (about),                               \
                     .op = std::nullopt,                               \
                     .composed = Composed::id,                         \
                     .section = WordSection::part});
#include "engine/language/vocabulary/noises.def"
#include "engine/language/vocabulary/specials.def"
#include "engine/language/vocabulary/written_out.def"
#undef ZEROSET_WRITTEN
    return table;
}

using Index = std::unordered_map<std::string_view, const Function*>;

Index make_index() {
    Index index;
    for (const Function& function : functions())
        index.emplace(function.name, &function);
    for (const auto& [other, name] : other_spellings)
        index.emplace(other, index.at(name));
    return index;
}

}  // namespace

bool Function::takes(std::size_t arguments_given) const {
    if (repeats() && arguments_given > 1) return arguments_given == static_cast<std::size_t>(most);
    if (joins() && arguments_given == 1) return true;
    return arguments_given >= static_cast<std::size_t>(least) &&
           (most < 0 || arguments_given <= static_cast<std::size_t>(most));
}

std::string Function::refusal(std::size_t arguments_given) const {
    const std::string fewest = std::to_string(least);
    const std::string given = std::to_string(arguments_given);
    if (most < 0)
        return filled(tr("{0} takes {1} or more arguments, not {2}"), {name, fewest, given});
    if (most > least)
        return filled(tr("{0} takes {1} or {2} arguments, not {3}"),
                      {name, fewest, std::to_string(most), given});
    if (most == 1) return filled(tr("{0} takes 1 argument, not {1}"), {name, given});
    return filled(tr("{0} takes {1} arguments, not {2}"), {name, fewest, given});
}

std::span<const Function> functions() {
    static const std::vector<Function> table = make_table();
    return table;
}

const Function* find_function(std::string_view name) {
    static const Index index = make_index();
    const auto found = index.find(name);
    return found == index.end() ? nullptr : found->second;
}

const Function* find_fixed_function(std::string_view name) {
    const Function* const function = find_function(name);
    return function != nullptr && function->is_word() ? nullptr : function;
}

std::vector<std::string_view> function_spellings() {
    std::vector<std::string_view> spellings;
    for (const Function& function : functions())
        spellings.push_back(function.name);
    for (const auto& [other, name] : other_spellings)
        spellings.push_back(other);
    return spellings;
}

const Function* inverse_of(const Function& function) {
    const auto* const found = std::ranges::find(
        inverses, function.op, [](const auto& pair) { return std::optional(pair.first); });
    if (found == std::end(inverses)) return nullptr;
    return find_function(op_info(found->second).spelling);
}

}  // namespace zeroset
