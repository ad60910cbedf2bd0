#include "app/desktop/file_watch.hpp"

#include <chrono>
#include <utility>

namespace zeroset {

FileWatch::FileWatch(std::shared_ptr<FileAccess> files, std::function<void()> on_change)
    : files_(std::move(files)),
      on_change_(std::move(on_change)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void FileWatch::run(const std::stop_token& stop) {
    constexpr std::chrono::seconds pause(1);
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        stopped_.wait_for(lock, stop, pause, [] { return false; });
        if (!stop.stop_requested() && files_->look_for_changes()) on_change_();
    }
}

}  // namespace zeroset
