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

}  // namespace

OrInputError<std::vector<SolidChoice>> read_solids(const std::vector<std::string>& texts) {
    std::vector<SolidChoice> choices;
    for (const std::string& typed : texts) {
        const std::string text = without_spaces(typed);
        const std::size_t colon = text.find(':');
        SolidChoice choice;
        if (colon != std::string::npos) {
            const auto number =
                read_integer("--solid", text.substr(0, colon), 1, static_cast<int>(max_surfaces));
            if (!number) return std::unexpected(number.error());
            choice.surface = *number;
        }
        const std::string name = text.substr(colon == std::string::npos ? 0 : colon + 1);
        const auto* const side =
            std::ranges::find(sides, name, &std::pair<const char*, SolidSide>::first);
        if (side == sides.end()) {
            return wrong_input("--solid " + typed +
                               ": type f<0, f>0 or auto; 2:f>0 is for the second surface alone");
        }
        choice.side = side->second;
        choices.push_back(choice);
    }
    return choices;
}

std::optional<InputError> check_solids(const Program& program,
                                       const std::vector<SolidChoice>& choices) {
    const auto count = static_cast<int>(program.surfaces.size());
    for (const SolidChoice& choice : choices) {
        if (choice.surface && *choice.surface > count) {
            return InputError{.reason = "--solid " + std::to_string(*choice.surface) +
                                        ": there is no such surface; the formula has " +
                                        std::to_string(count)};
        }
    }
    return std::nullopt;
}

void take_solids(const std::vector<SolidChoice>& choices, const std::vector<int>& surface_rows,
                 Document& document) {
    for (const SolidChoice& choice : choices) {
        for (std::size_t i = 0; i < surface_rows.size(); ++i) {
            if (choice.surface && static_cast<std::size_t>(*choice.surface) != i + 1) continue;
            const auto row =
                std::ranges::find(document.statements, surface_rows[i], &Statement::id);
            if (row != document.statements.end()) row->solid = choice.side;
        }
    }
}

}  // namespace zeroset
