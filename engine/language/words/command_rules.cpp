#include "engine/language/words/command_rules.hpp"

#include "engine/base/text.hpp"
#include "engine/language/words/command_parts.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

using Names = std::span<const std::string_view>;
using Result = std::optional<Rewritten>;

/// The ranges among arguments; nullopt where another one says more than how the surface looks.
std::optional<std::vector<CommandRange>> ranges_in(Names arguments) {
    constexpr std::array<std::string_view, 6> telling{
        "contour", "contours", "region", "regionfunction", "coords", "scalingfunctions"};
    std::vector<CommandRange> ranges;
    for (const std::string_view argument : arguments) {
        if (const auto range = range_of(argument)) {
            ranges.push_back(*range);
            continue;
        }
        const std::string name = lower_case(argument.substr(0, word_length(argument)));
        const std::string_view behind = trimmed(argument.substr(name.size()));
        const bool is_option =
            !name.empty() && (behind.starts_with("->") || behind.starts_with('='));
        if (!is_option || std::ranges::find(telling, name) != telling.end()) return std::nullopt;
    }
    return ranges;
}

/// Whether ranges are of these variables, in any order.
bool are_of(std::span<const CommandRange> ranges, Names names) {
    return ranges.size() == names.size() && std::ranges::all_of(names, [&](std::string_view name) {
               return std::ranges::find(ranges, name, &CommandRange::name) != ranges.end();
           });
}

std::string listed(std::span<const CommandRange> ranges) {
    std::string text;
    for (const CommandRange& range : ranges)
        text += "," + range.text();
    return text;
}

constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

Result equation_of(Names arguments) {
    const auto ranges = ranges_in(arguments.subspan(1));
    if (!ranges || !are_of(*ranges, axes) || in_brackets(arguments[0])) return std::nullopt;
    return Rewritten{.before = "", .main = arguments[0], .behind = listed(*ranges)};
}

/// A point, in brackets or as a name, over ranges.
Result point_of(std::string_view point, std::span<const CommandRange> ranges) {
    if (ranges.empty() || ranges.size() > 2) return std::nullopt;
    const auto inside = in_brackets(point);
    if (!inside) return Rewritten{.before = "", .main = point, .behind = listed(ranges)};
    const auto parts = split_outside(*inside, ',');
    if (parts.size() != 3 || in_brackets(parts[0])) return std::nullopt;
    return Rewritten{.before = "(", .main = *inside, .behind = ")" + listed(ranges)};
}

/// The graph of a height over the ranges of x and y, or of two other names.
Result graph_over(std::string_view height, std::span<const CommandRange> ranges) {
    if (ranges.size() != 2) return std::nullopt;
    if (are_of(ranges, std::span(axes).first(2)))
        return Rewritten{.before = "z=", .main = height, .behind = listed(ranges)};
    std::string before = "(";
    for (const CommandRange& range : ranges)
        before.append(range.name).append(",");
    return Rewritten{.before = std::move(before), .main = height, .behind = ")" + listed(ranges)};
}

Result graph_of(Names arguments) {
    const auto ranges = ranges_in(arguments.subspan(1));
    if (!ranges) return std::nullopt;
    if (!in_brackets(arguments[0])) return graph_over(arguments[0], *ranges);
    const bool is_point = split_outside(*in_brackets(arguments[0]), ',').size() == 3;
    const bool is_sum = split_outside(*in_brackets(arguments[0]), ',').size() == 1;
    if (is_sum) return graph_over(arguments[0], *ranges);
    return is_point ? point_of(arguments[0], *ranges) : std::nullopt;
}

/// The ranges that an interval of MATLAB gives variables; `otherwise`: those without one. Behind
/// the interval stand only words that tell how the surface looks.
std::optional<std::vector<CommandRange>> ranges_of_interval(Names arguments, Names names) {
    std::vector<std::string_view> ends{"-5", "5"};
    if (!arguments.empty() && !std::string_view("'\"").contains(arguments[0].front())) {
        const auto inside = in_brackets(arguments[0]);
        if (!inside) return std::nullopt;
        ends = split_outside(*inside, inside->contains(',') ? ',' : ' ');
    }
    if (ends.size() != 2 && ends.size() != 2 * names.size()) return std::nullopt;
    std::vector<CommandRange> ranges;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::size_t at = ends.size() == 2 ? 0 : 2 * i;
        ranges.push_back({.name = names[i], .lo = ends[at], .hi = ends[at + 1]});
    }
    return ranges;
}

