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
#define ZEROSET_NOISE(id, word, fewest, greatest, list, about) \
    table.push_back({.name = (word),                           \
                     .least = (fewest),                        \
                     .most = (greatest),                       \
                     .arguments = (list),                      \
                     .meaning = (about),                       \
                     .op = std::nullopt,                       \
                     .composed = Composed::id,                 \
                     .section = WordSection::Noise});
#include "engine/language/vocabulary/noises.def"
#undef ZEROSET_NOISE
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

/// Applies a binary operator from left to right to two or more arguments, or returns the only one.
NodeId fold(ExprBuilder& builder, Op op, std::span<const NodeId> arguments) {
    return std::accumulate(arguments.begin() + 1, arguments.end(), arguments.front(),
                           [&](NodeId a, NodeId b) { return make_call(builder, op, a, b); });
}

NodeId length_of(ExprBuilder& builder, std::span<const NodeId> arguments) {
    if (arguments.size() == 1) return make_call(builder, Op::Abs, arguments.front());
    const auto square = [&](NodeId a) { return make_multiply(builder, a, a); };
    const NodeId sum =
        std::accumulate(arguments.begin() + 1, arguments.end(), square(arguments.front()),
                        [&](NodeId a, NodeId b) { return make_add(builder, a, square(b)); });
    return make_call(builder, Op::Sqrt, sum);
}

/// The quadratic blend min(a, b) - h^2 / (4 k) with h = max(k - |a - b|, 0); it differs from min
/// only where |a - b| < k.
NodeId smooth_min(ExprBuilder& builder, NodeId a, NodeId b, NodeId k) {
    const NodeId distance = make_call(builder, Op::Abs, make_subtract(builder, a, b));
    const NodeId h =
        make_call(builder, Op::Max, make_subtract(builder, k, distance), builder.constant(0.0));
    const NodeId blend = make_divide(builder, make_multiply(builder, h, h),
                                     make_multiply(builder, builder.constant(4.0), k));
    return make_subtract(builder, make_call(builder, Op::Min, a, b), blend);
}

NodeId smooth_max(ExprBuilder& builder, NodeId a, NodeId b, NodeId k) {
    return make_negate(builder,
                       smooth_min(builder, make_negate(builder, a), make_negate(builder, b), k));
}

NodeId make_logarithm(ExprBuilder& builder, std::span<const NodeId> a) {
    if (a.size() == 1) return make_call(builder, Op::Log, a[0]);
    const std::optional<double> base = exact_value(builder, a[1]);
    if (base == 2.0) return make_call(builder, Op::Log2, a[0]);
    if (base == 10.0) return make_call(builder, Op::Log10, a[0]);
    return make_divide(builder, make_call(builder, Op::Log, a[0]),
                       make_call(builder, Op::Log, a[1]));
}

/// trunc(a): floor(a) for a >= 0, ceil(a) below.
NodeId make_trunc(ExprBuilder& builder, NodeId a) {
    const NodeId below = make_call(builder, Op::Less, a, builder.constant(0.0));
    return make_call(builder, Op::If, below, make_call(builder, Op::Ceil, a),
                     make_call(builder, Op::Floor, a));
}

NodeId make_clamp(ExprBuilder& builder, NodeId a, NodeId low, NodeId high) {
    return make_call(builder, Op::Min, make_call(builder, Op::Max, a, low), high);
}

/// t^2 (3 - 2t) with t = (a - low)/(high - low) clamped to [0, 1].
NodeId make_smooth_step(ExprBuilder& builder, NodeId low, NodeId high, NodeId a) {
    const NodeId whole = make_subtract(builder, high, low);
    const NodeId part = make_divide(builder, make_subtract(builder, a, low), whole);
    const NodeId t = make_clamp(builder, part, builder.constant(0.0), builder.constant(1.0));
    const NodeId twice = make_multiply(builder, builder.constant(2.0), t);
    return make_multiply(builder, make_multiply(builder, t, t),
                         make_subtract(builder, builder.constant(3.0), twice));
}

NodeId make_fmod(ExprBuilder& builder, NodeId a, NodeId b) {
    const NodeId whole = make_trunc(builder, make_divide(builder, a, b));
    return make_subtract(builder, a, make_multiply(builder, b, whole));
}

/// a + t*(b - a)
NodeId make_mix(ExprBuilder& builder, NodeId a, NodeId b, NodeId t) {
    return make_add(builder, a, make_multiply(builder, t, make_subtract(builder, b, a)));
}

