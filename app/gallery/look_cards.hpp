#pragma once

#include "app/gallery/thumbnail_job.hpp"
#include "engine/scene/lighting.hpp"
#include "pipeline/picture_request.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/window/texture.hpp"

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

namespace zeroset {

/// A picture of the request, as small as wanted, in one of looks(): how that would look.
RenderRequest look_picture(PictureRequest request, std::size_t look, glm::ivec2 size_px);

/// Pictures of what the window draws in each look, to choose one by: drawn while they are to be
/// chosen from and the large picture is at rest, and uploaded. The window's thread only.
class LookCards {
public:
    /// `priority`: Low if somebody works meanwhile. `wake` is called from another thread after each
    /// picture.
    LookCards(ThumbnailJob::Priority priority, std::function<void()> wake);

    /// Hands the finished pictures to the panels; to be called before they are drawn.
    void show(ui::UiState& state);
    /// Asks for the pictures that the panels lack; to be called after they were drawn. `shown`: the
    /// large picture's request; nullptr while a newer one is on its way.
    void follow(ui::UiState& state, const PictureRequest* shown);
    [[nodiscard]] bool settled() const { return !job_.busy(); }

private:
    std::mutex mutex_;
    std::optional<PictureRequest> drawn_;  ///< guarded by the mutex
    std::map<Look, ui::Texture> textures_;
    glm::ivec2 size_px_{0};
    ThumbnailJob job_;  // ends before what its thread reads
};

}  // namespace zeroset
