#pragma once

#include "engine/scene/lighting.hpp"

#include <glm/glm.hpp>

namespace zeroset {

/// Linear light as a picture shows it. Filmic: the curve of [Narkowicz15], as bright at 0.18 as
/// plain.
glm::vec3 toned(Tone tone, const glm::vec3& light);

}  // namespace zeroset
