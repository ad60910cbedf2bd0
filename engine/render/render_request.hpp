#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/scene/precision.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/settings.hpp"
#include "engine/view/camera.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace zeroset {

/// Everything one picture depends on; a snapshot.
struct RenderRequest {
    Scene scene;
    Camera camera;
    TraceSettings settings;
    int width = 0;  ///< of the full picture, pixels
    int height = 0;
    /// Quicker code is on its way, with which the picture will be asked for again: where the full
    /// one takes long, only first pictures are drawn.
    bool preview = false;
    /// The picture of the request before, by other code: it follows no motion.
    bool again = false;

    [[nodiscard]] std::size_t pixels() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
};

/// A picture as far as it has come. It is smaller than the full one, to be shown stretched, or as
/// large.
struct RenderResult {
    std::shared_ptr<const Framebuffer> frame;
    std::uint64_t request = 0;  ///< what RenderJob::submit returned
    bool complete = false;      ///< the full picture, to its last pixel
    double frame_ms = 0.0;      ///< that tracing it has taken so far
    CertificateCounts counts;   ///< of a complete one
    Camera camera;
    Precision precision = Precision::Float;
    Coloring coloring = {};  ///< with the range that was found, if there is one
    std::optional<SectionValues> section_values = {};  ///< the scene's
    Uniforms uniforms = {};                            ///< of the scene
};

}  // namespace zeroset
