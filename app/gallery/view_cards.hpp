#pragma once

#include "app/gallery/thumbnail_job.hpp"
#include "engine/render/render_request.hpp"
#include "engine/view/camera.hpp"
#include "pipeline/picture_request.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/window/texture.hpp"

#include <glm/ext/vector_int2.hpp>

#include <cstddef>
#include <functional>
#include <list>
#include <mutex>
#include <optional>
#include <vector>

namespace zeroset {

/// A picture of the request, as small as wanted, as it is seen by a camera.
RenderRequest view_picture(PictureRequest request, const Camera& camera, glm::ivec2 size_px);

/// Pictures of what the window draws as saved views show it: drawn while their cards are in sight
/// and the large picture is at rest, and uploaded. The window's thread only.
class ViewCards {
public:
    /// `priority`: Low if somebody works meanwhile. `wake` is called from another thread after each
    /// picture.
    ViewCards(ThumbnailJob::Priority priority, std::function<void()> wake);

    /// Hands the finished pictures to the panels; to be called before they are drawn.
    void show(ui::UiState& state);
    /// Asks for the pictures that the panels lack; to be called after they were drawn. `shown`: the
    /// large picture's request; nullptr while a newer one is on its way.
    void follow(ui::UiState& state, const PictureRequest* shown);
    [[nodiscard]] bool settled() const { return !job_.busy(); }

private:
    /// A finished picture. It stays on its card until the next one of the same view is there.
    struct Picture {
        Camera camera;
        ui::Texture texture;
        bool fresh = false;  ///< it is of `drawn_`
    };

    void begin(PictureRequest request, const ui::ViewPictureWish& wish);
    void tell(ui::UiState& state) const;
    /// The number of a camera among those that are drawn.
    std::size_t number_of(const Camera& camera);

    std::mutex mutex_;
    std::optional<PictureRequest> drawn_;  ///< without its camera; guarded by the mutex
    std::vector<Camera> cameras_;          ///< by number; guarded by the mutex
    std::list<Picture> pictures_;
    glm::ivec2 size_px_{0};
    ThumbnailJob job_;  // ends before what its thread reads
};

}  // namespace zeroset
