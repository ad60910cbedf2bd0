#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/trace/precision.hpp"
#include "engine/trace/scene.hpp"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace zeroset {

/// Everything one picture depends on; a snapshot.
struct RenderRequest {
    Scene scene;
    Camera camera;
    TraceSettings settings;
    int width = 0;  ///< of the full picture, pixels
    int height = 0;
};

/// A finished pass. Coarse passes have smaller frames that are shown stretched.
struct RenderResult {
    std::shared_ptr<const Framebuffer> frame;
    std::uint64_t request = 0;  ///< what submit() returned
    int coarseness = 1;         ///< pixels of the full picture per pixel of the frame; 1: final
    double frame_ms = 0.0;
    CertificateCounts counts;
    Camera camera;
    Precision precision = Precision::Float;
};

/// Renders the newest request in the background, coarse passes first. All members may be called
/// from the UI thread; none waits for a frame.
class RenderJob {
public:
    /// `on_frame` is called from the job's thread after each finished pass.
    explicit RenderJob(std::function<void()> on_frame);
    ~RenderJob();
    RenderJob(const RenderJob&) = delete;
    RenderJob& operator=(const RenderJob&) = delete;

    /// Cancels the pass in flight and starts on `request`. Returns its number.
    std::uint64_t submit(RenderRequest request);
    /// The newest finished pass not yet taken, or nothing.
    std::optional<RenderResult> take();
    /// Whether a request is waiting or being drawn.
    [[nodiscard]] bool busy() const;

private:
    void run();
    void draw(const RenderRequest& request, std::uint64_t number);

    std::function<void()> on_frame_;
    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<RenderRequest> pending_;
    std::optional<RenderResult> finished_;
    std::uint64_t newest_ = 0;
    bool drawing_ = false;
    bool stop_ = false;
    std::atomic<bool> cancel_{false};
    std::thread thread_;
};

}  // namespace zeroset
