#include "app/cli/options/drawing_options.hpp"

#include "app/cli/options/option_reader.hpp"
#include "app/cli/options/options.hpp"
#include "document/colors.hpp"
#include "engine/base/text.hpp"
#include "engine/expr/spelling.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// A number of an option that must be in a range.
OrInputError<double> read_between(const std::string& option, const std::string& text, double lowest,
                                  double highest) {
    const auto number = read_number(option, text);
    if (number && !(*number >= lowest && *number <= highest)) {
        return wrong_input(option + " " + text + ": type a number of points from " +
                           short_number(lowest) + " to " + short_number(highest));
    }
    return number;
}

/// The kind of line that is named, in the plural, too.
std::optional<CurveKind> read_kind(std::string_view name) {
    const auto kind = curve_kind_named(name);
    if (kind || !name.ends_with('s')) return kind;
    return curve_kind_named(name.substr(0, name.size() - 1));
}

/// Reads "1; contour 0.3": the width of silhouettes, then those of kinds of lines.
std::optional<InputError> read_widths(const std::string& text, DrawingStyle& style) {
    const std::vector<std::string_view> parts = split(text, ';');
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::string_view part = trimmed(parts[i]);
        const std::size_t space = part.find_first_of(" =");
        const bool is_named = i > 0 || space != std::string_view::npos;
        const auto kind = is_named ? read_kind(part.substr(0, space)) : std::nullopt;
        if (is_named && (!kind || space == std::string_view::npos)) {
            return InputError{.reason = "--width " + text +
                                        ": type a number of points, for example 1, or with widths "
                                        "of kinds of lines: \"1; contour 0.3; crease 0.5\""};
        }
        const std::string_view number = kind ? trimmed(part.substr(space + 1)) : part;
        const auto width = read_between("--width", std::string(number), 0.01, 100.0);
        if (!width) return width.error();
        if (kind) {
            style.widths_pt.at(static_cast<std::size_t>(*kind)) = *width;
        } else {
            style.width_pt = *width;
        }
    }
    return std::nullopt;
}

OrInputError<std::array<bool, 5>> read_kinds(const std::string& text) {
    std::array<bool, 5> kinds{};
    for (const std::string_view part : split(text, ',')) {
        const std::string_view name = trimmed(part);
        if (name == "all") {
            kinds.fill(true);
            continue;
        }
        const auto kind = read_kind(name);
        if (!kind) {
            return wrong_input("--lines " + text + ": there are no such lines as " +
                               quoted(name, name.size()) +
                               "; type all, or some of silhouette,crease,boundary,intersection,"
                               "contour");
        }
        kinds.at(static_cast<std::size_t>(*kind)) = true;
    }
    return kinds;
}

OrInputError<HiddenLines> read_hidden(const std::string& text) {
    if (const auto hidden = hidden_lines_named(text)) return *hidden;
    return wrong_input("--hidden " + text + ": type remove, dash or show");
}

OrInputError<std::uint32_t> read_page_color(const std::string& text) {
    if (const auto color = color_from(text)) return *color;
    return wrong_input("--background " + text + ": type #RRGGBB");
}

}  // namespace

OrInputError<PageSize> read_page_size(const std::string& text) {
    constexpr double least = 10.0;
    constexpr double most = 10'000.0;
    std::string_view rest = text;
    double unit = 1.0;
    for (const auto& [name, points] : {std::pair<std::string_view, double>{"pt", 1.0},
                                       {"mm", 72.0 / 25.4},
                                       {"cm", 72.0 / 2.54},
                                       {"in", 72.0}}) {
        if (!rest.ends_with(name)) continue;
        unit = points;
        rest.remove_suffix(name.size());
        break;
    }
    const std::vector<std::string_view> parts = split(trimmed(rest), 'x');
    const auto width = read_number("--size", std::string(trimmed(parts.front())));
    const auto height = read_number("--size", std::string(trimmed(parts.back())));
    if (parts.size() != 2 || !width || !height) {
        return wrong_input("--size " + text +
                           ": type WIDTHxHEIGHT in points, for example 400x300, or with a unit: "
                           "120x90mm");
    }
    const PageSize size{.width = *width * unit, .height = *height * unit};
    const auto [low, high] = std::minmax(size.width, size.height);
    if (!(low >= least && high <= most)) {
        return wrong_input("--size " + text + ": each side must be from 10 to 10000 points");
    }
    return size;
}

OrInputError<DrawingPlan> read_drawing(const DrawingText& text) {
    DrawingPlan plan;
    OptionReader reader;
    reader.take(plan.choice.page, read_page_size(text.size));
    if (text.lines) reader.take(plan.choice.kinds, read_kinds(*text.lines));
    if (text.hidden) reader.take(plan.style.hidden, read_hidden(*text.hidden));
    plan.choice.hidden = plan.style.hidden != HiddenLines::Remove;
    if (text.width) reader.check(read_widths(*text.width, plan.style));
    if (text.background) reader.take(plan.style.background, read_page_color(*text.background));
    if (text.tolerance) {
        reader.take(plan.style.tolerance_pt,
                    read_between("--tolerance", *text.tolerance, 1e-4, 10.0));
        plan.choice.tolerance_pt = plan.style.tolerance_pt;
    }
    return reader.finish(plan);
}

}  // namespace zeroset
