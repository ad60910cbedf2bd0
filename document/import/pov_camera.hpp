#pragma once

#include "document/import/imported.hpp"
#include "document/import/pov_modifiers.hpp"
#include "document/import/pov_script.hpp"

#include <optional>

namespace zeroset {

/// Reads the block of a scene's camera; nothing, with a note, where it could see nothing.
std::optional<Camera> read_pov_camera(PovScript& script, PovModifiers& modifiers,
                                      ImportedDocument& result);

}  // namespace zeroset