/// Whether the text gives a name to a function: f = @(x, y, z) or f(x, y, z) = ...
bool is_function_in(std::string_view text, std::string_view name) {
    for (std::size_t at = text.find(name); at != std::string_view::npos;
         at = text.find(name, at + 1)) {
        const bool goes_on = at > 0 && word_length(text.substr(at - 1)) > name.size();
        const std::string_view behind = trimmed(text.substr(at + name.size()));
        const bool is_handle =
            behind.starts_with('=') && trimmed(behind.substr(1)).starts_with('@');
        if (!goes_on && (is_handle || behind.starts_with('('))) return true;
    }
    return false;
}

Result zeros_of(Names arguments, std::string_view text) {
    const auto ranges = ranges_of_interval(arguments.subspan(1), axes);
    if (!ranges) return std::nullopt;
    const auto handle = handle_of(arguments[0]);
    if (handle && !std::ranges::equal(handle->names, axes)) return std::nullopt;
    Rewritten result{.before = "", .main = handle ? handle->body : arguments[0], .behind = ""};
    if (is_word(result.main) && is_function_in(text, result.main)) result.behind = "(x,y,z)";
    const bool has_interval = arguments.size() > 1 && in_brackets(arguments[1]).has_value();
    if (has_interval) result.behind += listed(*ranges);
    return result;
}

/// A point of three functions without a name over their variables.
Result point_of_handles(Names arguments, std::size_t variables) {
    std::vector<CommandHandle> handles;
    for (std::size_t i = 0; i < 3 && i < arguments.size(); ++i) {
        const auto handle = handle_of(arguments[i]);
        if (handle) handles.push_back(*handle);
    }
    if (handles.size() != 3 || handles[0].names.size() != variables) return std::nullopt;
    if (handles[0].names != handles[1].names || handles[0].names != handles[2].names)
        return std::nullopt;
    const auto ranges = ranges_of_interval(arguments.subspan(3), handles[0].names);
    if (!ranges) return std::nullopt;
    std::string behind;
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}})
        behind.append(",").append(handles[i].body);
    return Rewritten{
        .before = "(", .main = handles[0].body, .behind = behind + ")" + listed(*ranges)};
}

Result sheet_of(Names arguments) {
    if (auto point = point_of_handles(arguments, 2)) return point;
    const auto handle = handle_of(arguments[0]);
    const Names names = handle ? Names(handle->names) : std::span(axes).first(2);
    const auto ranges = ranges_of_interval(arguments.subspan(1), names);
    if (!ranges || names.size() != 2 || is_word(arguments[0])) return std::nullopt;
    return graph_over(handle ? handle->body : arguments[0], *ranges);
}

Result listed_point_of(Names arguments) {
    if (arguments.size() != 6 && arguments.size() != 9) return std::nullopt;
    std::vector<CommandRange> ranges;
    for (std::size_t i = 3; i < arguments.size(); i += 3) {
        if (!is_word(arguments[i])) return std::nullopt;
        ranges.push_back({.name = arguments[i], .lo = arguments[i + 1], .hi = arguments[i + 2]});
    }
    const char* const end = arguments[2].data() + arguments[2].size();
    return Rewritten{
        .before = "(", .main = {arguments[0].data(), end}, .behind = ")" + listed(ranges)};
}

}  // namespace

Result rewritten(CommandKind kind, std::span<const std::string_view> arguments,
                 std::string_view text) {
    const bool has_gap = std::ranges::any_of(arguments, &std::string_view::empty);
    if (has_gap) return std::nullopt;
    switch (kind) {
        case CommandKind::Equation: return equation_of(arguments);
        case CommandKind::Graph: return graph_of(arguments);
        case CommandKind::Point: {
            const auto ranges = ranges_in(arguments.subspan(1));
            return ranges ? point_of(arguments[0], *ranges) : std::nullopt;
        }
        case CommandKind::Zeros: return zeros_of(arguments, text);
        case CommandKind::Sheet: return sheet_of(arguments);
        case CommandKind::Track: return point_of_handles(arguments, 1);
        case CommandKind::Listed: return listed_point_of(arguments);
    }
    return std::nullopt;
}

}  // namespace zeroset
