#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/trace/camera.hpp"
#include "engine/trace/precision.hpp"
#include "engine/trace/scene.hpp"

#include <glm/ext/vector_int2.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace zeroset::ui {

enum class Theme : std::uint8_t { Dark, Light };

/// One line of the surface picker.
struct GalleryEntry {
    std::string title;
    std::string equation;
    std::string about;  ///< one sentence
};

/// How one statement of the text was understood, one line.
struct Reading {
    std::string text;
    std::optional<std::uint32_t> color;  ///< of a surface's front, as in Framebuffer::color
};

/// A name that the text leaves open, chosen with a slider. Finite, lo < hi.
struct ParameterSlider {
    std::string name;
    double value = 1;
    double lo = -5;  ///< ends of the slider; a number typed beyond them moves them
    double hi = 5;
};

/// One line of the help: what to type, and what it does.
struct HelpEntry {
    std::string typed;
    std::string meaning;
};

struct HelpSection {
    std::string title;
    std::vector<HelpEntry> entries;
};

/// What the status line says of the picture. The figures are those of the last full picture.
struct PictureStatus {
    bool tracing = false;  ///< a finer picture than the one shown is on its way
    int width_px = 0;      ///< 0: no full picture yet
    int height_px = 0;
    double frame_ms = 0.0;
    CertificateCounts counts;
    Precision precision = Precision::Float;
};

/// The picture that is shown, fine or coarse, and the camera that it was taken with; no frame
/// before the first.
struct ShownPicture {
    std::shared_ptr<const Framebuffer> frame;
    Camera camera;
};

/// Everything the panels show and edit. Plain data, used by the window's thread only.
struct UiState {
    // Edited by the panels.
    std::string equation;  ///< statements as typed, UTF-8, lines apart by '\n'
    Camera camera;
    Box clip;
    double w = 0.0;
    double w_lo = -2.0;  ///< ends of w's slider, as in ParameterSlider
    double w_hi = 2.0;
    std::vector<ParameterSlider> parameters;  ///< the owner chooses the names
    StopCriterion stop;
    Theme theme = Theme::Dark;
    bool mark_undecided = false;  ///< tint the pixels of which too little is proved
    bool show_help = false;
    std::string help_filter;

    // Wishes: set by a panel, cleared by whoever fulfils them.
    bool focus_equation = true;          ///< with all of it selected; by the equation panel
    bool reset_view = false;             ///< fulfilled by the owner, which knows the first view
    std::optional<std::size_t> surface;  ///< a line of `gallery` was picked

    // Shown by the panels, set by the owner.
    std::vector<GalleryEntry> gallery;
    std::vector<HelpSection> language_help;
    std::vector<Reading> readings;  ///< of the last good text
    std::string error;              ///< why `equation` cannot be drawn; empty: it can
    /// Where in `equation` the error is, in bytes; its size: after the last character.
    std::optional<std::size_t> error_at;
    bool unfinished = false;  ///< `error` only says what is still to be typed
    std::string note;         ///< for the status line: what is not as it should be; or empty
    bool uses_w = false;
    PictureStatus picture;
    ShownPicture shown;

    /// Size of the area the picture fills, framebuffer pixels; set by draw_viewport.
    glm::ivec2 viewport_px{0};
};

}  // namespace zeroset::ui
