#include "document/import/names.hpp"

#include "engine/language/parse.hpp"

namespace zeroset {
namespace {

/// Whether the language takes the name as one, and for what a text defines.
bool can_be_defined(const std::string& name) {
    const auto program = read_program(name + "(u) = 2u\n" + name + "(x) + y + z");
    return program && program->parameters.empty();
}

constexpr std::size_t longest_stem = 60;
constexpr int most_tries = 20;

bool is_coordinate(std::string_view name) {
    return name == "x" || name == "y" || name == "z" || name == "w" || name == "t";
}

}  // namespace

bool can_have_slider(std::string_view name) {
    const std::string text(name);
    const auto program = read_program(text + " + x");
    return program && program->parameters.size() == 1 && program->parameters[0] == text;
}

std::string ImportedNames::fresh(std::string_view wanted) {
    const auto is_free = [this](const std::string& name) {
        return !taken_.contains(name) && !is_coordinate(name) && can_be_defined(name);
    };
    std::string name(wanted);
    const std::string stem = wanted.size() > longest_stem || wanted.empty() ? "value" : name;
    int& last = next_[stem];
    for (int tries = 1; !is_free(name); ++tries) {
        // Names that cannot be defined with a number behind them either become values.
        name = (tries > most_tries ? "value" : stem) + "_" + std::to_string(++last + 1);
    }
    taken_.insert(name);
    return name;
}

}  // namespace zeroset
