#include "app/exports/preview_job.hpp"

#include <utility>

namespace zeroset {

PreviewJob::PreviewJob(std::function<void()> wake)
    : wake_(std::move(wake)), thread_([this] { run(); }) {}

PreviewJob::~PreviewJob() {
    {
        const std::scoped_lock lock(mutex_);
        stop_ = true;
        if (news_ != nullptr) news_->cancel = true;
    }
    changed_.notify_one();
    thread_.join();
}

void PreviewJob::want(std::optional<PreviewRequest> request) {
    const std::scoped_lock lock(mutex_);
    if (request == wanted_) return;
    // A film that plays shows every frame that it can: one that is begun is finished.
    const bool other = making_ && (!request || !request->same_file(*making_));
    if (other && news_ != nullptr) news_->cancel = true;
    if (!request) made_.reset();
    wanted_ = request;
    waiting_ = std::move(request);
    style_ = text_style();
    changed_.notify_one();
}

void PreviewJob::know(Preview made) {
    const std::scoped_lock lock(mutex_);
    known_ = std::move(made);
}

std::optional<Preview> PreviewJob::take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(made_, std::nullopt);
}

std::string PreviewJob::doing() const {
    const std::scoped_lock lock(mutex_);
    return news_ == nullptr ? "" : news_->text();
}

bool PreviewJob::busy() const {
    const std::scoped_lock lock(mutex_);
    return waiting_ || making_ || made_;
}

std::optional<PreviewRequest> PreviewJob::next() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stop_ || waiting_; });
    if (stop_) return std::nullopt;
    set_language(style_);
    making_ = std::exchange(waiting_, std::nullopt);
    news_ = std::make_shared<ExportNews>(wake_);
    return making_;
}

void PreviewJob::run() {
    std::optional<Preview> last;
    while (const auto request = next()) {
        {
            const std::scoped_lock lock(mutex_);
            if (known_) last = std::exchange(known_, std::nullopt);
        }
        Preview preview = make_preview(*request, last, *news_);
        if (!news_->cancel) last = preview;
        {
            const std::scoped_lock lock(mutex_);
            if (!news_->cancel) made_ = std::move(preview);
            making_.reset();
            news_.reset();
        }
        wake_();
    }
}

}  // namespace zeroset
