#pragma once

#include "engine/appearance/lights.hpp"
#include "engine/appearance/material.hpp"

#include <glm/glm.hpp>

#include <array>
#include <span>
#include <vector>

namespace zeroset {

/// A hit to be lit. Directions are of length 1, world axes.
struct LitHit {
    Look look;
    glm::vec3 towards_eye;              ///< where the ray came from
    glm::vec3 normal;                   ///< on that side
    glm::vec3 color;                    ///< reflectance
    std::array<float, max_lights> lit;  ///< how much of each light reaches it, 0 to 1
    bool is_mirrored;                   ///< seen in a mirror, where small lights would be specks
    float open;                         ///< how much of what is around does
};

/// The light, linear, that a hit sends to the eye.
struct HitLight {
    glm::vec3 body;   ///< out of the body, if it is opaque
    glm::vec3 gloss;  ///< mirrored by its surface from lights, and all around if that is not traced
    glm::vec3 mirror;  ///< the part of what a mirror shows that is seen in it, to be added
};

/// The look of hits in a picture. Read-only once it is made.
class HitShader {
public:
    /// `traces_mirrors`: what is mirrored will be found by rays.
    HitShader(const Lighting& lighting, const ViewFrame& view, bool traces_mirrors);

    [[nodiscard]] HitLight shade(const LitHit& hit) const;
    [[nodiscard]] const Surroundings& surroundings() const { return surroundings_; }
    [[nodiscard]] std::span<const SeenLight> lights() const { return lights_; }

private:
    [[nodiscard]] HitLight shade_standard(const LitHit& hit) const;
    [[nodiscard]] HitLight shade_phong(const LitHit& hit) const;
    /// The part that a mirror's picture has in the hit of a look whose gloss is no mirror's.
    [[nodiscard]] glm::vec3 mirror_of(const LitHit& hit) const;
    [[nodiscard]] HitLight shade_material(const LitHit& hit) const;

    bool traces_mirrors_;
    std::vector<SeenLight> lights_;
    Surroundings surroundings_;
    glm::vec3 up_;
};

}  // namespace zeroset
