#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/trace/camera.hpp"
#include "engine/trace/scene.hpp"

#include <glm/ext/vector_int2.hpp>

#include <cstddef>
#include <cstdint>
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

/// What the status line says of the picture. The figures are those of the last full picture.
struct PictureStatus {
    bool tracing = false;  ///< a finer picture than the one shown is on its way
    int width_px = 0;      ///< 0: no full picture yet
    int height_px = 0;
    double frame_ms = 0.0;
    CertificateCounts counts;
};

/// Everything the panels show and edit. Plain data, used by the window's thread only.
struct UiState {
    // Edited by the panels.
    std::string equation;  ///< as typed, UTF-8
    Camera camera;
    Box clip;
    double w = 0.0;
    StopCriterion stop;
    Theme theme = Theme::Dark;

    // Wishes: set by a panel, cleared by whoever fulfils them.
    bool focus_equation = true;          ///< fulfilled by the equation panel
    bool reset_view = false;             ///< fulfilled by the owner, which knows the first view
    std::optional<std::size_t> surface;  ///< a line of `gallery` was picked

    // Shown by the panels, set by the owner.
    std::vector<GalleryEntry> gallery;
    std::string reading;                      ///< how the shown formula was understood
    std::string error;                        ///< why `equation` cannot be drawn; empty: it can
    std::optional<std::size_t> error_column;  ///< place of the error, from 1, in characters
    bool uses_w = false;
    PictureStatus picture;

    /// Size of the area the picture fills, framebuffer pixels; set by draw_viewport.
    glm::ivec2 viewport_px{0};
};

}  // namespace zeroset::ui
