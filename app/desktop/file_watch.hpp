#pragma once

#include "pipeline/file_access.hpp"

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>

namespace zeroset {

/// Looks once a second, on a thread of its own, whether files that are shown have changed
/// (FileAccess::look_for_changes), and says so.
class FileWatch {
public:
    /// `on_change` is called on that thread.
    FileWatch(std::shared_ptr<FileAccess> files, std::function<void()> on_change);

private:
    void run(const std::stop_token& stop);

    std::shared_ptr<FileAccess> files_;
    std::function<void()> on_change_;
    std::mutex mutex_;
    std::condition_variable_any stopped_;
    std::jthread thread_;  ///< the last member: it ends before the others do
};

}  // namespace zeroset
