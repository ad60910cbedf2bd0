#pragma once

#include "document/import/foreign_formula.hpp"
#include "document/import/imported.hpp"
#include "document/import/names.hpp"
#include "document/import/pov_pattern.hpp"
#include "document/import/pov_script.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// The functions of a scene of POV-Ray, and the rows that define them.
class PovFormulas {
public:
    /// All must outlive it.
    PovFormulas(PovScript& script, PovModifiers& modifiers, ImportedDocument& result)
        : script_(script), modifiers_(modifiers), result_(result) {}

    /// Reads "function (names) { formula }" from behind its first word, and gives it a row; names
    /// that are left out are the usual ones. The
    /// name in the language, or nothing, with a note, where it cannot be taken over. `wanted`: its
    /// name in the file.
    std::optional<std::string> read(std::string_view wanted,
                                    const std::vector<std::string>& usual = {"x", "y", "z"});

    /// The function of the scene that has this name, as it is called here.
    [[nodiscard]] std::optional<std::string> find(std::string_view name) const;
    void define(const std::string& name, const std::string& own) { functions_[name] = own; }
    /// Defines `name` as the function that `same` is already, with its colours.
    void define_as(const std::string& name, const std::string& same);
    /// Adds the row "own(x, y, z) = formula" and returns the name.
    std::string add(std::string_view wanted, const std::string& formula, std::size_t line);

private:
    std::vector<std::string> parameters(const std::vector<std::string>& usual);
    /// Reads "pattern { ... }" or "pigment { ... }" behind the brace of a function.
    std::optional<std::string> pattern(std::string_view wanted, std::size_t line);
    /// The name of a definition of the part of a pigment's colours.
    std::string part_of(const std::string& function, std::string_view part, std::size_t line);
    bool translate_part(ForeignTerm& call);
    std::string translated(ForeignTerm term, const std::vector<std::string>& parameters);
    void translate_call(ForeignTerm& call);
    void translate_name(ForeignTerm& name, const std::vector<std::string>& parameters);

    PovScript& script_;
    PovModifiers& modifiers_;
    ImportedDocument& result_;
    ImportedNames names_;
    std::map<std::string, std::string, std::less<>> functions_;  ///< names here by those there
    std::map<std::pair<std::string, double>, std::string> constants_;
    /// Definitions of colours, by the function there; those of its parts, by "function.part".
    /// Forgets the colours that a name had.
    void forget_colors(const std::string& name);

    std::map<std::string, std::array<std::string, 3>, std::less<>> colors_;
    std::map<std::string, std::string, std::less<>> parts_;
};

}  // namespace zeroset
