#include "app/cli/options/solid_options.hpp"

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

}  // namespace zeroset
