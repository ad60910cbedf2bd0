#pragma once

#include "document/document.hpp"
#include "engine/render/render_job.hpp"
#include "engine/scene/scene.hpp"
#include "engine/view/camera.hpp"
#include "pipeline/color_formulas.hpp"
#include "pipeline/formula.hpp"

#include <glm/ext/vector_int2.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace zeroset {

/// A surface of a program that a picture shows.
struct ShownSurface {
    std::size_t index = 0;               ///< among the program's surfaces
    int row = 0;                         ///< id of its row in the document
    std::optional<std::uint32_t> color;  ///< 0xRRGGBB of its front; none: the palette's
    SolidSide solid = SolidSide::Automatic;

    bool operator==(const ShownSurface&) const = default;
};

/// Everything that a picture of a document depends on, as values: equal requests give equal
/// pictures. Made by picture_request; the window, `render`, `bench` and the thumbnails all draw
/// what it says.
struct PictureRequest {
    std::shared_ptr<const Formula> formula;
    std::shared_ptr<const ColorFormulas> colors;  ///< for the formula and `coloring`
    Box clip;
    Region region;
    Camera camera;
    ColorChoice coloring;
    bool jumps = false;
    TraceSettings settings;
    glm::ivec2 size_px{0};
    std::vector<ShownSurface> surfaces;
    std::vector<double> uniforms;  ///< w (0 where the formula has none), then the parameters

    bool operator==(const PictureRequest&) const = default;
};

/// The picture of a document, by a formula of its rows. Shadows and antialiasing are the
/// document's, the rest of the settings is that of `settings`.
PictureRequest picture_request(std::shared_ptr<const Formula> formula,
                               std::shared_ptr<const ColorFormulas> colors,
                               const Document& document, const TraceSettings& settings,
                               glm::ivec2 size_px);

/// The camera of a document: its own, or the default one for a picture of this size.
Camera camera_of(const Document& document, glm::ivec2 size_px);

/// True if `next` is the picture `last` by other code, which was not there before.
bool differs_in_code_only(const PictureRequest& last, const PictureRequest& next);

/// Indices of the surfaces that are shown among those of the program.
std::vector<std::size_t> shown_indices(const PictureRequest& request);

/// The values that all surfaces share.
Uniforms uniforms_of(const PictureRequest& request);

/// The surfaces with their colours, as the engine draws them.
Scene scene_of(const PictureRequest& request);

/// The request as the engine takes it.
RenderRequest render_request(const PictureRequest& request);

/// True if the formula has code in the type that the picture needs.
bool has_code_for(const PictureRequest& request);

}  // namespace zeroset
