#include "app/gallery/view_cards.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

namespace zeroset {
namespace {

/// The request without what makes no other picture of the views.
PictureRequest without_camera(PictureRequest request) {
    request.camera = {};
    request.size_px = {};
    return request;
}

}  // namespace

RenderRequest view_picture(PictureRequest request, const Camera& camera, glm::ivec2 size_px) {
    const StopCriterion stop = request.settings.stop;
    request.settings = thumbnail_settings();
    request.settings.stop = stop;
    request.camera = camera;
    request.size_px = 2 * size_px;
    add_needed_code(request);
    return render_request(request);
}

ViewCards::ViewCards(ThumbnailJob::Priority priority, std::function<void()> wake)
    : job_(
          [this](std::size_t number, glm::ivec2 size_px,
                 const std::atomic<bool>& cancel) -> std::optional<RgbaImage> {
              std::optional<PictureRequest> request;
              Camera camera;
              {
                  const std::scoped_lock lock(mutex_);
                  // A request that has just begun knows no cameras of the one before.
                  if (number >= cameras_.size()) return std::nullopt;
                  request = drawn_;
                  camera = cameras_[number];
              }
              return thumbnail_of(view_picture(std::move(*request), camera, size_px), cancel);
          },
          priority, std::move(wake)) {}

void ViewCards::show(ui::UiState& state) {
    const std::vector<Thumbnail> finished = job_.take();
    for (const Thumbnail& thumbnail : finished) {
        const Camera& camera = cameras_.at(thumbnail.item);
        auto picture = std::ranges::find(pictures_, camera, &Picture::camera);
        if (picture == pictures_.end()) {
            picture = pictures_.emplace(pictures_.end());
            picture->camera = camera;
        }
        picture->texture.upload(thumbnail.image);
        picture->fresh = true;
    }
    if (!finished.empty()) tell(state);
}

void ViewCards::tell(ui::UiState& state) const {
    state.shown.view_pictures.clear();
    for (const Picture& picture : pictures_)
        state.shown.view_pictures.push_back(
            {.camera = picture.camera, .texture = picture.texture.name()});
}

void ViewCards::begin(PictureRequest request, const ui::ViewPictureWish& wish) {
    job_.want({}, wish.size_px);
    (void)job_.take();
    std::erase_if(pictures_, [&wish](const Picture& picture) {
        return std::ranges::find(wish.cameras, picture.camera) == wish.cameras.end();
    });
    for (Picture& picture : pictures_)
        picture.fresh = false;
    size_px_ = wish.size_px;
    const std::scoped_lock lock(mutex_);
    drawn_ = std::move(request);
    cameras_.clear();
}

std::size_t ViewCards::number_of(const Camera& camera) {
    const std::scoped_lock lock(mutex_);
    const auto found = std::ranges::find(cameras_, camera);
    if (found != cameras_.end()) return static_cast<std::size_t>(found - cameras_.begin());
    cameras_.push_back(camera);
    return cameras_.size() - 1;
}

void ViewCards::follow(ui::UiState& state, const PictureRequest* shown) {
    const auto wish = std::exchange(state.wishes.view_pictures, std::nullopt);
    job_.hold(state.shown.picture.tracing);
    if (!wish || shown == nullptr) return job_.want({}, size_px_);
    PictureRequest request = without_camera(*shown);
    if (request != drawn_ || wish->size_px != size_px_) {
        begin(std::move(request), *wish);
        tell(state);
    }
    std::vector<std::size_t> missing;
    for (const Camera& camera : wish->cameras) {
        const auto picture = std::ranges::find(pictures_, camera, &Picture::camera);
        if (picture == pictures_.end() || !picture->fresh) missing.push_back(number_of(camera));
    }
    job_.want(std::move(missing), size_px_);
}

}  // namespace zeroset
