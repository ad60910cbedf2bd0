#include "engine/language/dialects/command_arguments.hpp"

#include "engine/base/text.hpp"

#include <algorithm>
#include <string>

namespace zeroset {
namespace {

using Words = std::string_view;

/// An option `name -> value` or `name = value`.
struct Option {
    Words name, value;
};

std::optional<Option> option_of(Words argument) {
    const std::size_t length = word_length(argument);
    const Words behind = trimmed(argument.substr(length));
    if (length == 0 || behind.starts_with("==")) return std::nullopt;
    for (const Words sign : {"->", ":>", "="}) {
        if (behind.starts_with(sign))
            return Option{.name = argument.substr(0, length),
                          .value = trimmed(behind.substr(sign.size()))};
    }
    return std::nullopt;
}

/// Takes an option; false: it changes what is drawn in a way that is not read.
bool take(const Option& option, CommandArguments& arguments) {
    const std::string name = lower_case(option.name);
    if (name == "contours" || name == "contour") {
        const auto list = in_brackets(option.value);
        // A whole number alone is how many levels there are in Mathematica, not which.
        const bool is_count = !list && name == "contours" &&
                              option.value.find_first_not_of("0123456789") == Words::npos;
        if (is_count)
            arguments.left_out.push_back(option.name);
        else
            arguments.levels = list ? split_outside(*list, ',') : std::vector{option.value};
        return true;
    }
    if (name == "regionfunction" || name == "region") {
        arguments.condition = unnamed_function(option.value);
        return arguments.condition && std::ranges::equal(arguments.condition->names, axis_names);
    }
    if (name == "coords") {
        arguments.coordinates = option.value;
        return true;
    }
    arguments.left_out.push_back(option.name);
    return name != "scalingfunctions";
}

}  // namespace

std::optional<CommandArguments> ranges_and_options(std::span<const std::string_view> arguments) {
    CommandArguments result;
    for (const Words argument : arguments) {
        if (const auto range = named_range(argument)) {
            result.ranges.push_back(*range);
            continue;
        }
        const std::size_t dots = find_outside(argument, "..");
        if (dots != Words::npos && !argument.contains('=') &&
            result.ranges.size() < axis_names.size()) {
            result.ranges.push_back({.name = axis_names.at(result.ranges.size()),
                                     .lo = trimmed(argument.substr(0, dots)),
                                     .hi = trimmed(argument.substr(dots + 2))});
            continue;
        }
        const auto option = option_of(argument);
        if (!option || !take(*option, result)) return std::nullopt;
    }
    return result;
}

std::optional<CommandArguments> flat_ranges(std::span<const std::string_view> arguments) {
    if (arguments.empty() || arguments.size() % 3 != 0) return std::nullopt;
    CommandArguments result;
    for (std::size_t i = 0; i < arguments.size(); i += 3) {
        if (!is_name(arguments[i])) return std::nullopt;
        result.ranges.push_back(
            {.name = arguments[i], .lo = arguments[i + 1], .hi = arguments[i + 2]});
    }
    return result;
}

std::optional<CommandArguments> interval_ranges(std::span<const std::string_view> arguments,
                                                std::span<const std::string_view> names) {
    std::vector<Words> ends{"-5", "5"};
    if (!arguments.empty() && !Words("'\"").contains(arguments[0].front())) {
        const auto inside = in_brackets(arguments[0]);
        if (!inside) return std::nullopt;
        ends = split_outside(*inside, inside->contains(',') ? ',' : ' ');
    }
    if (ends.size() != 2 && ends.size() != 2 * names.size()) return std::nullopt;
    CommandArguments result;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::size_t at = ends.size() == 2 ? 0 : 2 * i;
        result.ranges.push_back({.name = names[i], .lo = ends[at], .hi = ends[at + 1]});
    }
    return result;
}

std::vector<std::string_view> arguments_in(std::string_view inside) {
    std::vector<Words> parts;
    for (Words part : split_outside(inside, ',')) {
        constexpr Words continued = "....:";  // of Sage's lines
        if (part.starts_with(continued)) part = trimmed(part.substr(continued.size()));
        const Words last = parts.empty() ? Words() : parts.back();
        const std::size_t lambda = last.find("lambda ");
        if (lambda != Words::npos && !last.substr(lambda).contains(':'))
            parts.back() = Words(last.data(),
                                 static_cast<std::size_t>(part.data() + part.size() - last.data()));
        else
            parts.push_back(part);
    }
    return parts;
}

}  // namespace zeroset
