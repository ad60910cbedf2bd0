#pragma once

#include "app/exports/make_preview.hpp"
#include "engine/base/translation.hpp"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace zeroset {

/// Makes previews in the background, the newest that is wanted. One thread owns it.
class PreviewJob {
public:
    /// `wake` is called from other threads when there is something new.
    explicit PreviewJob(std::function<void()> wake);
    ~PreviewJob();
    PreviewJob(const PreviewJob&) = delete;
    PreviewJob& operator=(const PreviewJob&) = delete;

    /// Has this preview made, unless it is the one wanted last. One of another file that is being
    /// made is given up; nothing: no preview is wanted.
    void want(std::optional<PreviewRequest> request);
    /// Lets previews of this file use what was made for it, as if they had made it.
    void know(Preview made);
    /// The newest preview not yet taken.
    std::optional<Preview> take();
    /// The work in progress, in words, while a preview is being made.
    [[nodiscard]] std::string doing() const;
    /// True while the wanted preview is not taken.
    [[nodiscard]] bool busy() const;

private:
    void run();
    /// Waits for the next request; nothing at the end.
    std::optional<PreviewRequest> next();

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<PreviewRequest> wanted_;  ///< last
    std::optional<PreviewRequest> waiting_;
    TextStyle style_;                   ///< of who wants it
    std::shared_ptr<ExportNews> news_;  ///< of the preview that is being made
    std::optional<PreviewRequest> making_;
    std::optional<Preview> made_;
    std::optional<Preview> known_;  ///< given and not yet used
    bool stop_ = false;
    std::thread thread_;
};

}  // namespace zeroset
