#pragma once

#include "document/document.hpp"
#include "engine/render/render_request.hpp"
#include "engine/scene/scene.hpp"
#include "engine/view/camera.hpp"
#include "pipeline/color_formulas.hpp"
#include "pipeline/formula.hpp"

#include <glm/ext/vector_int2.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// One of a program's surfaces that a picture shows.
struct ShownSurface {
    std::size_t index = 0;               ///< index among the program's surfaces
    int row = 0;                         ///< id of its row in the document
    std::optional<std::uint32_t> color;  ///< front colour, 0xRRGGBB; none: the palette's
    SolidSide solid = SolidSide::Automatic;
    SurfaceLook look = {};
    /// The thickness of a curve or a point; none: as suits the clip box.
    std::optional<Thickness> thickness = std::nullopt;

    bool operator==(const ShownSurface&) const = default;
};

/// Everything that a picture of a document depends on, as values: equal requests give equal
/// pictures. Made by picture_request for the window, `render`, `bench` and the thumbnails alike.
struct PictureRequest {
    std::shared_ptr<const Formula> formula;
    std::shared_ptr<const ColorFormulas> colors;  ///< made for the formula and `coloring`
    Box clip;
    Region region;
    Camera camera;  ///< of the formula's stretch
    ColorChoice coloring;
    SectionChoice section_values;
    LightChoice light;
    bool jumps = false;
    TraceSettings settings;
    glm::ivec2 size_px{0};
    std::vector<ShownSurface> surfaces;
    std::vector<double> uniforms;  ///< w (0 where the formula has none), then the parameters

    bool operator==(const PictureRequest&) const = default;
};

/// Makes the request for a picture of the document. `formula`: made from the document's rows.
/// Shadows, antialiasing and mirrors come from the document, all other settings from `settings`.
PictureRequest picture_request(std::shared_ptr<const Formula> formula,
                               std::shared_ptr<const ColorFormulas> colors,
                               const Document& document, const TraceSettings& settings,
                               glm::ivec2 size_px);

/// The document's own camera, or the default one for a picture of this size.
Camera camera_of(const Document& document, glm::ivec2 size_px);

/// True if `next` is the same picture as `last`, drawn by code that was not there before.
bool differs_in_code_only(const PictureRequest& last, const PictureRequest& next);

/// Indices, among the program's surfaces, of those that the picture shows.
std::vector<std::size_t> shown_indices(const PictureRequest& request);

/// The request's uniforms, then how thick curves and points are for its camera and size.
std::vector<double> uniform_values(const PictureRequest& request);

/// The uniforms shared by all surfaces.
Uniforms uniforms_of(const PictureRequest& request);

/// Converts the surfaces and their colours to the engine's scene, which is in the drawn world.
Scene scene_of(const PictureRequest& request);

/// Converts the request to the engine's.
RenderRequest render_request(const PictureRequest& request);

/// True if the formula has code in the precision that the picture needs.
bool has_code_for(const PictureRequest& request);

/// Gives the formula code in double where the picture needs it and there is none. May take long.
void add_needed_code(PictureRequest& request);

/// Why a tracer cannot draw the surfaces that a picture shows, and what to choose instead: one line
/// in the user's language that begins with `name`. Nothing: it can.
std::optional<std::string> tracer_refusal(std::string_view tracer, std::string_view name,
                                          const PictureRequest& request);

}  // namespace zeroset
