#pragma once

#include "engine/scene/scene.hpp"
#include "engine/scene/settings.hpp"
#include "engine/view/camera.hpp"
#include "papers/commands/paper_commands.hpp"
#include "pipeline/input_error.hpp"

#include <optional>
#include <string_view>

namespace zeroset {

/// A scene of a paper that is no row of a table: a text in [-domain, domain]^3, seen from the
/// suite's direction, as a square.
struct ComparedScene {
    Scene scene;
    Camera camera;
};

/// The options that comparisons of one scene have, read.
struct ComparedSettings {
    TraceSettings settings;
    int size_px = 0;
};

/// Refuses the options that tables alone have; `what`: what it is that is no table. The usual
/// d_stop and size where none is typed.
OrInputError<ComparedSettings> read_compared_settings(const CompareCommand& command,
                                                      std::string_view what, const char* d_stop,
                                                      int size_px);

/// Compiles the scene.
OrInputError<ComparedScene> compared_scene(std::string_view formula, double domain,
                                           const ComparedSettings& settings);

}  // namespace zeroset
