#pragma once

#include "app/desktop/thumbnail_cache.hpp"
#include "engine/image/rgba_image.hpp"

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

/// A finished picture of a surface of the gallery; transparent where it is not hit.
struct Thumbnail {
    std::size_t item = 0;  ///< its place in gallery()
    RgbaImage image;
};

/// Draws small pictures of the gallery's surfaces in the background, on one thread; what was drawn
/// once comes from the cache. All members may be called from the UI thread; none waits for a
/// picture.
class ThumbnailJob {
public:
    enum class Priority : std::uint8_t { Usual, Low };

    /// `on_picture` is called from the job's thread after each picture.
    ThumbnailJob(ThumbnailCache cache, Priority priority, std::function<void()> on_picture);
    ~ThumbnailJob();
    ThumbnailJob(const ThumbnailJob&) = delete;
    ThumbnailJob& operator=(const ThumbnailJob&) = delete;

    /// These are to be drawn, the first first, in place of those wanted before.
    void want(std::vector<std::size_t> items, glm::ivec2 size_px);
    /// While `held`, nothing is drawn: what was begun is given up and begun again.
    void hold(bool held);
    /// The pictures that were finished since.
    std::vector<Thumbnail> take();
    /// Whether something wanted is not finished and taken.
    [[nodiscard]] bool busy() const;

private:
    struct Work {
        std::size_t item;
        glm::ivec2 size_px;
    };

    void run();
    std::optional<Work> wait_for_work();
    /// Nothing when it was cancelled.
    std::optional<RgbaImage> picture_of(const Work& work) const;
    void finish(const Work& work, std::optional<RgbaImage> image);

    ThumbnailCache cache_;
    std::function<void()> on_picture_;
    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<std::size_t> wanted_;  ///< the first is being drawn or will be next
    glm::ivec2 size_px_{0};
    std::vector<Thumbnail> finished_;
    bool held_ = false;
    bool stop_ = false;
    std::atomic<bool> cancel_{false};
    std::thread thread_;
};

/// All that the picture of a gallery's item depends on, as a text.
std::string thumbnail_key(std::size_t item, glm::ivec2 size_px);

}  // namespace zeroset
