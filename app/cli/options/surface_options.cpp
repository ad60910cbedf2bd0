#include "app/cli/options/surface_options.hpp"

#include "app/cli/options/light_options.hpp"
#include "app/cli/options/view_options.hpp"
#include "document/colors.hpp"
#include "engine/base/text.hpp"
#include "engine/expr/patch_graph.hpp"
#include "pipeline/input_error.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace zeroset {
namespace {

constexpr std::array<std::pair<const char*, SolidSide>, 3> sides{
    {{"auto", SolidSide::Automatic}, {"f<0", SolidSide::Below}, {"f>0", SolidSide::Above}}};

std::string without_spaces(std::string text) {
    std::erase(text, ' ');
    return text;
}

/// A choice as typed: of the surface of a number, or of all.
struct NumberedText {
    std::optional<int> surface;
    std::string text;
};
OrInputError<NumberedText> numbered_text(const std::string& option, const std::string& typed) {
    NumberedText choice{.surface = std::nullopt, .text = without_spaces(typed)};
    const std::size_t colon = choice.text.find(':');
    if (colon == std::string::npos) return choice;
    const auto number =
        read_integer(option, choice.text.substr(0, colon), 1, static_cast<int>(max_surfaces));
    if (!number) return std::unexpected(number.error());
    choice.surface = *number;
    choice.text.erase(0, colon + 1);
    return choice;
}

/// Reads an option's values. `read`: of one, without the number; nothing if it is wrong, and
/// then the error is `help`, what to type.
template <class Value, class Read>
std::optional<InputError> read_choices(const std::string& option,
                                       const std::vector<std::string>& texts,
                                       const std::string& help, const Read& read,
                                       std::vector<SurfaceChoice<Value>>& choices) {
    for (const std::string& typed : texts) {
        const auto choice = numbered_text(option, typed);
        if (!choice) return choice.error();
        const std::optional<Value> value = read(choice->text);
        if (!value) return InputError{.reason = option + " " + typed + ": " + help};
        choices.push_back({.surface = choice->surface, .value = *value});
    }
    return std::nullopt;
}

std::optional<SolidSide> side_named(const std::string& name) {
    const auto* const side =
        std::ranges::find(sides, name, &std::pair<const char*, SolidSide>::first);
    return side == sides.end() ? std::nullopt : std::optional(side->second);
}

std::optional<double> opacity_from(const std::string& text) {
    const auto opacity = read_number("--opacity", text);
    if (!opacity || *opacity < 0.0 || *opacity > 1.0) return std::nullopt;
    return *opacity;
}

std::optional<InputError> read_boxes(const std::vector<std::string>& texts,
                                     std::vector<SurfaceChoice<Box>>& boxes) {
    for (const std::string& typed : texts) {
        const auto choice = numbered_text("--surface-box", typed);
        if (!choice) return choice.error();
        const auto box = read_box("--surface-box", choice->text);
        if (!box) return box.error();
        boxes.push_back({.surface = choice->surface, .value = *box});
    }
    return std::nullopt;
}

template <class Choice>
std::optional<InputError> check_numbers(const std::string& option, const Program& program,
                                        const std::vector<Choice>& choices) {
    const auto count = static_cast<int>(program.surfaces.size());
    for (const Choice& choice : choices) {
        if (!choice.surface || *choice.surface <= count) continue;
        return InputError{.reason = option + " " + std::to_string(*choice.surface) +
                                    ": there is no such surface; the formula has " +
                                    std::to_string(count)};
    }
    return std::nullopt;
}

/// Calls `take` with the rows of the surfaces that each choice is of.
template <class Choice, class Take>
void take_choices(const std::vector<Choice>& choices, const std::vector<int>& surface_rows,
                  Document& document, const Take& take) {
    for (const Choice& choice : choices) {
        for (std::size_t i = 0; i < surface_rows.size(); ++i) {
            if (choice.surface && static_cast<std::size_t>(*choice.surface) != i + 1) continue;
            const auto row =
                std::ranges::find(document.statements, surface_rows[i], &Statement::id);
            if (row != document.statements.end()) take(*row, choice);
        }
    }
}

/// Returns an error for a thickness of what has none.
std::optional<InputError> check_thicknesses(const Program& program,
                                            const std::vector<SurfaceChoice<Thickness>>& choices) {
    const auto has_one = [](const Expr& surface) {
        const auto graphs = patch_of(surface);
        return graphs && has_thickness(graphs->kind);
    };
    for (const auto& choice : choices) {
        const bool fits =
            choice.surface
                ? has_one(program.surfaces[static_cast<std::size_t>(*choice.surface) - 1])
                : std::ranges::any_of(program.surfaces, has_one);
        if (fits) continue;
        return InputError{.reason = choice.surface
                                        ? "--thickness " + std::to_string(*choice.surface) +
                                              ": this surface is no curve and no point"
                                        : "--thickness: there is no curve and no point"};
    }
    return std::nullopt;
}

}  // namespace

