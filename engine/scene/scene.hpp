#pragma once

#include "engine/image/background.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/scene/coloring.hpp"
#include "engine/scene/lighting.hpp"
#include "engine/scene/open_space.hpp"
#include "engine/scene/palette.hpp"
#include "engine/scene/region.hpp"
#include "engine/view/box.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace zeroset {

inline constexpr std::size_t max_surfaces = 255;

/// Which side of a surface is a solid, that sections cut open.
enum class SolidSide : std::uint8_t {
    Automatic,  ///< f < 0, unless f < 0 on most of each face of the clip box
    Below,      ///< f < 0
    Above,      ///< f > 0
};

struct Solid {
    SolidSide side = SolidSide::Automatic;
    /// The value of f without its restriction (engine/rewrite/surface_functions.hpp), if it has
    /// one: it tells the side where f itself is not defined.
    KernelFunction<ValueBatchOf<float>> unrestricted = {};
};

/// A surface of a scene: the code of its formula, and how it is shown.
struct Surface {
    Kernel kernel;
    std::optional<SurfaceColors> colors = std::nullopt;  ///< none: the palette's for its place
    SurfaceLook look = {};
    Solid solid = {};
    /// The function that it is a level of (engine/rewrite/surface_functions.hpp), which sections
    /// show the values of; none: f.
    PointFunction section_value = {};
    /// Where in the clip box it may be, for its tracer; nullptr: not known. For the scene's
    /// uniforms, and without jumps only if there are none.
    std::shared_ptr<const OpenSpace> open_space = nullptr;
};

/// Whether both lists are of the same code.
bool have_same_code(const std::vector<Surface>& a, const std::vector<Surface>& b);

/// A scene: its surfaces, the clip box with what is shown of it, and the uniforms' values, which
/// all surfaces share. A value: copy it as a snapshot for a job.
struct Scene {
    std::vector<Surface> surfaces;  ///< at most max_surfaces
    Box clip;
    Uniforms uniforms;
    Region region = {};
    Coloring coloring = {};  ///< over the surfaces' colours; with a range where one is needed
    Lighting lighting = {};
    Background background = {};
    /// Whether places are drawn, too, where f changes its sign in a jump
    /// (engine/algebra/switches.hpp). By the tracer of beams.
    bool jumps = false;
    std::optional<SectionValues> section_values = std::nullopt;  ///< where sections show values

    [[nodiscard]] const SurfaceColors& colors_of_surface(std::size_t surface) const {
        const auto& own = surfaces[surface].colors;
        return own ? *own : colors_of(surface);
    }
};

Look look_of(const Scene& scene, std::size_t surface);

/// Whether light comes from many directions: from broad lights, or into the hollows of a look that
/// darkens them.
bool has_soft_light(const Scene& scene);
/// Whether it does for this surface.
bool has_soft_light(const Scene& scene, std::size_t surface);

}  // namespace zeroset
