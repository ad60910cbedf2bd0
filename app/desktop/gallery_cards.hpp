#pragma once

#include "app/desktop/thumbnail_job.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/window/texture.hpp"

#include <cstddef>
#include <functional>
#include <map>

namespace zeroset {

/// The pictures of the gallery's page: those of the cards in sight are drawn, while the large
/// picture is at rest, and uploaded. The window's thread only.
class GalleryCards {
public:
    /// `keeps_files`: pictures are kept from session to session, and drawn at a low priority, as
    /// somebody works meanwhile. `wake` is called from another thread after each picture.
    GalleryCards(bool keeps_files, std::function<void()> wake);

    /// Before the panels are drawn: hands them what was finished.
    void show(ui::UiState& state);
    /// After they were drawn: asks for what they lack.
    void follow(const ui::UiState& state);
    [[nodiscard]] bool settled() const { return !job_.busy(); }

private:
    ThumbnailJob job_;
    std::map<std::size_t, ui::Texture> textures_;
    glm::ivec2 size_px_{0};  ///< of the textures
};

}  // namespace zeroset
