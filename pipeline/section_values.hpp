#pragma once

#include "document/look.hpp"
#include "engine/scene/scene.hpp"

namespace zeroset {

/// How the scene's sections show values, by the document's choice; nothing where none does.
/// A range that is left open holds most of the values in the clip box, and does not change while
/// the sections move.
std::optional<SectionValues> section_values(const SectionChoice& choice, const Scene& scene);

}  // namespace zeroset
