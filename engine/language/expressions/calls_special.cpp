// Builds special functions: fields of a number, and formulas of these.

#include "engine/base/translation.hpp"
#include "engine/expr/constants.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/expressions/calls.hpp"
#include "engine/special/special.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <span>
#include <string>

namespace zeroset {
namespace {

NodeId field_at(ExprBuilder& builder, SpecialFunction function, NodeId a, int order = 0) {
    const NodeId zero = builder.constant(0.0);
    return builder.look_up(special_field(function, order), a, zero, zero);
}

/// gamma(a) is the quotient by its reciprocal, whose zeros are its poles.
NodeId reciprocal_gamma(ExprBuilder& builder, NodeId a) {
    return field_at(builder, SpecialFunction::ReciprocalGamma, a);
}
NodeId gamma(ExprBuilder& builder, NodeId a) {
    return make_divide(builder, builder.constant(1.0), reciprocal_gamma(builder, a));
}

NodeId factorial(ExprBuilder& builder, NodeId a) {
    return gamma(builder, make_add(builder, a, builder.constant(1.0)));
}

NodeId beta(ExprBuilder& builder, NodeId a, NodeId b) {
    return make_divide(
        builder, reciprocal_gamma(builder, make_add(builder, a, b)),
        make_multiply(builder, reciprocal_gamma(builder, a), reciprocal_gamma(builder, b)));
}

/// `right` for a > 0, else `left`.
NodeId by_sign(ExprBuilder& builder, NodeId a, NodeId right, NodeId left) {
    const NodeId above = make_call(builder, Op::Less, builder.constant(0.0), a);
    return make_call(builder, Op::If, above, right, left);
}

/// ln|gamma(a)|, left of 0 that of its reciprocal.
NodeId log_gamma(ExprBuilder& builder, NodeId a) {
    const NodeId size = make_call(builder, Op::Abs, reciprocal_gamma(builder, a));
    return by_sign(builder, a, field_at(builder, SpecialFunction::LogGamma, a),
                   make_negate(builder, make_call(builder, Op::Log, size)));
}

/// digamma(a), left of 0 digamma(1 - a) - pi cot(pi a).
NodeId digamma(ExprBuilder& builder, NodeId a) {
    const NodeId turn = make_constant(builder, pi);
    const NodeId mirrored = make_subtract(builder, builder.constant(1.0), a);
    const NodeId cotangent = make_call(builder, Op::Cot, make_multiply(builder, turn, a));
    return by_sign(builder, a, field_at(builder, SpecialFunction::Digamma, a),
                   make_subtract(builder, field_at(builder, SpecialFunction::Digamma, mirrored),
                                 make_multiply(builder, turn, cotangent)));
}

NodeId zeta(ExprBuilder& builder, NodeId a) {
    return make_divide(builder, field_at(builder, SpecialFunction::ZetaTimes, a),
                       make_subtract(builder, a, builder.constant(1.0)));
}

NodeId lambert(ExprBuilder& builder, NodeId a) {
    const NodeId scaled = make_multiply(builder, make_constant(builder, euler), a);
    const NodeId root =
        make_call(builder, Op::Sqrt, make_add(builder, scaled, builder.constant(1.0)));
    return field_at(builder, SpecialFunction::LambertOfRoot, root);
}

/// A Bessel function that a call names, with its order where the name tells it.
struct BesselName {
    Composed name;
    SpecialFunction function;
    std::optional<int> order = {};
};
constexpr std::array bessel_names{
    BesselName{.name = Composed::BesselJ, .function = SpecialFunction::BesselJ},
    BesselName{.name = Composed::BesselY, .function = SpecialFunction::BesselY},
    BesselName{.name = Composed::BesselI, .function = SpecialFunction::BesselI},
    BesselName{.name = Composed::BesselK, .function = SpecialFunction::BesselK},
    BesselName{.name = Composed::J0, .function = SpecialFunction::BesselJ, .order = 0},
    BesselName{.name = Composed::J1, .function = SpecialFunction::BesselJ, .order = 1},
    BesselName{.name = Composed::Y0, .function = SpecialFunction::BesselY, .order = 0},
    BesselName{.name = Composed::Y1, .function = SpecialFunction::BesselY, .order = 1},
    BesselName{.name = Composed::I0, .function = SpecialFunction::BesselI, .order = 0},
    BesselName{.name = Composed::I1, .function = SpecialFunction::BesselI, .order = 1},
    BesselName{.name = Composed::K0, .function = SpecialFunction::BesselK, .order = 0},
    BesselName{.name = Composed::K1, .function = SpecialFunction::BesselK, .order = 1}};

/// J and Y of a negative order n are those of -n, for odd n with the other sign; I and K are even.
NodeId bessel(ExprBuilder& builder, SpecialFunction function, int order, NodeId a) {
    const NodeId value = field_at(builder, function, a, std::abs(order));
    const bool turns = function == SpecialFunction::BesselJ || function == SpecialFunction::BesselY;
    return order < 0 && order % 2 != 0 && turns ? make_negate(builder, value) : value;
}

std::optional<int> order_of(const CallSite& site, const BuiltValue& value) {
    const auto exact = value.is_single() ? exact_value(site.builder(), value.id) : std::nullopt;
    if (exact && *exact == std::floor(*exact) && std::abs(*exact) <= highest_bessel_order)
        return static_cast<int>(*exact);
    const std::string most = std::to_string(highest_bessel_order);
    return refuse_argument(site, 0,
                           filled(tr("the order of {0} is a whole number from {1} to {2}"),
                                  {site.word(), "-" + most, most}),
                           tr("type one, such as 7"));
}

using Arguments = std::span<const NodeId>;

template <SpecialFunction function>
NodeId plain(ExprBuilder& builder, Arguments a) {
    return field_at(builder, function, a[0]);
}
template <NodeId (*of)(ExprBuilder&, NodeId)>
NodeId of_one(ExprBuilder& builder, Arguments a) {
    return of(builder, a[0]);
}

/// How a call that is not one of Bessel's is written out.
struct WrittenOut {
    Composed name;
    NodeId (*make)(ExprBuilder&, Arguments);
};
constexpr std::array written_out{
    WrittenOut{.name = Composed::Erf, .make = plain<SpecialFunction::Erf>},
    WrittenOut{.name = Composed::Erfc, .make = plain<SpecialFunction::Erfc>},
    WrittenOut{.name = Composed::Gamma, .make = of_one<gamma>},
    WrittenOut{.name = Composed::ReciprocalGamma, .make = of_one<reciprocal_gamma>},
    WrittenOut{.name = Composed::Factorial, .make = of_one<factorial>},
    WrittenOut{.name = Composed::LogGamma, .make = of_one<log_gamma>},
    WrittenOut{.name = Composed::LogGammaRight, .make = plain<SpecialFunction::LogGamma>},
    WrittenOut{.name = Composed::Digamma, .make = of_one<digamma>},
    WrittenOut{.name = Composed::DigammaRight, .make = plain<SpecialFunction::Digamma>},
    WrittenOut{.name = Composed::ZetaTimes, .make = plain<SpecialFunction::ZetaTimes>},
    WrittenOut{.name = Composed::LambertRoot, .make = plain<SpecialFunction::LambertOfRoot>},
    WrittenOut{.name = Composed::Beta,
               .make = [](ExprBuilder& builder, Arguments a) { return beta(builder, a[0], a[1]); }},
    WrittenOut{.name = Composed::Zeta, .make = of_one<zeta>},
    WrittenOut{.name = Composed::LambertW, .make = of_one<lambert>}};

}  // namespace

GraphValues::Built read_special(const CallSite& site) {
    const auto arguments = site.reader.operands(site.call.operands, site.context);
    if (!arguments) return std::nullopt;
    std::span<const BuiltValue> values = *arguments;
    ExprBuilder& builder = site.builder();
    const auto* const name = std::ranges::find(bessel_names, site.composed(), &BesselName::name);
    if (name == bessel_names.end()) {
        const auto* const how = std::ranges::find(written_out, site.composed(), &WrittenOut::name);
        return site.values().mapped(values, site.offset(),
                                    [&](Arguments a) { return how->make(builder, a); });
    }
    std::optional<int> order = name->order;
    if (!order) {
        order = order_of(site, values.front());
        values = values.subspan(1);
    }
    if (!order) return std::nullopt;
    return site.values().mapped(values, site.offset(), [&](Arguments a) {
        return bessel(builder, name->function, *order, a.front());
    });
}

}  // namespace zeroset
