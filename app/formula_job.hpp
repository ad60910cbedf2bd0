#pragma once

#include "app/formula.hpp"

#include <condition_variable>
#include <expected>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace zeroset {

struct FormulaResult {
    std::string text;
    std::expected<std::shared_ptr<const Formula>, InputError> formula;
};

/// Compiles the newest text in the background. Members may be called from the UI thread and
/// never wait for a compilation; texts overtaken by a newer one are dropped.
class FormulaJob {
public:
    /// `on_result` is called from the job's thread after each compilation.
    explicit FormulaJob(std::function<void()> on_result);
    ~FormulaJob();
    FormulaJob(const FormulaJob&) = delete;
    FormulaJob& operator=(const FormulaJob&) = delete;

    void submit(std::string text);
    /// The newest result not yet taken, or nothing.
    std::optional<FormulaResult> take();

private:
    void run();

    std::function<void()> on_result_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<std::string> pending_;
    std::optional<FormulaResult> finished_;
    bool stop_ = false;
    std::thread thread_;
};

}  // namespace zeroset
