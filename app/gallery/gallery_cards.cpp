#include "app/gallery/gallery_cards.hpp"

#include "app/platform/folders.hpp"
#include "pipeline/gallery.hpp"

#include <atomic>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

std::optional<std::filesystem::path> folder_for(bool keeps_files) {
    const auto cache = keeps_files ? cache_folder() : std::nullopt;
    if (!cache) return std::nullopt;
    return *cache / "thumbnails";
}

/// The statements of a document, a line each.
std::string rows_text(const Document& document) {
    std::string text;
    for (const Statement& statement : document.statements)
        text += (text.empty() ? "" : "\n") + statement.text;
    return text;
}

}  // namespace

/// The documents by their numbers after the gallery's. Both threads.
struct GalleryCards::Browsed {
    std::mutex mutex;
    std::vector<std::shared_ptr<const Document>> documents;

    std::shared_ptr<const Document> document(std::size_t item) {
        const std::scoped_lock lock(mutex);
        const std::size_t index = item - gallery().size();
        return index < documents.size() ? documents[index] : nullptr;
    }
};

GalleryCards::GalleryCards(bool keeps_files, std::function<void()> wake)
    : browsed_(std::make_shared<Browsed>()),
      job_(
          [browsed = browsed_, cache = ThumbnailCache(folder_for(keeps_files)),
           draw = gallery_thumbnails(ThumbnailCache(folder_for(keeps_files)))](
              std::size_t item, glm::ivec2 size_px,
              const std::atomic<bool>& cancel) -> std::optional<RgbaImage> {
              if (item < gallery().size()) return draw(item, size_px, cancel);
              const auto document = browsed->document(item);
              if (!document) return std::nullopt;
              return document_thumbnail(*document, size_px, cache, cancel);
          },
          keeps_files ? ThumbnailJob::Priority::Low : ThumbnailJob::Priority::Usual,
          std::move(wake)) {}

void GalleryCards::browse(Collection collection, ui::UiState& state) {
    std::vector<ui::GalleryEntry>& entries = state.shown.gallery;
    entries.resize(gallery().size());
    std::vector<std::shared_ptr<const Document>> documents;
    for (CollectionItem& item : collection.items) {
        entries.push_back({.title = std::move(item.title),
                           .equation = rows_text(item.document),
                           .about = std::move(item.about),
                           .group = collection.name,
                           .source = item.path,
                           .path = item.path});
        documents.push_back(std::make_shared<const Document>(std::move(item.document)));
    }
    job_.want({}, size_px_);
    (void)job_.take();  // they have the numbers of the last collection
    {
        const std::scoped_lock lock(browsed_->mutex);
        browsed_->documents = std::move(documents);
    }
    std::erase_if(textures_, [](const auto& entry) { return entry.first >= gallery().size(); });
    std::erase_if(state.shown.thumbnails,
                  [](const auto& entry) { return entry.first >= gallery().size(); });
    ui::GalleryPage& page = state.pages.gallery;
    page.open = true;
    page.search.clear();
    page.selected = gallery().size();
    page.follow = true;
}

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