OrInputError<SurfaceChoices> read_surface_choices(const SurfaceTexts& texts) {
    SurfaceChoices choices;
    const auto wrong = [&]() -> std::optional<InputError> {
        if (auto error =
                read_choices("--solid", texts.solids,
                             "type f<0, f>0 or auto; 2:f>0 is for the second surface alone",
                             side_named, choices.solids))
            return error;
        if (auto error =
                read_choices("--opacity", texts.opacities,
                             "type a number from 0 to 1; 2:0.5 is for the second surface alone",
                             opacity_from, choices.opacities))
            return error;
        if (auto error =
                read_choices("--surface-look", texts.looks,
                             "type " + look_words() + "; 2:metal is for the second surface alone",
                             look_named, choices.looks))
            return error;
        if (auto error = read_choices(
                "--color", texts.colors,
                "type a color such as #D9763A; 2:#D9763A is for the second surface alone",
                color_from, choices.colors))
            return error;
        if (auto error = read_choices(
                "--thickness", texts.thicknesses,
                "type a width above 0 such as 0.05, or in pixels 3px, up to " +
                    short_number(most_pixels_thick) + "; 2:3px is for the second surface alone",
                thickness_from, choices.thicknesses))
            return error;
        return read_boxes(texts.boxes, choices.boxes);
    }();
    if (wrong) return std::unexpected(*wrong);
    return choices;
}

std::optional<InputError> check_surface_choices(const Program& program,
                                                const SurfaceChoices& choices) {
    if (auto missing = check_numbers("--solid", program, choices.solids)) return missing;
    if (auto missing = check_numbers("--opacity", program, choices.opacities)) return missing;
    if (auto missing = check_numbers("--surface-look", program, choices.looks)) return missing;
    if (auto missing = check_numbers("--color", program, choices.colors)) return missing;
    if (auto missing = check_numbers("--surface-box", program, choices.boxes)) return missing;
    if (auto missing = check_numbers("--thickness", program, choices.thicknesses)) return missing;
    return check_thicknesses(program, choices.thicknesses);
}

void take_surface_choices(const SurfaceChoices& choices, const std::vector<int>& surface_rows,
                          Document& document) {
    take_choices(choices.solids, surface_rows, document,
                 [](Statement& row, const auto& choice) { row.solid = choice.value; });
    take_choices(choices.opacities, surface_rows, document,
                 [](Statement& row, const auto& choice) { row.opacity = choice.value; });
    take_choices(choices.looks, surface_rows, document,
                 [](Statement& row, const auto& choice) { row.look = choice.value; });
    take_choices(choices.colors, surface_rows, document,
                 [](Statement& row, const auto& choice) { row.color = choice.value; });
    take_choices(choices.thicknesses, surface_rows, document,
                 [](Statement& row, const auto& choice) { row.thickness = choice.value; });
    take_choices(choices.boxes, surface_rows, document,
                 [](Statement& row, const auto& choice) { row.box = choice.value; });
}

}  // namespace zeroset
