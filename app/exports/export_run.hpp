#pragma once

#include "app/exports/export_news.hpp"

#include <expected>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

namespace zeroset {

/// One line on what was saved, or why it was not.
using ExportOutcome = std::expected<std::string, std::string>;
/// Makes a file. Ends soon after the news are cancelled, and leaves nothing behind then.
using ExportWork = std::function<ExportOutcome(ExportNews&)>;

/// A file that is made in the background. One thread owns it.
class ExportRun {
public:
    /// `wake` is called from other threads when there is something new.
    explicit ExportRun(std::function<void()> wake) : wake_(std::move(wake)) {}
    /// Gives up what is being saved.
    ~ExportRun() { cancel(); }
    ExportRun(const ExportRun&) = delete;
    ExportRun& operator=(const ExportRun&) = delete;

    /// Begins; the last one must have ended. `name`: of the file.
    void start(std::string name, ExportWork work);
    void cancel();
    [[nodiscard]] bool runs() const { return work_.valid(); }
    [[nodiscard]] const std::string& name() const { return name_; }
    /// How far it is; only while it runs.
    [[nodiscard]] ExportNews& news() const { return *news_; }
    /// Once for each that has ended.
    std::optional<ExportOutcome> take();

private:
    std::function<void()> wake_;
    std::string name_;
    std::unique_ptr<ExportNews> news_;
    std::future<ExportOutcome> work_;
};

}  // namespace zeroset
