#include "app/desktop/extent_search.hpp"

#include "document/framing.hpp"

#include <chrono>

namespace zeroset {

void ExtentSearch::start(const PictureRequest& picture) {
    picture_ = picture;
    extent_ =
        std::async(std::launch::async, [scene = scene_of(picture)] { return find_extent(scene); });
}

bool ExtentSearch::done() const {
    return runs() && extent_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

std::optional<Extent> ExtentSearch::take(const std::optional<PictureRequest>& now) {
    const Extent extent = extent_.get();
    if (!now || now->formula != picture_->formula || now->clip != picture_->clip)
        return std::nullopt;
    return unstretched(extent, now->camera.stretch);
}

}  // namespace zeroset
