#pragma once

#include "app/gallery/thumbnail_cache.hpp"
#include "document/document.hpp"
#include "engine/image/rgba_image.hpp"
#include "engine/render/render_request.hpp"

#include <glm/ext/vector_int2.hpp>

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace zeroset {

/// A finished picture of an item; transparent where no surface is hit.
struct Thumbnail {
    std::size_t item = 0;  ///< index in what is drawn: gallery(), for example
    RgbaImage image;
};

/// Draws an item's picture; nothing if it was cancelled meanwhile. Called from a job's thread.
using DrawThumbnail = std::function<std::optional<RgbaImage>(std::size_t item, glm::ivec2 size_px,
                                                             const std::atomic<bool>& cancel)>;

/// Draws items of the gallery; pictures drawn before come from the cache.
DrawThumbnail gallery_thumbnails(ThumbnailCache cache);
/// A document's picture; empty where its rows name files, which are of its own folder and may be
/// large. Nothing if it was cancelled meanwhile.
std::optional<RgbaImage> document_thumbnail(const Document& document, glm::ivec2 size_px,
                                            const ThumbnailCache& cache,
                                            const std::atomic<bool>& cancel);

/// A picture of the request in half its width and height.
std::optional<RgbaImage> thumbnail_of(const RenderRequest& request,
                                      const std::atomic<bool>& cancel);
/// The settings of such pictures.
TraceSettings thumbnail_settings();

/// Draws small pictures in the background, on one thread. The UI thread may call all members; none
/// waits for a picture.
class ThumbnailJob {
public:
    enum class Priority : std::uint8_t { Usual, Low };

    /// Calls `on_picture` from the job's thread after each picture.
    ThumbnailJob(DrawThumbnail draw, Priority priority, std::function<void()> on_picture);
    ~ThumbnailJob();
    ThumbnailJob(const ThumbnailJob&) = delete;
    ThumbnailJob& operator=(const ThumbnailJob&) = delete;

    /// Sets the pictures to draw, in this order, in place of those wanted before.
    void want(std::vector<std::size_t> items, glm::ivec2 size_px);
    /// While `held`, nothing is drawn; a picture that was begun is given up and begun again later.
    void hold(bool held);
    /// Returns the pictures finished since the last call.
    std::vector<Thumbnail> take();
    /// True while a wanted picture is unfinished or a finished one is not taken.
    [[nodiscard]] bool busy() const;

private:
    struct Work {
        std::size_t item;
        glm::ivec2 size_px;
        unsigned round;
    };

    void run();
    std::optional<Work> wait_for_work();
    void finish(const Work& work, std::optional<RgbaImage> image);

    DrawThumbnail draw_;
    std::function<void()> on_picture_;
    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<std::size_t> wanted_;  ///< the first is being drawn or is next
    glm::ivec2 size_px_{0};
    unsigned round_ = 0;  ///< counts what was cancelled
    std::vector<Thumbnail> finished_;
    bool held_ = false;
    bool stop_ = false;
    std::atomic<bool> cancel_{false};
    std::thread thread_;
};

/// All that the picture of a gallery item depends on, as a text.
std::string thumbnail_key(std::size_t item, glm::ivec2 size_px);

}  // namespace zeroset
