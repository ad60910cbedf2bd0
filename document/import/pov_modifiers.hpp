#pragma once

#include "document/import/imported.hpp"
#include "document/import/placement.hpp"
#include "document/import/pov_script.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace zeroset {

/// Colour and opacity that a scene gives to an object; none where it says nothing.
struct PovLook {
    std::optional<std::uint32_t> color;
    std::optional<double> opacity;
};

/// The transformations and textures of a scene of POV-Ray, and those that it declares.
class PovModifiers {
public:
    /// Both must outlive it; what is not taken over is told to `result`.
    PovModifiers(PovScript& script, ImportedDocument& result) : script_(script), result_(result) {}

    /// Reads a transformation or a texture, if one is next.
    bool read(Placement& placement, PovLook& look);
    /// Reads a transformation, if one is next.
    std::optional<Placement> transformation();
    /// Reads what follows "#declare NAME =", if that is a transformation or a texture.
    bool declare(const std::string& name);
    /// Reads the value behind a word; nothing, with a note, where it is not known.
    std::optional<double> number(const ScriptToken& word);
    std::optional<glm::dvec3> vector(const ScriptToken& word);
    /// Takes a colour where there is none yet.
    static void take_color(const std::optional<PovValue>& color, PovLook& look);

private:
    Placement matrix(const ScriptToken& word);
    Placement transform();
    /// Finds the colour in a texture: the first one told.
    void read_look(const ScriptToken& word, PovLook& look);

    PovScript& script_;
    ImportedDocument& result_;
    std::map<std::string, Placement, std::less<>> transforms_;
    std::map<std::string, PovLook, std::less<>> looks_;
    int depth_ = 0;
};

}  // namespace zeroset
