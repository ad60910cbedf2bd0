#include "engine/render/growing_picture.hpp"

#include "engine/render/render.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace zeroset {
namespace {

/// Copies the pixels of `rect` that are at the same places of a picture of another size.
void stretch(const Framebuffer& from, const PixelRect& rect, Framebuffer& to) {
    for (int row = rect.row; row < rect.row + rect.rows; ++row) {
        const int from_row = row * from.height / to.height;
        for (int col = rect.col; col < rect.col + rect.cols; ++col) {
            const std::size_t source = from.index(col * from.width / to.width, from_row);
            const std::size_t target = to.index(col, row);
            to.color[target] = from.color[source];
            to.depth[target] = from.depth[source];
            to.certificate[target] = from.certificate[source];
            to.surface[target] = from.surface[source];
            if (!to.cost.empty()) to.cost[target] = from.cost[source];
        }
    }
}

void copy(const Framebuffer& from, const PixelRect& rect, Framebuffer& to) {
    const auto count = static_cast<std::size_t>(rect.cols);
    for (int row = rect.row; row < rect.row + rect.rows; ++row) {
        const std::size_t first = from.index(rect.col, row);
        std::copy_n(&from.color[first], count, &to.color[first]);
        std::copy_n(&from.depth[first], count, &to.depth[first]);
        std::copy_n(&from.certificate[first], count, &to.certificate[first]);
        std::copy_n(&from.surface[first], count, &to.surface[first]);
        if (!to.cost.empty()) std::copy_n(&from.cost[first], count, &to.cost[first]);
    }
}

}  // namespace

GrowingPicture::GrowingPicture(const RenderRequest& request, FramePool& pool, Plan plan)
    : request_(request),
      pool_(pool),
      plan_(std::move(plan)),
      frame_(pool.take(request.width, request.height)),
      grid_(request.width, request.height),
      done_(grid_.size()) {}

double GrowingPicture::elapsed_ms() const {
    return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
}

void GrowingPicture::tell(ResolutionGovernor& governor) const {
    const auto tiles = static_cast<double>(
        std::ranges::count_if(done_, [](const std::atomic<bool>& tile) { return tile.load(); }));
    const double part = tiles / static_cast<double>(done_.size());
    if (part >= 0.25) governor.measured(request_.pixels(), elapsed_ms() / part);
}

bool GrowingPicture::draw() {
    const Counters counters =
        render_frame(request_.scene, request_.camera, plan_.settings, *frame_,
                     {.limit = plan_.limit,
                      .first_turn = plan_.first_turn,
                      .on_tile = [this](const PixelRect& rect) { finish_tile(rect); }});
    complete_ = !counters.is_cut();
    cut_share_ = static_cast<double>(counters.cut_pixels) / static_cast<double>(request_.pixels());
    return !plan_.limit.cancelled();
}

void GrowingPicture::finish_tile(const PixelRect& rect) {
    done_[grid_.index_of(rect.col, rect.row)] = true;
    if (plan_.coarser == nullptr) return;
    const std::unique_lock lock(showing_, std::try_to_lock);
    if (!lock || Clock::now() - shown_ < plan_.shown_after) return;
    const auto picture = snapshot();
    plan_.show(picture, elapsed_ms());
    shown_ = Clock::now();
}

std::shared_ptr<const Framebuffer> GrowingPicture::snapshot() const {
    auto picture = pool_.take(frame_->width, frame_->height);
    picture->blank_rows.clear();
    picture->cost.resize(frame_->cost.size());
    for (std::size_t i = 0; i < grid_.size(); ++i) {
        const Tile tile = grid_.tile(i);
        const PixelRect rect{
            .col = tile.col, .row = tile.row, .cols = tile.cols, .rows = tile.rows};
        if (done_[i]) {
            copy(*frame_, rect, *picture);
        } else {
            stretch(*plan_.coarser, rect, *picture);
        }
    }
    return picture;
}

}  // namespace zeroset
