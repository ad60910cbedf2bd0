#include "app/gallery/look_cards.hpp"

#include <atomic>
#include <cstddef>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// The request without what makes no other picture of the looks.
PictureRequest without_look(PictureRequest request) {
    request.light.look = Look::Standard;
    request.size_px = {};
    return request;
}

}  // namespace

RenderRequest look_picture(PictureRequest request, std::size_t look, glm::ivec2 size_px) {
    const StopCriterion stop = request.settings.stop;
    request.settings = thumbnail_settings();
    request.settings.stop = stop;  // for which there is code
    request.settings.reflections = request.light.reflections;
    request.light.look = looks()[look];
    request.size_px = 2 * size_px;
    return render_request(request);
}

LookCards::LookCards(ThumbnailJob::Priority priority, std::function<void()> wake)
    : job_(
          [this](std::size_t look, glm::ivec2 size_px, const std::atomic<bool>& cancel) {
              std::optional<PictureRequest> request;
              {
                  const std::scoped_lock lock(mutex_);
                  request = drawn_;
              }
              return thumbnail_of(look_picture(std::move(*request), look, size_px), cancel);
          },
          priority, std::move(wake)) {}

void LookCards::show(ui::UiState& state) {
    for (const Thumbnail& thumbnail : job_.take()) {
        const Look look = looks()[thumbnail.item];
        ui::Texture& texture = textures_[look];
        texture.upload(thumbnail.image);
        state.shown.look_pictures[look] = texture.name();
    }
}

void LookCards::follow(ui::UiState& state, const PictureRequest* shown) {
    const auto size_px = std::exchange(state.wishes.look_pictures_px, std::nullopt);
    job_.hold(state.shown.picture.tracing);
    if (!size_px || shown == nullptr) return job_.want({}, size_px_);
    PictureRequest request = without_look(*shown);
    if (request != drawn_ || *size_px != size_px_) {
        job_.want({}, *size_px);
        (void)job_.take();
        textures_.clear();
        state.shown.look_pictures.clear();
        size_px_ = *size_px;
        const std::scoped_lock lock(mutex_);
        drawn_ = std::move(request);
    }
    std::vector<std::size_t> missing;
    for (std::size_t look = 0; look < looks().size(); ++look) {
        if (!textures_.contains(looks()[look])) missing.push_back(look);
    }
    job_.want(std::move(missing), *size_px);
}

}  // namespace zeroset
