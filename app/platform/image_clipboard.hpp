#pragma once

#include <cstddef>
#include <expected>
#include <memory>
#include <string>
#include <vector>

namespace zeroset {

/// Pictures on the desktop's clipboard, by X11, which has no such thing itself: the picture stays
/// here, and other programs ask for it. A thread of its own answers them. One thread owns it.
class ImageClipboard {
public:
    ImageClipboard();
    ~ImageClipboard();
    ImageClipboard(const ImageClipboard&) = delete;
    ImageClipboard& operator=(const ImageClipboard&) = delete;

    /// Offers a PNG file until something else is copied, here or elsewhere, or this ends. Says in
    /// one line why it cannot.
    std::expected<void, std::string> offer(std::vector<std::byte> png);

private:
    class Owner;
    std::unique_ptr<Owner> owner_;  ///< nullptr before the first picture
};

}  // namespace zeroset
