#pragma once

#include "document/import/imported.hpp"
#include "document/import/placement.hpp"
#include "document/import/pov_modifiers.hpp"
#include "document/import/pov_script.hpp"
#include "engine/view/box.hpp"

#include <glm/glm.hpp>

#include <map>
#include <optional>
#include <string>

namespace zeroset {

/// The container of an isosurface, in its own coordinates: a ball or a box.
struct PovContainer {
    bool ball = false;
    glm::dvec3 lo{-1.0}, hi{1.0};  ///< of a box
    glm::dvec3 centre{0.0};
    double radius = 1.0;  ///< above 0
};

/// Reads the containers of a scene of POV-Ray, and those that it declares.
class PovContainers {
public:
    /// All must outlive it; what is not taken over is told to `result`.
    PovContainers(PovScript& script, PovModifiers& modifiers, ImportedDocument& result)
        : script_(script), modifiers_(modifiers), result_(result) {}

    /// Reads "{ ... }" behind contained_by; the usual box, with a note, where that is no container.
    PovContainer read();
    /// Reads what follows "#declare NAME =", if that is a container's shape.
    bool declare(const std::string& name);

private:
    std::optional<PovContainer> shape();

    PovScript& script_;
    PovModifiers& modifiers_;
    ImportedDocument& result_;
    std::map<std::string, PovContainer, std::less<>> declared_;
};

/// The formula of what is 0 on the container and negative in it; of a box its parts, separated by
/// commas, the greatest of which that is.
std::string inside_formula(const PovContainer& container);
/// The box that a placed container is in.
Box box_of(const PovContainer& container, const Placement& placed);

}  // namespace zeroset
