#include "app/cli/options/look_options.hpp"

#include "app/cli/options/options.hpp"
#include "engine/base/text.hpp"
#include "pipeline/input_error.hpp"

#include <algorithm>
#include <string_view>

namespace zeroset {
namespace {

/// Reads the name of a colouring; any other text is an expression.
void read_color_by(const std::string& text, ColorChoice& coloring) {
    const auto by = color_by_named(text);
    coloring.by = by.value_or(ColorBy::Expression);
    if (!by) coloring.expression = text;
}

std::optional<InputError> read_map(const std::string& text, ColorChoice& coloring) {
    coloring.map = color_map_named(text);
    if (coloring.map) return std::nullopt;
    std::string names;
    for (const ColorMap map : color_maps())
        names += " " + std::string(name_of(map));
    return InputError{.reason =
                          "--color-map " + text + ": there is no such map; type one of:" + names};
}

std::optional<InputError> read_range(const std::string& text, ColorChoice& coloring) {
    if (text == "auto") {
        coloring.range.reset();
        return std::nullopt;
    }
    const auto numbers = read_numbers("--color-range", text, 2);
    if (!numbers) return numbers.error();
    const ValueRange range{.lo = (*numbers)[0], .hi = (*numbers)[1]};
    if (!(range.lo < range.hi)) {
        return InputError{.reason = "--color-range " + text +
                                    ": the first number must be below the second, for example 0,1"};
    }
    coloring.range = range;
    return std::nullopt;
}

/// The number behind a word that begins a part such as "step 0.5"; nothing where it does not, or
/// where that is no number.
std::optional<double> number_behind(std::string_view part, std::string_view word) {
    const auto text = value_behind(part, word);
    const auto number = text ? read_number("--contours", *text) : OrInputError<double>(0.0);
    return text && number ? std::optional(*number) : std::nullopt;
}

/// Reads X,Y,Z or X,Y,Z; label TEXT.
std::optional<InputError> read_mark(const std::string& mark, std::vector<Marker>& markers) {
    const std::size_t semicolon = std::min(mark.find(';'), mark.size());
    const auto at = read_numbers("--mark", mark.substr(0, semicolon), 3);
    if (!at) return at.error();
    std::string label;
    if (semicolon < mark.size()) {
        const auto text =
            value_behind(trimmed(std::string_view(mark).substr(semicolon + 1)), "label");
        if (!text || text->empty() || text->size() > longest_label) {
            return InputError{.reason = "--mark " + mark +
                                        ": after the ; type label TEXT, at most " +
                                        std::to_string(longest_label) + " bytes"};
        }
        label = *text;
    }
    if (add_marker(markers, {(*at)[0], (*at)[1], (*at)[2]}, label) != 0) return std::nullopt;
    return InputError{.reason = "--mark " + mark + ": there are " + std::to_string(most_markers) +
                                " markers already"};
}

}  // namespace

std::optional<InputError> read_contours(const std::string& text, LineChoice& lines) {
    const std::vector<std::string_view> parts = split(text, ';');
    const auto named = contours_named(parts.front());
    const bool is_name = named && *named != Contours::Expression;
    lines.contours = is_name ? *named : Contours::Expression;
    if (!is_name) lines.expression = parts.front();
    lines.step.reset();
    lines.labels = false;
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const auto step = number_behind(parts[i], "step");
        const auto width = number_behind(parts[i], "width");
        if (trimmed(parts[i]) == "labels") {
            lines.labels = true;
        } else if (step && *step > 0.0) {
            lines.step = step;
        } else if (width && *width >= least_line && *width <= most_line) {
            lines.width = width;
        } else {
            return InputError{.reason = "--contours " + text +
                                        ": after a ; type step S, above 0, " +
                                        "width W, 0.25 to 20 (pixels, points in drawings), or "
                                        "labels"};
        }
    }
    return std::nullopt;
}

InputError contours_error(const InputError& error) {
    InputError result = error;
    result.reason = "--contours: " + error.reason;
    if (!error.line.empty()) result.reason += " (or type none, height or xyz)";
    return result;
}

std::optional<InputError> read_look(const LookText& text, ColorChoice& coloring,
                                    std::vector<Marker>& markers) {
    if (text.color_by) read_color_by(*text.color_by, coloring);
    if (text.color_map) {
        if (auto error = read_map(*text.color_map, coloring)) return error;
    }
    if (text.color_range) {
        if (auto error = read_range(*text.color_range, coloring)) return error;
        if (coloring.range && coloring.by == ColorBy::Plain) {
            return InputError{.reason = "--color-range " + *text.color_range +
                                        ": no colors tell numbers; type --color-by, too, for "
                                        "example --color-by height"};
        }
    }
    if (text.contours) {
        if (auto error = read_contours(*text.contours, coloring.lines)) return error;
    }
    coloring.lines.intersections = text.intersections.value_or(coloring.lines.intersections);
    for (const std::string& mark : text.marks) {
        if (auto error = read_mark(mark, markers)) return error;
    }
    return std::nullopt;
}

InputError color_by_error(const InputError& error) {
    InputError result = error;
    result.reason = "--color-by: " + error.reason;
    if (error.line.empty()) return result;
    std::string names;
    for (const ColorBy by : color_modes()) {
        if (by != ColorBy::Expression) names += " " + std::string(name_of(by));
    }
    result.reason += " (or type one of:" + names + ")";
    return result;
}

}  // namespace zeroset
