#pragma once

#include "pipeline/picture_request.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace zeroset {

/// Why a tracer cannot draw the surfaces that a picture shows, and what to choose instead: one line
/// in the user's language that begins with `name`. Nothing: it can.
std::optional<std::string> tracer_refusal(std::string_view tracer, std::string_view name,
                                          const PictureRequest& request);

}  // namespace zeroset
