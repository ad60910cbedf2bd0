#pragma once

#include "app/cli/options/drawing_options.hpp"
#include "app/cli/options/options.hpp"

#include <optional>
#include <string>
#include <vector>

// The subcommands. Each returns the process's exit code: 0, 2 for wrong input, 1 for an error at
// run time. Errors go to stderr as one line; an error in a formula is followed by a caret below its
// text.

namespace zeroset {

struct RenderCommand {
    std::string equation;
    ViewText view;
    TraceText trace;
    std::string size = "1024x1024";
    std::optional<std::string> output, depth, certificate, cost, stats, repeat, budget;
    std::optional<std::string> bits, dpi, quality;  ///< of the picture in `output`
    bool no_session = false;                        ///< the picture does not hold the session
    std::vector<std::string> probes;                ///< COL,ROW each
    bool no_legend = false;
    bool alpha = false;  ///< the picture's background is transparent
};
int run_render(const RenderCommand& command);

/// Draws a film, or numbered frames.
struct FilmCommand {
    std::string equation;
    ViewText view;
    TraceText trace;
    std::string output;
    std::string size = "1280x720";
    std::optional<std::string> frames, seconds, fps, turn, axis, end, ease, blur, shutter, quality,
        bits, budget, stats, frame_range;
    std::vector<std::string> sweeps;     ///< NAME=FROM..TO
    std::vector<std::string> waypoints;  ///< names of saved views, or as read_camera reads them
    bool through_views = false;          ///< the way leads through all saved views
    bool turntable = false;              ///< a full turn, unless another is asked for
    bool alpha = false, resume = false, no_legend = false;
};
int run_film(const FilmCommand& command);

/// Prints the session as one line of text.
struct ShareCommand {
    std::string equation;
    ViewText view;
    TraceText trace;
};
int run_share(const ShareCommand& command);

/// Writes a function's values on a grid.
struct SampleCommand {
    std::string equation, output;
    std::string size = "128";
    std::optional<std::string> box, w, surface, tolerance;
    std::vector<std::string> set;
    bool distance = false;  ///< not f, but how far its zeros are
};
int run_sample(const SampleCommand& command);

struct MeshCommand {
    std::string equation;
    ViewText view;
    std::string output;
    std::optional<std::string> tolerance, size, triangles, wall, surface, depth, budget, stats,
        threads;
    bool open = false;      ///< the surface alone
    bool no_thin = false;   ///< all triangles, as they were proved
    bool implicit = false;  ///< the formula itself, as 3MF's implicit functions
};
int run_mesh(const MeshCommand& command);

struct DrawCommand {
    std::string equation;
    ViewText view;
    TraceText trace;  ///< of axes, clip box and grid alone
    DrawingText drawing;
    std::optional<std::string> output, stats, budget;
};
int run_draw(const DrawCommand& command);

struct ExplainCommand {
    std::string equation;
    std::optional<std::string> at;
    std::vector<std::string> set;  ///< NAME=VALUE of parameters
    bool ir = false, assembly = false, json = false;
};
int run_explain(const ExplainCommand& command);

/// Brings other programs' files into a folder of sessions with pictures.
struct ImportCommand {
    std::vector<std::string> files;
    std::string folder;
    std::string size = "320x320";
    std::optional<std::string> budget, json;
    bool no_pictures = false;
};
int run_import(const ImportCommand& command);

struct GalleryCommand {
    bool names = false;
    bool json = false;
};
int run_gallery(const GalleryCommand& command);

/// Prints the page of the formula language as Markdown.
int run_language();

}  // namespace zeroset
