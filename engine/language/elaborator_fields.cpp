// Builds noise: fields at a point, and sums of them.

#include "engine/base/translation.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/elaborator.hpp"
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

}  // namespace

/// Takes the point off the front of arguments: a vector of 2 or 3 numbers, or up to three numbers.
/// Coordinates that are left out are 0.
std::optional<std::array<NodeId, 3>> Elaborator::leading_point(const Syntax& syntax,
                                                               Values& arguments) {
    const Value& first = arguments.front();
    const bool is_point = first.is_vector() && first.size() <= 3;
    if (!first.is_single() && !is_point) {
        const std::string name(syntax.function->name);
        return fail(tree_[syntax.operands[0]].offset,
                    filled(tr("{0} is of a point, not of {1}"), {name, first.described()}),
                    filled(tr("type {0} or {1}"), {name + "(x, y, z)", name + "(p)"}));
    }
    const NodeId zero = builder_.constant(0.0);
    std::array<NodeId, 3> point{zero, zero, zero};
    std::size_t taken = 1;
    if (is_point) {
        for (std::size_t i = 0; i < first.size(); ++i)
            point[i] = first.part(i).id;
    } else {
        taken = std::min<std::size_t>(3, arguments.size());
        for (std::size_t i = 0; i < taken; ++i) {
            const Number number = number_of(arguments[i], tree_[syntax.operands[i]].offset);
            if (!number) return std::nullopt;
            point[i] = *number;
        }
    }
    arguments.erase(arguments.begin(), arguments.begin() + static_cast<std::ptrdiff_t>(taken));
    return point;
}

std::optional<double> Elaborator::whole_argument(const Syntax& syntax, const Values& rest,
                                                 const WholeArgument& argument) {
    if (argument.place >= rest.size()) return argument.otherwise;
    const Value& value = rest[argument.place];
    const auto exact = value.is_single() ? exact_value(builder_, value.id) : std::nullopt;
    const bool is_whole = exact && *exact == std::floor(*exact);
    if (is_whole && *exact >= argument.least && *exact <= argument.most) return exact;
    const std::size_t before = syntax.operands.size() - rest.size();
    return fail(tree_[syntax.operands[before + argument.place]].offset, argument.rule,
                tr("type one, such as 7"));
}

/// Builds noise(p, seed) and its like.
Elaborator::Built Elaborator::noise(const Syntax& syntax, const Binding* scope) {
    const Composed function = *syntax.function->composed;
    if (function == Composed::Blobs || function == Composed::Metaballs ||
        function == Composed::Blinn)
        return blobs(syntax, scope);
    auto arguments = operands(syntax.operands, scope);
    if (!arguments) return std::nullopt;
    const auto point = leading_point(syntax, *arguments);
    if (!point) return std::nullopt;
    if (library_offset_)
        notes_.add(*library_offset_,
                   tr("the noise is Zeroset's own: its bumps lie elsewhere than in the "
                      "program that the formula is from"));
    const bool has_octaves = function == Composed::Fbm || function == Composed::Turbulence;
    const std::size_t most = has_octaves ? 4 : 1;
    if (arguments->size() > most) {
        const std::string name(syntax.function->name);
        const std::string reason =
            has_octaves ? filled(tr("{0} takes at most {1} numbers behind its point"),
                                 {name, std::to_string(most)})
                        : filled(tr("{0} takes only a seed behind its point"), {name});
        return fail(
            tree_[syntax.operands.back()].offset, reason,
            filled(tr("type {0}"), {name + "(" + std::string(syntax.function->arguments) + ")"}));
    }
    const auto seed =
        whole_argument(syntax, *arguments,
                       {.place = most - 1,
                        .otherwise = 0,
                        .least = 0,
                        .most = largest_seed,
                        .rule = filled(tr("the seed of {0} is a whole number from 0 to {1}"),
                                       {std::string(syntax.function->name), "4294967295"})});
    if (!seed) return std::nullopt;
    const auto first_seed = static_cast<std::uint32_t>(*seed);
    if (has_octaves) return octaves(syntax, *point, *arguments, first_seed);
    const auto field = noise_field(noise_word(function), first_seed);
    return done(builder_.look_up(field, (*point)[0], (*point)[1], (*point)[2]), syntax.offset);
}

/// Writes out fbm(p, octaves, gain, lacunarity, seed), or turbulence.
Elaborator::Built Elaborator::octaves(const Syntax& syntax, std::array<NodeId, 3> point,
                                      const Values& rest, std::uint32_t seed) {
    const auto count = whole_argument(
        syntax, rest,
        {.place = 0,
         .otherwise = usual_octaves,
         .least = 1,
         .most = most_octaves,
         .rule = filled(tr("the number of octaves of {0} is a whole number from 1 to {1}"),
                        {std::string(syntax.function->name), "16"})});
    if (!count) return std::nullopt;
    const auto factor = [&](std::size_t place, double otherwise) -> Number {
        if (place >= rest.size()) return builder_.constant(otherwise);
        const std::size_t before = syntax.operands.size() - rest.size();
        return number_of(rest[place], tree_[syntax.operands[before + place]].offset);
    };
    const Number gain = factor(1, 0.5);
    const Number lacunarity = gain ? factor(2, 2) : std::nullopt;
    if (!lacunarity) return std::nullopt;
    NodeId height = builder_.constant(1.0);
    NodeId sum = builder_.constant(0.0);
    for (double octave = 0; octave < *count; ++octave, ++seed) {
        NodeId term =
            builder_.look_up(noise_field(NoiseWord::Noise, seed), point[0], point[1], point[2]);
        if (syntax.function->composed == Composed::Turbulence)
            term = make_call(builder_, Op::Abs, term);
        term = octave == 0 ? term : make_multiply(builder_, height, term);
        sum = octave == 0 ? term : make_add(builder_, sum, term);
        height = make_multiply(builder_, height, *gain);
        for (NodeId& coordinate : point)
            coordinate = make_multiply(builder_, *lacunarity, coordinate);
        if (!done(sum, syntax.offset)) return std::nullopt;
    }
    return done(sum, syntax.offset);
}

}  // namespace zeroset
