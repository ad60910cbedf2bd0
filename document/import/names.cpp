#include "document/import/names.hpp"

#include "engine/language/parse.hpp"

namespace zeroset {
namespace {

/// Whether the language takes the name as one, and for what a text defines.
bool can_be_defined(const std::string& name) {
    const auto program = read_program(name + "(u) = 2u\n" + name + "(x) + y + z");
    return program && program->parameters.empty();
}

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
    std::string name(wanted);
    if (is_coordinate(name) || !can_be_defined(name)) name += "_1";
    const std::string stem = name;
    for (int i = 2; taken_.contains(name) || !can_be_defined(name); ++i)
        name = (i < 10 ? stem : "value") + "_" + std::to_string(i);
    taken_.insert(name);
    return name;
}

}  // namespace zeroset
