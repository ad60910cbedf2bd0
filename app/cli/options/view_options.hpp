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

/// Whether an option chooses the camera, or a part of it.
bool chooses_camera(const ViewText& view);

/// Changes the document's camera by the view options for it.
[[nodiscard]] std::optional<InputError> take_camera(const ViewText& view, Document& document);

/// Where no option has chosen the camera, fits the document's own to a picture of this aspect
/// (width / height): one of the gallery to a clip box that is drawn, others as the window does.
void fit_camera(const ViewText& view, bool stored, double aspect, Document& document);

/// Whether the input is a text of whose clip box and camera nobody has chosen anything.
bool has_free_view(const InputDocument& input, const ViewText& view);

/// One line for stderr on what fit_by_itself did, from what it returned.
std::string fitted_note(const std::string& note);

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
