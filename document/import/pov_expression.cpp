#include "document/import/pov_script.hpp"
#include "document/import/real_functions.hpp"
#include "engine/base/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

// Values in scenes of POV-Ray: numbers, vectors and colours, as directives and objects have them.

namespace zeroset {
namespace {

constexpr int deepest_term = 100;

}  // namespace

std::optional<PovValue> PovScript::compared() {
    auto result = sum();
    constexpr std::array<std::string_view, 9> signs{"<",  ">",  "<=", ">=", "=",
                                                    "==", "!=", "&",  "|"};
    while (result && peek().kind == ScriptKind::Sign && is_one_of(signs, peek().text)) {
        const std::string_view sign = next().text;
        const bool joins = sign == "&" || sign == "|";
        // All behind & and | is one deeper: sum() ends it.
        depth_ += joins ? 1 : 0;
        const auto other = joins ? compared() : sum();
        depth_ -= joins ? 1 : 0;
        if (!other) return std::nullopt;
        const double a = (*result)[0];
        const double b = (*other)[0];
        result = PovValue{holds(a, sign, b).value_or(false) ? 1.0 : 0.0};
    }
    return result;
}

std::optional<PovValue> PovScript::value() { return sum(); }

std::optional<PovValue> PovScript::value_of(std::string_view name) const {
    const auto found = values_.find(name);
    if (found != values_.end()) return found->second;
    return pov_constant(name);
}

std::optional<PovValue> PovScript::sum() {
    if (depth_ >= deepest_term) return std::nullopt;
    ++depth_;
    auto result = product();
    while (result && (at_sign("+") || at_sign("-"))) {
        const char sign = next().text[0];
        const auto other = product();
        result = other ? std::optional(joined(*result, sign, *other)) : std::nullopt;
    }
    --depth_;
    return result;
}

std::optional<PovValue> PovScript::product() {
    auto result = factor();
    while (result && (at_sign("*") || at_sign("/"))) {
        const char sign = next().text[0];
        const auto other = factor();
        result = other ? std::optional(joined(*result, sign, *other)) : std::nullopt;
    }
    return result;
}

std::optional<PovValue> PovScript::factor() {
    bool negative = false;
    while (at_sign("-") || at_sign("+"))
        negative = (next().text == "-") != negative;
    auto result = operand();
    if (result) result = part_of(std::move(*result));
    if (result && negative) result = joined({-1.0}, '*', *result);
    return result;
}

std::optional<PovValue> PovScript::part_of(PovValue value) {
    static constexpr std::array<std::string_view, 8> parts{"x",   "y",     "z",    "t",
                                                           "red", "green", "blue", "filter"};
    while (at_sign(".")) {
        next();
        const auto* const part = std::ranges::find(parts, next().text);
        if (part == parts.end()) return std::nullopt;
        const auto index = static_cast<std::size_t>(part - parts.begin()) % 4;
        value = {index < value.size() ? value[index] : 0.0};
    }
    return value;
}

std::optional<PovValue> PovScript::operand() {
    const ScriptToken token = peek();
    if (token.kind == ScriptKind::Number) {
        next();
        const auto number = number_from<double>(token.text);
        if (!number) return std::nullopt;
        return PovValue{*number};
    }
    if (take_sign("(")) {
        auto inner = compared();
        if (!take_sign(")")) return std::nullopt;
        return inner;
    }
    if (take_sign("<")) return vector();
    if (token.kind == ScriptKind::Name) return named();
    return std::nullopt;
}

std::optional<PovValue> PovScript::vector() {
    PovValue result;
    do {
        const auto part = sum();
        if (!part || result.size() == 5) return std::nullopt;
        result.push_back((*part)[0]);
        take_sign(",");
    } while (!at_sign(">") && !tokens_.at_end());
    if (!take_sign(">")) return std::nullopt;
    return result;
}

std::optional<PovValue> PovScript::named() {
    if (at_array()) return value_of(element_name());
    const std::string name(next().text);
    if (name == "dimension_size" && at_sign("(")) return array_size();
    static constexpr std::array<std::string_view, 9> colors{
        "rgb", "rgbf", "rgbt", "rgbft", "srgb", "color", "colour", "srgbf", "srgbt"};
    if (is_one_of(colors, name)) {
        auto color = sum();
        if (!color) return std::nullopt;
        if (color->size() == 1 && name != "color" && name != "colour")
            color = PovValue(3, color->front());
        // rgbt: the fourth number is transmitted light, which stands fifth elsewhere.
        if ((name == "rgbt" || name == "srgbt") && color->size() == 4)
            color->insert(color->begin() + 3, 0.0);
        return color;
    }
    // The next token may be behind the end of a macro, whose names are gone by then.
    auto known = value_of(name);
    if (!at_sign("(")) return known;
    std::vector<PovValue> arguments;
    do {
        next();
        auto argument = sum();
        if (!argument) return std::nullopt;
        arguments.push_back(std::move(*argument));
    } while (at_sign(","));
    if (!take_sign(")")) return std::nullopt;
    if (arguments.size() == 1 && (name == "seed" || name == "rand"))
        return random(name, arguments[0]);
    return pov_function(name, arguments);
}

// Streams of random numbers are those of POV-Ray: x -> 1812433253 x + 12345 modulo 2^32.
std::optional<PovValue> PovScript::random(std::string_view name, const PovValue& argument) {
    if (argument.empty() || !(std::abs(argument[0]) <= 9e15)) return std::nullopt;
    if (name == "seed") {
        streams_.push_back(static_cast<std::uint32_t>(static_cast<std::int64_t>(argument[0])));
        return PovValue{static_cast<double>(streams_.size() - 1)};
    }
    const auto stream = static_cast<std::size_t>(std::max(argument[0], 0.0));
    if (stream >= streams_.size()) return std::nullopt;
    streams_[stream] = streams_[stream] * 1812433253U + 12345U;
    return PovValue{streams_[stream] / 4294967295.0};
}

}  // namespace zeroset
