#pragma once

#include "document/import/imported.hpp"
#include "document/import/pov_modifiers.hpp"
#include "document/import/pov_script.hpp"

#include <expected>
#include <string>
#include <vector>

namespace zeroset {

/// A pattern of a scene of POV-Ray, or a pigment made of one, as a function of the point.
struct PovPattern {
    struct Entry {
        double at;  ///< the value that has this colour; colours between entries are mixed
        PovValue color;
    };
    std::string call;             ///< the value at (x, y, z), from 0 to 1
    std::string moved = {};       ///< the point at which that is taken; empty: (x, y, z)
    std::vector<Entry> map = {};  ///< the colours of a pigment, by rising values

    /// Reads a function's block "{ pattern { ... } }" or "{ pigment { ... } }", and passes over it;
    /// the error is one line.
    static std::expected<PovPattern, std::string> read(PovScript& script, PovModifiers& modifiers,
                                                       ImportedDocument& result);

    /// A channel of the colour of a value, which is a formula.
    [[nodiscard]] std::string mapped(const std::string& value, int channel) const;
};

}  // namespace zeroset
