#pragma once

#include "engine/measure/extent.hpp"
#include "pipeline/picture_request.hpp"

#include <future>
#include <optional>

namespace zeroset {

/// Finds in the background how far the surfaces of a picture reach. One thread owns it and looks
/// every poll_s whether it is done.
class ExtentSearch {
public:
    static constexpr double poll_s = 0.004;

    /// Begins a search; none may be running.
    void start(const PictureRequest& picture);
    [[nodiscard]] bool runs() const { return extent_.valid(); }
    [[nodiscard]] bool done() const;
    /// The extent of a search that is done, unless formula or clip box of the picture, as it is
    /// `now`, have changed since it began.
    std::optional<Extent> take(const std::optional<PictureRequest>& now);

private:
    std::future<Extent> extent_;
    std::optional<PictureRequest> picture_;
};

}  // namespace zeroset
