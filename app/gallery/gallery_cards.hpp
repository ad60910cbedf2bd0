#pragma once

#include "app/gallery/thumbnail_job.hpp"
#include "document/json/collection.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/window/texture.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>

namespace zeroset {

/// The gallery's page beyond its panels: its entries, and their pictures. Draws those of the cards
/// in sight, while the large picture is at rest, and uploads them. The window's thread only.
class GalleryCards {
    /// The documents of the collection, which the job draws.
    struct Browsed;

public:
    /// `keeps_files`: pictures are kept from session to session and drawn at a low priority,
    /// because somebody works meanwhile. `wake` is called from another thread after each picture.
    GalleryCards(bool keeps_files, std::function<void()> wake);

    /// Lists the collection's documents before the gallery, in place of those of another one, and
    /// opens the page.
    void browse(Collection collection, ui::UiState& state);
    /// Hands the finished pictures to the panels; to be called before they are drawn.
    void show(ui::UiState& state);
    /// Asks for the pictures that the panels lack; to be called after they were drawn.
    void follow(const ui::UiState& state);
    [[nodiscard]] bool settled() const { return !job_.busy(); }

private:
    std::shared_ptr<Browsed> browsed_;
    ThumbnailJob job_;
    std::map<std::size_t, ui::Texture> textures_;
    glm::ivec2 size_px_{0};  ///< size of the textures
};

}  // namespace zeroset
