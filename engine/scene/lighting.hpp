#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace zeroset {

/// The material that surfaces look as if they were made of.
enum class Look : std::uint8_t {
    Standard,   ///< a little gloss under two lights, quick
    Phong,      ///< a sharp white highlight, as figures of papers have it [Florez08, 2.3]
    Matte,      ///< reflects alike in all directions
    Porcelain,  ///< a white body under a clear glaze
    Metal,      ///< mirrors its surroundings in its own colour, somewhat blurred
    Glass,      ///< mostly seen through; mirrors where it is seen from aside
    Clay,       ///< matte, in muted colours, darker in its hollows
    Technical,  ///< pale, with lines at silhouettes, creases and boundaries
};
std::span<const Look> looks();
/// The name as it is typed: "porcelain".
std::string_view name_of(Look look);
std::optional<Look> look_named(std::string_view name);

/// A light so far away that its rays are parallel.
struct Light {
    /// Towards the light, not 0: in world axes, or to the right, upwards and backwards as the
    /// camera is turned.
    glm::dvec3 towards{-0.45, 0.65, 0.75};
    bool with_camera = true;
    std::array<float, 3> color{1.0F, 1.0F, 1.0F};  ///< linear, 0 to 1
    double power = 0.85;                           ///< at least 0; of white on white
    /// How large the light is as seen from the surface: half its angle, 0 to half_sphere_deg. Above
    /// 0 its shadows are soft.
    double radius_deg = 0.0;

    bool operator==(const Light&) const = default;
};
inline constexpr std::size_t max_lights = 4;
inline constexpr double half_sphere_deg = 90.0;
inline constexpr double max_power = 100.0;

/// From light to what a picture can show.
enum class Tone : std::uint8_t {
    Plain,   ///< as it is, up to the brightest that a picture shows
    Filmic,  ///< bright light is compressed, so that highlights keep their colour
};
std::string_view name_of(Tone tone);
std::optional<Tone> tone_named(std::string_view name);

inline constexpr int max_reflections = 5;
/// Surfaces that a ray passes, at most, before it is given up.
inline constexpr int max_layers = 32;

/// The look of one surface where it differs from that of all.
struct SurfaceLook {
    std::optional<Look> look = std::nullopt;       ///< none: Lighting::look
    std::optional<double> opacity = std::nullopt;  ///< 0 to 1; none: the look's own

    bool operator==(const SurfaceLook&) const = default;
};

/// How the surfaces of a scene are lit, and what of. A value.
struct Lighting {
    Look look = Look::Standard;
    std::vector<Light> lights;  ///< at most max_lights; none: those of `look`
    /// How much solids swallow of what is seen through them, on a way of length 1, of the colours
    /// that they are not: at least 0.
    double absorption = 0.0;
    Tone tone = Tone::Plain;

    bool operator==(const Lighting&) const = default;
};

/// Whether a light has a size as seen from the surface, so that its shadows are soft.
bool has_broad_light(const Lighting& lighting);
/// How much darker hollows of a look are, 0 to 1.
float ambient_shade(Look look);

}  // namespace zeroset
