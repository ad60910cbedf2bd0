#pragma once

#include "app/cli/options/options.hpp"

#include <optional>
#include <string>
#include <vector>

// The subcommands of `zeroset dev`, as those of app/cli/commands.hpp.

namespace zeroset {

/// Times frames of a suite of surfaces.
struct BenchCommand {
    std::optional<std::string> suite, tracers, threads, d_stop, levels, size, repeat, budget, json;
    bool shadows = false, antialias = false;  ///< antialias: the same as an `aa`
    std::optional<std::string> aa;            ///< as read_antialias reads it
    LightText light;                          ///< the look and the mirrors; no other
    bool first_picture = false;               ///< times edits instead of frames
};
int run_bench(const BenchCommand& command);

/// Draws the window with its finished picture into a file; needs no display.
struct UiShotCommand {
    std::string equation;
    ViewText view;
    TraceText trace;
    std::string size = "1280x800";
    std::string scale = "1";
    std::string theme = "dark";
    std::string language = "en";
    std::string output;
    std::optional<std::string> pointer;
    bool mark_undecided = false;
    std::vector<std::string> actions;  ///< names of actions to be run first
};
int run_ui_shot(const UiShotCommand& command);

/// Opens the window and writes how long each input took to change the picture (LatencyLog).
struct LatencyCommand {
    std::string equation;
    ViewText view;
    TraceText trace;
    std::string output;
};
int run_latency(const LatencyCommand& command);

}  // namespace zeroset