NodeId make_step(ExprBuilder& builder, NodeId edge, NodeId a) {
    return make_call(builder, Op::If, make_call(builder, Op::Less, a, edge), builder.constant(0.0),
                     builder.constant(1.0));
}

/// POV-Ray's select(a, below, above) and select(a, below, at 0, above).
NodeId make_select(ExprBuilder& builder, std::span<const NodeId> a) {
    const NodeId zero = builder.constant(0.0);
    NodeId otherwise = a[2];
    if (a.size() == 4) {
        const NodeId above = make_call(builder, Op::Less, zero, a[0]);
        otherwise = make_call(builder, Op::If, above, a[3], a[2]);
    }
    return make_call(builder, Op::If, make_call(builder, Op::Less, a[0], zero), a[1], otherwise);
}

NodeId pi_of(ExprBuilder& builder) { return builder.constant(pi.value.lo, pi.value.hi); }

/// The angle a in other units: a*p/q.
NodeId make_angle(ExprBuilder& builder, NodeId a, NodeId p, NodeId q) {
    return make_multiply(builder, make_divide(builder, p, q), a);
}

using Blend = NodeId (*)(ExprBuilder&, NodeId, NodeId, NodeId);

NodeId smooth_without(ExprBuilder& builder, NodeId a, NodeId b, NodeId k) {
    return smooth_max(builder, a, make_negate(builder, b), k);
}

/// Blends all but the last argument, which is the width k, from left to right.
NodeId blended(ExprBuilder& builder, std::span<const NodeId> a, Blend blend) {
    const auto solids = a.first(a.size() - 1);
    return std::accumulate(solids.begin() + 1, solids.end(), solids.front(),
                           [&](NodeId of, NodeId b) { return blend(builder, of, b, a.back()); });
}

NodeId make_without(ExprBuilder& builder, std::span<const NodeId> a) {
    return std::accumulate(a.begin() + 1, a.end(), a.front(), [&](NodeId solid, NodeId hole) {
        return make_call(builder, Op::Max, solid, make_negate(builder, hole));
    });
}

/// f_torus(x, y, z, R, r): a torus around the y-axis.
NodeId make_torus(ExprBuilder& builder, std::span<const NodeId> a) {
    const NodeId across = length_of(builder, std::array{a[0], a[2]});
    const NodeId tube = length_of(builder, std::array{make_subtract(builder, across, a[3]), a[1]});
    return make_subtract(builder, tube, a[4]);
}

/// f_superellipsoid(x, y, z, e, n)
NodeId make_superellipsoid(ExprBuilder& builder, std::span<const NodeId> a) {
    const NodeId two = builder.constant(2.0);
    const auto powered = [&](NodeId of, NodeId over) {
        const NodeId size = make_call(builder, Op::Abs, of);
        return make_power(builder, size, make_divide(builder, two, over));
    };
    const NodeId across =
        make_power(builder, make_add(builder, powered(a[0], a[3]), powered(a[1], a[3])),
                   make_divide(builder, a[3], a[4]));
    const NodeId size = make_power(builder, make_add(builder, across, powered(a[2], a[4])),
                                   make_divide(builder, a[4], two));
    return make_subtract(builder, builder.constant(1.0), size);
}

/// f_rounded_box(x, y, z, r, a, b, c): the distance from the box shrunk by r, minus r.
NodeId make_rounded_box(ExprBuilder& builder, std::span<const NodeId> a) {
    std::array<NodeId, 3> outside{};
    for (std::size_t i = 0; i < outside.size(); ++i) {
        const NodeId size = make_call(builder, Op::Abs, a[i]);
        const NodeId over = make_subtract(builder, size, make_subtract(builder, a[4 + i], a[3]));
        outside.at(i) = make_call(builder, Op::Max, over, builder.constant(0.0));
    }
    return make_subtract(builder, length_of(builder, outside), a[3]);
}

/// f_ellipsoid(x, y, z, a, b, c)
NodeId make_ellipsoid(ExprBuilder& builder, std::span<const NodeId> a) {
    std::array<NodeId, 3> scaled{};
    for (std::size_t i = 0; i < scaled.size(); ++i)
        scaled.at(i) = make_multiply(builder, a[3 + i], a[i]);
    return length_of(builder, scaled);
}

