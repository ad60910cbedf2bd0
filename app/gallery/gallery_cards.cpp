#include "app/gallery/gallery_cards.hpp"

#include "app/platform/folders.hpp"

#include <utility>
#include <vector>

namespace zeroset {
namespace {

std::optional<std::filesystem::path> folder_for(bool keeps_files) {
    const auto cache = keeps_files ? cache_folder() : std::nullopt;
    if (!cache) return std::nullopt;
    return *cache / "thumbnails";
}

}  // namespace

GalleryCards::GalleryCards(bool keeps_files, std::function<void()> wake)
    : job_(gallery_thumbnails(ThumbnailCache(folder_for(keeps_files))),
           keeps_files ? ThumbnailJob::Priority::Low : ThumbnailJob::Priority::Usual,
           std::move(wake)) {}

void GalleryCards::show(ui::UiState& state) {
    const bool open = state.pages.gallery.open;
    const glm::ivec2 wanted_px = state.wishes.thumbnails.size_px;
    if (!open || wanted_px != size_px_) {
        textures_.clear();
        state.shown.thumbnails.clear();
        size_px_ = wanted_px;
    }
    for (const Thumbnail& thumbnail : job_.take()) {
        const glm::ivec2 size(thumbnail.image.width, thumbnail.image.height);
        if (!open || size != size_px_) continue;
        ui::Texture& texture = textures_[thumbnail.item];
        texture.upload(thumbnail.image);
        state.shown.thumbnails[thumbnail.item] = texture.name();
    }
}

void GalleryCards::follow(const ui::UiState& state) {
    const ui::ThumbnailWish& wish = state.wishes.thumbnails;
    std::vector<std::size_t> missing;
    for (const std::size_t item : wish.items) {
        if (state.pages.gallery.open && !textures_.contains(item)) missing.push_back(item);
    }
    job_.want(std::move(missing), wish.size_px);
    job_.hold(state.shown.picture.tracing);
}

}  // namespace zeroset
