#pragma once

#include "app/cli/commands.hpp"
#include "app/cli/render_picture.hpp"
#include "engine/export/pfm_writer.hpp"
#include "engine/export/pictures/picture_formats.hpp"

#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// Reads how -o is to be written: --bits, --dpi, --quality, --alpha, and the format of its ending.
OrInputError<PictureOptions> read_picture_options(const RenderCommand& command, const Size& size);

/// The files of `render` that grow with the picture, and what is counted on the way. One thread
/// calls.
class RenderFiles {
public:
    explicit RenderFiles(RenderCommand command) : command_(std::move(command)) {}

    /// Takes the next rows of the picture.
    std::expected<void, FileError> add(const RenderedPicture& picture, const PictureBand& band);
    /// Gives the complete files their names.
    std::expected<void, FileError> finish();

    /// The counts for --stats.
    [[nodiscard]] const CertificateCounts& certificates() const { return certificates_; }
    /// Number of pixels that show each surface.
    [[nodiscard]] const std::vector<std::size_t>& surfaces() const { return surfaces_; }
    /// The time spent on the files.
    [[nodiscard]] double writing_ms() const { return writing_ms_; }

private:
    std::expected<void, FileError> begin(const RenderedPicture& picture);
    std::expected<void, FileError> write(const RenderedPicture& picture, const PictureBand& band);
    void count(const Framebuffer& band);

    RenderCommand command_;
    bool begun_ = false;
    std::unique_ptr<PictureWriter> picture_, certificate_, cost_;
    std::unique_ptr<PfmWriter> depth_;
    double writing_ms_ = 0.0;
    CertificateCounts certificates_;
    std::vector<std::size_t> surfaces_;
};

/// Hands a picture that is in memory as a whole to its files.
std::expected<void, std::string> add_whole(const RenderCommand& command,
                                           const std::shared_ptr<const RenderedPicture>& made,
                                           RenderFiles& files);

}  // namespace zeroset
