#include "app/cli/options/solid_options.hpp"

#include "app/cli/options/region_options.hpp"
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

}  // namespace

OrInputError<std::vector<SolidChoice>> read_solids(const std::vector<std::string>& texts) {
    std::vector<SolidChoice> choices;
    for (const std::string& typed : texts) {
        const auto choice = numbered_text("--solid", typed);
        if (!choice) return std::unexpected(choice.error());
        const auto* const side =
            std::ranges::find(sides, choice->text, &std::pair<const char*, SolidSide>::first);
        if (side == sides.end()) {
            return wrong_input("--solid " + typed +
                               ": type f<0, f>0 or auto; 2:f>0 is for the second surface alone");
        }
        choices.push_back({.surface = choice->surface, .side = side->second});
    }
    return choices;
}

OrInputError<std::vector<OpacityChoice>> read_opacities(const std::vector<std::string>& texts) {
    std::vector<OpacityChoice> choices;
    for (const std::string& typed : texts) {
        const auto choice = numbered_text("--opacity", typed);
        if (!choice) return std::unexpected(choice.error());
        const auto opacity = read_number("--opacity", choice->text);
        if (!opacity || *opacity < 0.0 || *opacity > 1.0) {
            return wrong_input(
                "--opacity " + typed +
                ": type a number from 0 to 1; 2:0.5 is for the second surface alone");
        }
        choices.push_back({.surface = choice->surface, .opacity = *opacity});
    }
    return choices;
}

std::optional<InputError> check_solids(const Program& program,
                                       const std::vector<SolidChoice>& choices) {
    return check_numbers("--solid", program, choices);
}

std::optional<InputError> check_opacities(const Program& program,
                                          const std::vector<OpacityChoice>& choices) {
    return check_numbers("--opacity", program, choices);
}

void take_solids(const std::vector<SolidChoice>& choices, const std::vector<int>& surface_rows,
                 Document& document) {
    take_choices(choices, surface_rows, document,
                 [](Statement& row, const SolidChoice& choice) { row.solid = choice.side; });
}

void take_opacities(const std::vector<OpacityChoice>& choices, const std::vector<int>& surface_rows,
                    Document& document) {
    take_choices(choices, surface_rows, document,
                 [](Statement& row, const OpacityChoice& choice) { row.opacity = choice.opacity; });
}

OrInputError<SurfaceChoices> read_surface_choices(const SurfaceTexts& texts) {
    SurfaceChoices choices;
    for (const std::string& typed : texts.colors) {
        const auto choice = numbered_text("--color", typed);
        if (!choice) return std::unexpected(choice.error());
        const auto color = color_from(choice->text);
        if (!color) {
            return wrong_input("--color " + typed +
                               ": type a color such as #D9763A; 2:#D9763A is for the second "
                               "surface alone");
        }
        choices.colors.push_back({.surface = choice->surface, .value = *color});
    }
    for (const std::string& typed : texts.thicknesses) {
        const auto choice = numbered_text("--thickness", typed);
        if (!choice) return std::unexpected(choice.error());
        const auto thickness = thickness_from(choice->text);
        if (!thickness) {
            return wrong_input("--thickness " + typed +
                               ": type a width above 0 such as 0.05, or in pixels 3px, up to " +
                               short_number(most_pixels_thick) +
                               "; 2:3px is for the second surface alone");
        }
        choices.thicknesses.push_back({.surface = choice->surface, .value = *thickness});
    }
    for (const std::string& typed : texts.boxes) {
        const auto choice = numbered_text("--surface-box", typed);
        if (!choice) return std::unexpected(choice.error());
        const auto box = read_box("--surface-box", choice->text);
        if (!box) return std::unexpected(box.error());
        choices.boxes.push_back({.surface = choice->surface, .value = *box});
    }
    return choices;
}

std::optional<InputError> check_surface_choices(const Program& program,
                                                const SurfaceChoices& choices) {
    if (auto missing = check_numbers("--color", program, choices.colors)) return missing;
    if (auto missing = check_numbers("--surface-box", program, choices.boxes)) return missing;
    if (auto missing = check_numbers("--thickness", program, choices.thicknesses)) return missing;
    const auto has_one = [](const Expr& surface) {
        const auto graphs = patch_of(surface);
        return graphs && has_thickness(graphs->kind);
    };
    for (const auto& choice : choices.thicknesses) {
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

void take_surface_choices(const SurfaceChoices& choices, const std::vector<int>& surface_rows,
                          Document& document) {
    take_choices(choices.colors, surface_rows, document,
                 [](Statement& row, const auto& choice) { row.color = choice.value; });
    take_choices(choices.thicknesses, surface_rows, document,
                 [](Statement& row, const auto& choice) { row.thickness = choice.value; });
    take_choices(choices.boxes, surface_rows, document,
                 [](Statement& row, const auto& choice) { row.box = choice.value; });
}

}  // namespace zeroset
