#pragma once

#include "document/import/imported.hpp"
#include "document/import/placement.hpp"
#include "document/import/pov_modifiers.hpp"
#include "document/import/pov_script.hpp"

#include <cstdint>
#include <optional>

namespace zeroset {

/// Where x, y and z of a scene lead, which its camera says.
enum class PovAxes : std::uint8_t {
    LeftHanded,      ///< as is usual there: (x, y, z) is (x, z, y) here
    RightHanded,     ///< y is up: (x, y, z) is (x, -z, y) here
    RightHandedZUp,  ///< as here
};
/// The map from the scene to here.
Placement placement_of(PovAxes axes);

struct PovCamera {
    Camera camera;
    PovAxes axes = PovAxes::LeftHanded;
};

/// Reads the block of a scene's camera; nothing, with a note, where it could see nothing.
std::optional<PovCamera> read_pov_camera(PovScript& script, PovModifiers& modifiers,
                                         ImportedDocument& result);

}  // namespace zeroset
