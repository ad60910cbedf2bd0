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
    /// The value of f without its restriction (engine/rewrite/unrestricted.hpp), if it has one: it
    /// tells the side where f itself is not defined.
    KernelFunction<ValueBatchOf<float>> unrestricted = {};
};

/// A scene: the code of each surface's formula, the clip box with what is shown of it, and
/// the uniforms' values, which all surfaces share. A value: copy it as a snapshot for a job.
struct Scene {
    std::vector<Kernel> surfaces;  ///< at most max_surfaces
    Box clip;
    Uniforms uniforms;
    std::vector<SurfaceColors> colors = {};  ///< of the surfaces; the palette's of those beyond
    std::vector<Solid> solids = {};          ///< of the surfaces; that of those beyond is Solid()
    Region region = {};
    Coloring coloring = {};  ///< over `colors`; with a range where one is needed
    Lighting lighting = {};
    Background background = {};
    /// Whether places are drawn, too, where f changes its sign in a jump
    /// (engine/algebra/switches.hpp). By the tracer of beams.
    bool jumps = false;
    /// Where in the clip box each surface may be, for its tracer; nullptr, or none: not known. For
    /// these uniforms, and without jumps only if there are none.
    std::vector<std::shared_ptr<const OpenSpace>> open_space = {};
    std::optional<SectionValues> section_values = std::nullopt;  ///< where sections show values

    [[nodiscard]] const SurfaceColors& colors_of_surface(std::size_t surface) const {
        return surface < colors.size() ? colors[surface] : colors_of(surface);
    }
};

}  // namespace zeroset
