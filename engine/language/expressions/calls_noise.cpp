// Builds noise: fields at a point, and sums of them.

#include "engine/base/translation.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/expressions/calls.hpp"
#include "engine/noise/noise.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

namespace zeroset {
namespace {

constexpr double largest_seed = 0xFFFFFFFFU;
constexpr double most_octaves = 16;
constexpr double usual_octaves = 5;

NoiseWord noise_word(Composed function) {
    if (function == Composed::ValueNoise) return NoiseWord::ValueNoise;
    if (function == Composed::Cellular) return NoiseWord::Cellular;
    if (function == Composed::Cellular2) return NoiseWord::Cellular2;
    return NoiseWord::Noise;
}

/// An argument behind the point, which is a whole number.
struct WholeArgument {
    std::size_t place;
    double otherwise;  ///< where it is left out
    double least, most;
    std::string rule;  ///< the reason of the error
};

std::optional<double> whole_argument(const CallSite& site, const BuiltValues& rest,
                                     const WholeArgument& argument) {
    if (argument.place >= rest.size()) return argument.otherwise;
    const BuiltValue& value = rest[argument.place];
    const auto exact = value.is_single() ? exact_value(site.builder(), value.id) : std::nullopt;
    const bool is_whole = exact && *exact == std::floor(*exact);
    if (is_whole && *exact >= argument.least && *exact <= argument.most) return exact;
    const std::size_t before = site.call.operands.size() - rest.size();
    return refuse_argument(site, before + argument.place, argument.rule, tr("type one, such as 7"));
}

/// Writes out fbm(p, octaves, gain, lacunarity, seed), or turbulence.
GraphValues::Built octaves(const CallSite& site, std::array<NodeId, 3> point,
                           const BuiltValues& rest, std::uint32_t seed) {
    ExprBuilder& builder = site.builder();
    const auto count = whole_argument(
        site, rest,
        {.place = 0,
         .otherwise = usual_octaves,
         .least = 1,
         .most = most_octaves,
         .rule = filled(tr("the number of octaves of {0} is a whole number from 1 to {1}"),
                        {site.word(), "16"})});
    if (!count) return std::nullopt;
    const auto factor = [&](std::size_t place, double otherwise) -> GraphValues::Number {
        if (place >= rest.size()) return builder.constant(otherwise);
        const std::size_t before = site.call.operands.size() - rest.size();
        return site.values().number_of(rest[place], site.offset_of(before + place));
    };
    const GraphValues::Number gain = factor(1, 0.5);
    const GraphValues::Number lacunarity = gain ? factor(2, 2) : std::nullopt;
    if (!lacunarity) return std::nullopt;
    NodeId height = builder.constant(1.0);
    NodeId sum = builder.constant(0.0);
    for (double octave = 0; octave < *count; ++octave, ++seed) {
        NodeId term =
            builder.look_up(noise_field(NoiseWord::Noise, seed), point[0], point[1], point[2]);
        if (site.composed() == Composed::Turbulence) term = make_call(builder, Op::Abs, term);
        term = octave == 0 ? term : make_multiply(builder, height, term);
        sum = octave == 0 ? term : make_add(builder, sum, term);
        height = make_multiply(builder, height, *gain);
        for (NodeId& coordinate : point)
            coordinate = make_multiply(builder, *lacunarity, coordinate);
        if (!site.values().done(sum, site.offset())) return std::nullopt;
    }
    return site.values().done(sum, site.offset());
}

}  // namespace

std::optional<std::array<NodeId, 3>> leading_point(const CallSite& site, BuiltValues& arguments) {
    const BuiltValue& first = arguments.front();
    const bool is_point = first.is_vector() && first.size() <= 3;
    if (!first.is_single() && !is_point) {
        const std::string name = site.word();
        return refuse_argument(
            site, 0, filled(tr("{0} is of a point, not of {1}"), {name, first.described()}),
            filled(tr("type {0} or {1}"), {name + "(x, y, z)", name + "(p)"}));
    }
    const NodeId zero = site.builder().constant(0.0);
    std::array<NodeId, 3> point{zero, zero, zero};
    std::size_t taken = 1;
    if (is_point) {
        for (std::size_t i = 0; i < first.size(); ++i)
            point[i] = first.part(i).id;
    } else {
        taken = std::min<std::size_t>(3, arguments.size());
        for (std::size_t i = 0; i < taken; ++i) {
            const GraphValues::Number number =
                site.values().number_of(arguments[i], site.offset_of(i));
            if (!number) return std::nullopt;
            point[i] = *number;
        }
    }
    arguments.erase(arguments.begin(), arguments.begin() + static_cast<std::ptrdiff_t>(taken));
    return point;
}

GraphValues::Built read_noise(const CallSite& site) {
    const Composed function = site.composed();
    auto arguments = site.reader.operands(site.call.operands, site.context);
    if (!arguments) return std::nullopt;
    const auto point = leading_point(site, *arguments);
    if (!point) return std::nullopt;
    if (site.context.library_offset)
        site.values().note(site.offset(),
                           tr("the noise is Zeroset's own: its bumps lie elsewhere than in the "
                              "program that the formula is from"));
    const bool has_octaves = function == Composed::Fbm || function == Composed::Turbulence;
    const std::size_t most = has_octaves ? 4 : 1;
    if (arguments->size() > most) {
        const std::string name = site.word();
        const std::string reason =
            has_octaves ? filled(tr("{0} takes at most {1} numbers behind its point"),
                                 {name, std::to_string(most)})
                        : filled(tr("{0} takes only a seed behind its point"), {name});
        return refuse_argument(site, site.call.operands.size() - 1, reason,
                               filled(tr("type {0}"), {call_of(*site.call.function)}));
    }
    const auto seed =
        whole_argument(site, *arguments,
                       {.place = most - 1,
                        .otherwise = 0,
                        .least = 0,
                        .most = largest_seed,
                        .rule = filled(tr("the seed of {0} is a whole number from 0 to {1}"),
                                       {site.word(), "4294967295"})});
    if (!seed) return std::nullopt;
    const auto first_seed = static_cast<std::uint32_t>(*seed);
    if (has_octaves) return octaves(site, *point, *arguments, first_seed);
    const auto field = noise_field(noise_word(function), first_seed);
    return site.values().done(site.builder().look_up(field, (*point)[0], (*point)[1], (*point)[2]),
                              site.offset());
}

}  // namespace zeroset
