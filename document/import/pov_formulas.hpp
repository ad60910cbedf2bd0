#pragma once

#include "document/import/foreign_formula.hpp"
#include "document/import/imported.hpp"
#include "document/import/names.hpp"
#include "document/import/pov_script.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// The functions of a scene of POV-Ray, and the rows that define them.
class PovFormulas {
public:
    PovFormulas(PovScript& script, ImportedDocument& result) : script_(script), result_(result) {}

    /// Reads "function (names) { formula }" from behind its first word, and gives it a row. The
    /// name in the language, or nothing, with a note, where it cannot be taken over. `wanted`: its
    /// name in the file.
    std::optional<std::string> read(std::string_view wanted);

    /// The function of the scene that has this name, as it is called here.
    [[nodiscard]] std::optional<std::string> find(std::string_view name) const;
    void define(const std::string& name, const std::string& own) { functions_[name] = own; }
    /// Adds the row "own(x, y, z) = formula" and returns the name.
    std::string add(std::string_view wanted, const std::string& formula, std::size_t line);

private:
    std::vector<std::string> parameters();
    std::string translated(Term term, const std::vector<std::string>& parameters);
    void translate_call(Term& call) const;
    void translate_name(Term& name, const std::vector<std::string>& parameters);

    PovScript& script_;
    ImportedDocument& result_;
    ImportedNames names_;
    std::map<std::string, std::string, std::less<>> functions_;  ///< names here by those there
    std::map<std::pair<std::string, double>, std::string> constants_;
};

}  // namespace zeroset
