#include "engine/trace/render_job.hpp"

#include "engine/trace/render.hpp"
#include "engine/trace/tracer.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace zeroset {
namespace {

// Pixels of the full picture per pixel of a pass, in each direction.
constexpr int coarseness_of_passes[] = {8, 4, 2, 1};

}  // namespace

RenderJob::RenderJob(std::function<void()> on_frame)
    : on_frame_(std::move(on_frame)), thread_([this] { run(); }) {}

RenderJob::~RenderJob() {
    {
        const std::scoped_lock lock(mutex_);
        stop_ = true;
        cancel_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

std::uint64_t RenderJob::submit(RenderRequest request) {
    std::uint64_t number = 0;
    {
        const std::scoped_lock lock(mutex_);
        pending_ = std::move(request);
        number = ++newest_;
        cancel_ = true;
    }
    wake_.notify_one();
    return number;
}

std::optional<RenderResult> RenderJob::take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(finished_, std::nullopt);
}

bool RenderJob::busy() const {
    const std::scoped_lock lock(mutex_);
    return drawing_ || pending_.has_value();
}

void RenderJob::run() {
    for (;;) {
        RenderRequest request;
        std::uint64_t number = 0;
        {
            std::unique_lock lock(mutex_);
            drawing_ = false;
            wake_.wait(lock, [this] { return stop_ || pending_.has_value(); });
            if (stop_) return;
            request = std::move(*std::exchange(pending_, std::nullopt));
            number = newest_;
            drawing_ = true;
            cancel_ = false;
        }
        draw(request, number);
    }
}

void RenderJob::draw(const RenderRequest& request, std::uint64_t number) {
    const Precision precision =
        frame_precision(request.scene, ViewFrame(request.camera), request.settings.stop);
    for (const int coarseness : coarseness_of_passes) {
        const auto pixels = [&](int full) {
            return std::max(1, (full + coarseness - 1) / coarseness);
        };
        auto frame = std::make_shared<Framebuffer>(pixels(request.width), pixels(request.height));
        const auto start = std::chrono::steady_clock::now();
        render_frame(request.scene, request.camera, request.settings, *frame, &cancel_);
        const std::chrono::duration<double, std::milli> elapsed =
            std::chrono::steady_clock::now() - start;
        RenderResult result{
            frame,          number,   coarseness, elapsed.count(), count_certificates(*frame),
            request.camera, precision};
        {
            const std::scoped_lock lock(mutex_);
            if (cancel_) return;
            finished_ = std::move(result);
            if (coarseness == 1) drawing_ = false;
        }
        on_frame_();
    }
}

}  // namespace zeroset
