#pragma once

#include "document/document.hpp"
#include "pipeline/picture_request.hpp"

#include <atomic>
#include <cstdint>
#include <expected>
#include <filesystem>
#include <functional>
#include <future>
#include <optional>
#include <string>

namespace zeroset {

/// A picture that is drawn into a file in the background, while the window goes on. One thread owns
/// it.
class PictureExport {
public:
    /// `on_end` is called from the export's thread.
    explicit PictureExport(std::function<void()> on_end) : on_end_(std::move(on_end)) {}
    /// Gives up a picture that is being drawn.
    ~PictureExport();
    PictureExport(const PictureExport&) = delete;
    PictureExport& operator=(const PictureExport&) = delete;

    /// Begins to draw the document's picture in export quality: of twice the request's pixels, with
    /// smooth edges. The last one must have ended.
    void start(PictureRequest request, Document document, const std::filesystem::path& path);
    [[nodiscard]] bool runs() const { return work_.valid(); }
    /// "saving a.png, 45 %"; empty while nothing is saved.
    [[nodiscard]] std::string doing() const;
    /// Once for each picture that has ended: one line on what was saved, or why it was not.
    std::optional<std::expected<std::string, std::string>> take();

private:
    using Outcome = std::expected<std::string, std::string>;
    Outcome write(PictureRequest request, const Document& document,
                  const std::filesystem::path& path);

    std::function<void()> on_end_;
    std::string name_;
    std::atomic<bool> cancel_ = false;
    std::atomic<std::uint64_t> done_ = 0;
    std::uint64_t pixels_ = 1;
    std::future<Outcome> work_;
};

}  // namespace zeroset
