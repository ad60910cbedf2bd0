#pragma once

#include "app/cli/options/options.hpp"
#include "document/document.hpp"
#include "document/look.hpp"
#include "engine/scene/region.hpp"
#include "engine/view/camera.hpp"
#include "pipeline/input_error.hpp"

#include <optional>
#include <string>

namespace zeroset {

/// Reads the text of camera_text; what it leaves out is as in `base`. `option` names it in errors.
OrInputError<Camera> read_camera(const std::string& option, const std::string& text,
                                 const Camera& base);

/// The camera of the view with this name, or which views there are.
OrInputError<Camera> saved_camera(const std::string& option, const std::string& name,
                                  const Document& document);

/// Changes the document's camera by the view options for it.
[[nodiscard]] std::optional<InputError> take_camera(const ViewText& view, Document& document);

/// Applies the view options to the region `base`. For a section without a side, the side away from
/// `eye` is kept.
OrInputError<Region> read_region(const ViewText& view, const Region& base, const glm::dvec3& eye);

/// Reads the box that an option gives: L for [-L, L]^3, or x0,x1,y0,y1,z0,z1.
OrInputError<Box> read_box(const std::string& option, const std::string& text);

/// Reads --aspect: auto, or lengths in the picture for one unit along x, y and z, as 1:1:0.01.
OrInputError<std::optional<glm::dvec3>> read_aspect(const std::string& text);

/// Applies the options of what sections show to those of the region and to the values' choice.
std::optional<InputError> read_section_looks(const ViewText& view, Region& region,
                                             SectionChoice& values);

}  // namespace zeroset