// NOLINTNEXTLINE(readability-function-size): a table
NodeId make_composed(ExprBuilder& builder, Composed function, std::span<const NodeId> a) {
    const NodeId one = builder.constant(1.0);
    const auto reciprocal = [&](NodeId of) { return make_divide(builder, one, of); };
    switch (function) {
        case Composed::Cbrt: return make_root(builder, a[0], 3);
        case Composed::Root: return make_power(builder, a[0], reciprocal(a[1]));
        case Composed::Pow: return make_power(builder, a[0], a[1]);
        case Composed::LogBase: return make_logarithm(builder, a);
        case Composed::Sec: return reciprocal(make_call(builder, Op::Cos, a[0]));
        case Composed::Csc: return reciprocal(make_call(builder, Op::Sin, a[0]));
        case Composed::Sech: return reciprocal(make_call(builder, Op::Cosh, a[0]));
        case Composed::Csch: return reciprocal(make_call(builder, Op::Sinh, a[0]));
        case Composed::Coth: return reciprocal(make_call(builder, Op::Tanh, a[0]));
        case Composed::Exp2: return make_power(builder, builder.constant(2.0), a[0]);
        case Composed::Trunc: return make_trunc(builder, a[0]);
        case Composed::Fract:
            return make_subtract(builder, a[0], make_call(builder, Op::Floor, a[0]));
        case Composed::Fmod: return make_fmod(builder, a[0], a[1]);
        case Composed::Step: return make_step(builder, a[0], a[1]);
        case Composed::SmoothStep: return make_smooth_step(builder, a[0], a[1], a[2]);
        case Composed::Mix: return make_mix(builder, a[0], a[1], a[2]);
        case Composed::Select: return make_select(builder, a);
        case Composed::Degrees:
            return make_angle(builder, a[0], builder.constant(180.0), pi_of(builder));
        case Composed::Radians:
            return make_angle(builder, a[0], pi_of(builder), builder.constant(180.0));
        case Composed::InverseSqrt: return reciprocal(make_call(builder, Op::Sqrt, a[0]));
        case Composed::Hypot:
        case Composed::Length: return length_of(builder, a);
        case Composed::Clamp: return make_clamp(builder, a[0], a[1], a[2]);
        case Composed::SmoothMin: return smooth_min(builder, a[0], a[1], a[2]);
        case Composed::SmoothMax: return smooth_max(builder, a[0], a[1], a[2]);
        case Composed::SmoothUnion: return blended(builder, a, smooth_min);
        case Composed::SmoothIntersect: return blended(builder, a, smooth_max);
        case Composed::SmoothSubtract: return blended(builder, a, smooth_without);
        case Composed::Sphere: return make_subtract(builder, length_of(builder, a.first(3)), a[3]);
        case Composed::Torus: return make_torus(builder, a);
        case Composed::Ellipsoid: return make_ellipsoid(builder, a);
        case Composed::Superellipsoid: return make_superellipsoid(builder, a);
        case Composed::RoundedBox: return make_rounded_box(builder, a);
        case Composed::Union: return fold(builder, Op::Min, a);
        case Composed::Intersect: return fold(builder, Op::Max, a);
        case Composed::Without: return make_without(builder, a);
        case Composed::Vector2:
        case Composed::Vector3:
        case Composed::Vector4:
        case Composed::Iterate:
        case Composed::Keep:
        case Composed::Kept:
        case Composed::Least:
        case Composed::Greatest:
        case Composed::Sum:
        case Composed::Product:
        case Composed::Noise:
        case Composed::ValueNoise:
        case Composed::Cellular:
        case Composed::Cellular2:
        case Composed::Fbm:
        case Composed::Turbulence:
        case Composed::Blobs:
        case Composed::Metaballs:
        case Composed::Blinn: break;
    }
    assert(false);  // the elaborator writes these functions out
    return a[0];
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

NodeId make_function(ExprBuilder& builder, const Function& function,
                     std::span<const NodeId> arguments) {
    assert(function.takes(arguments.size()));
    if (function.composed) return make_composed(builder, *function.composed, arguments);
    const Op op = *function.op;
    if (op == Op::Min || op == Op::Max) return fold(builder, op, arguments);
    const NodeId b = arguments.size() > 1 ? arguments[1] : 0;
    const NodeId c = arguments.size() > 2 ? arguments[2] : 0;
    return make_call(builder, op, arguments[0], b, c);
}

}  // namespace zeroset
