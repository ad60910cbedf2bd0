#include "engine/appearance/shade_hit.hpp"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

/// The light of microfacets between two directions, times pi and the light's cosine: the
/// distribution of Trowbridge and Reitz, or GGX, with Smith's shadowing [Walter07; Heitz14].
float microfacets(float roughness, float to_normal, float light_cosine, float eye_cosine) {
    const float width = std::max(roughness * roughness, 1e-3F);
    const float square = width * width;
    const float spread = to_normal * to_normal * (square - 1.0F) + 1.0F;
    const float density = square / (spread * spread);  // times pi
    const auto hidden = [square](float cosine, float other) {
        return other * std::sqrt(cosine * cosine * (1.0F - square) + square);
    };
    const float shadowing =
        0.5F / std::max(hidden(light_cosine, eye_cosine) + hidden(eye_cosine, light_cosine), 1e-6F);
    return density * shadowing * light_cosine;
}

}  // namespace

HitShader::HitShader(const Lighting& lighting, const ViewFrame& view, bool traces_mirrors)
    : traces_mirrors_(traces_mirrors),
      lights_(lights_of(lighting, view)),
      surroundings_(view, glm::vec3(lights_.front().towards)),
      up_(view.up) {}

HitLight HitShader::shade(const LitHit& hit) const {
    switch (hit.look) {
        case Look::Standard: return shade_standard(hit);
        case Look::Phong: return shade_phong(hit);
        case Look::Matte:
        case Look::Porcelain:
        case Look::Metal:
        case Look::Glass:
        case Look::Clay:
        case Look::Technical: break;
    }
    return shade_material(hit);
}

glm::vec3 HitShader::mirror_of(const LitHit& hit) const {
    if (!traces_mirrors_) return glm::vec3(0.0F);
    return fresnel(glm::vec3(material_of(hit.look).reflectance),
                   glm::dot(hit.normal, hit.towards_eye));
}

/// The standard look, shaded as engine/light/shade does it.
HitLight HitShader::shade_standard(const LitHit& hit) const {
    HitLight out{};
    glm::vec3 diffuse(0.16F * (0.5F + 0.5F * glm::dot(hit.normal, up_)) + 0.10F);
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const glm::vec3 towards(lights_[i].towards);
        const glm::vec3 light = hit.lit[i] * lights_[i].color;
        diffuse += light * std::max(glm::dot(hit.normal, towards), 0.0F);
        if (!lights_[i].casts_shadows) continue;
        const glm::vec3 half = towards + hit.towards_eye;
        const float size = glm::length(half);
        const float gloss = size > 1e-3F ? glm::dot(hit.normal, half) / size : 0.0F;
        out.gloss += 0.22F / 0.85F * light * std::pow(std::max(gloss, 0.0F), 32.0F);
    }
    out.body = hit.color * diffuse;
    out.gloss *= 1.0F - out.body;
    out.mirror = mirror_of(hit);
    return out;
}

/// c = c_r (c_a + c_l max(0, n.l)) + max(0, e.r)^p, where r is the light's mirrored direction
/// [Florez08, eq. 2.6]. Differs from the paper: there may be several lights, the highlight is as
/// bright as its light, and there is none where its light does not reach the surface.
HitLight HitShader::shade_phong(const LitHit& hit) const {
    constexpr float ambient = 0.15F;
    constexpr float power = 30.0F;
    HitLight out{};
    glm::vec3 diffuse(ambient);
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const glm::vec3 towards(lights_[i].towards);
        const glm::vec3 light = hit.lit[i] * lights_[i].color;
        const float cosine = glm::dot(hit.normal, towards);
        if (cosine <= 0.0F) continue;
        diffuse += light * cosine;
        const glm::vec3 mirrored = 2.0F * cosine * hit.normal - towards;
        out.gloss += light * std::pow(std::max(glm::dot(hit.towards_eye, mirrored), 0.0F), power);
    }
    out.body = hit.color * diffuse;
    out.mirror = mirror_of(hit);
    return out;
}

HitLight HitShader::shade_material(const LitHit& hit) const {
    const Material of = material_of(hit.look);
    const glm::vec3 color = glm::mix(hit.color, of.stain, of.stain_share);
    const glm::vec3 head_on = glm::mix(glm::vec3(of.reflectance), color, of.metalness);
    const glm::vec3 body = color * (1.0F - of.metalness);
    const float eye_cosine = std::max(glm::dot(hit.normal, hit.towards_eye), 1e-3F);
    const float open = 1.0F - ambient_shade(hit.look) * (1.0F - hit.open);
    // A light is a point, which no mirror is smooth enough to show as one.
    const float light_roughness = std::max(of.roughness, hit.is_mirrored ? 0.35F : 0.12F);
    const bool mirrors = of.reflectance > 0.0F || of.metalness > 0.0F;

    HitLight out{};
    out.body = 0.42F * open * of.surroundings * body * surroundings_.on(hit.normal);
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const glm::vec3 towards(lights_[i].towards);
        const glm::vec3 light = hit.lit[i] * lights_[i].color;
        const float cosine = glm::dot(hit.normal, towards);
        if (cosine <= 0.0F) continue;
        out.body += light * cosine * body;
        const glm::vec3 half = towards + hit.towards_eye;
        const float size = glm::length(half);
        if (!mirrors || size < 1e-3F) continue;
        const float to_normal = glm::dot(hit.normal, half) / size;
        const float half_cosine = glm::dot(hit.towards_eye, half) / size;
        out.gloss += microfacets(light_roughness, to_normal, cosine, eye_cosine) *
                     fresnel(head_on, half_cosine) * light;
    }
    if (!mirrors) return out;
    out.mirror = mirrored_share(head_on, of.roughness, eye_cosine);
    if (traces_mirrors_) return out;
    const glm::vec3 reflected = 2.0F * eye_cosine * hit.normal - hit.towards_eye;
    out.gloss += open * out.mirror * surroundings_.seen(reflected, of.roughness);
    return out;
}

}  // namespace zeroset
