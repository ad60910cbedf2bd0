#pragma once

#include "engine/scene/lighting.hpp"

#include <glm/glm.hpp>

namespace zeroset {

/// How a surface answers light, of the usual parameters of physically based shading [Burley12].
struct Material {
    float metalness = 0.0F;    ///< 0: a body under a clear surface; 1: all light is mirrored
    float roughness = 1.0F;    ///< of the microfacets that mirror, 0 to 1 [Walter07]
    float reflectance = 0.0F;  ///< mirrored head-on, of light that falls on a body
    float opacity = 1.0F;
    glm::vec3 stain{1.0F};      ///< colour that the surface's own one is mixed with
    float stain_share = 0.0F;   ///< of it
    float surroundings = 1.0F;  ///< how much light comes from all around
};

/// The material of a look; Standard's is what a mirror of it needs only.
Material material_of(Look look);

/// The part of light from all around that is mirrored to one who looks at an angle of this cosine,
/// from a surface that mirrors `head_on` [Karis14].
glm::vec3 mirrored_share(const glm::vec3& head_on, float roughness, float cosine);
/// The mirrored part of light from a direction half of whose angle to the eye has this cosine
/// [Schlick94].
glm::vec3 fresnel(const glm::vec3& head_on, float half_cosine);

}  // namespace zeroset
