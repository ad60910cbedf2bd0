#pragma once

#include "app/cli/options/options.hpp"
#include "document/document.hpp"
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

}  // namespace zeroset
