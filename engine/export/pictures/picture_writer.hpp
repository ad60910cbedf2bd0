#pragma once

#include "engine/export/file.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/view/camera.hpp"

#include <expected>
#include <string>

namespace zeroset {

/// Rows of a picture, with all its columns.
struct PictureBand {
    const Framebuffer& frame;    ///< as drawn
    const Framebuffer& painted;  ///< with axes, markers and legend over it; may be the same
    int row = 0;                 ///< the first one
};

/// How a picture is written.
struct PictureOptions {
    ImageSize size{};
    int bits = 8;                ///< of a channel: 8, 16, or 32 (of numbers with a point)
    bool alpha = false;          ///< the background is left transparent
    double dots_per_inch = 0.0;  ///< 0: not told
    int quality = 92;            ///< of formats with losses, 1 to 100
    std::string document = {};   ///< the session as JSON, embedded where the format can; or empty
    Camera camera = {};          ///< that draws the picture
};

/// Writes one picture, beside its place until it is complete. One thread calls.
class PictureWriter {
public:
    virtual ~PictureWriter() = default;
    PictureWriter() = default;
    PictureWriter(const PictureWriter&) = delete;
    PictureWriter& operator=(const PictureWriter&) = delete;

    /// Appends rows, from the top to the bottom.
    virtual std::expected<void, FileError> add(const PictureBand& band) = 0;
    /// Gives the complete file its name.
    virtual std::expected<void, FileError> finish() = 0;
};

/// The keyword, or attribute, under which pictures hold their session.
inline constexpr const char* document_keyword = "zeroset document";

}  // namespace zeroset
