#pragma once

#include "document/look.hpp"
#include "pipeline/input_error.hpp"

#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// Options for looks and lights, as typed; empty where an option was not given.
struct LightText {
    std::optional<std::string> look = {}, reflections = {}, absorption = {}, tone = {};
    std::optional<std::string> background = {};
    std::vector<std::string> lights = {};
};

/// Applies the options to `light`. Returns an error if one is wrong.
std::optional<InputError> take_light(const LightText& text, LightChoice& light);

/// The names of all looks as one text: "standard, ... or technical".
std::string look_words();

/// Reads the value of --background: "#RRGGBB", "#RRGGBB,#RRGGBB" from top to bottom; nothing for
/// "default".
OrInputError<std::optional<Background>> read_background(const std::string& text);

/// Reads the value of --light: X,Y,Z towards the light in world axes, or "camera X,Y,Z" to the
/// right, upwards and backwards as the camera is turned; then, each after a ";", "power P",
/// "size DEGREES" (across) and "color #RRGGBB".
OrInputError<Light> read_light(const std::string& text);

}  // namespace zeroset
