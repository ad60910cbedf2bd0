#pragma once

#include "engine/export/pictures/picture_writer.hpp"

#include <array>
#include <cstdint>
#include <expected>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace zeroset {

/// A kind of picture file.
struct PictureFormat {
    std::string_view name;                    ///< "PNG"
    std::array<std::string_view, 2> endings;  ///< ".jpg", ".jpeg"; the second may be empty
    std::string_view about;                   ///< what it is good for
    std::array<int, 2> bits;                  ///< of a channel, the default first
    bool alpha;                               ///< can be transparent
    bool lossy;                               ///< PictureOptions::quality counts
    bool density;                             ///< PictureOptions::dots_per_inch is told
    bool document;                            ///< holds the session
    int largest_side;
    std::int64_t most_bytes;  ///< of pixels, where all are in memory; 0: any number
    const char* encoder;      ///< of FFmpeg; nullptr: none is needed
    std::unique_ptr<PictureWriter> (*make)(const std::filesystem::path& path,
                                           const PictureOptions& options);
};

/// All of them, PNG first.
std::span<const PictureFormat> picture_formats();

/// The format of the path's ending, in any case; nullptr where there is none.
const PictureFormat* picture_format_of(const std::filesystem::path& path);

/// Why this program cannot write the format; empty where it can.
std::string missing_part(const PictureFormat& format);

/// Why a picture cannot be written so, with what can be done instead; nothing where it can.
std::optional<std::string> refusal(const PictureFormat& format, const PictureOptions& options);

/// True if the pictures' frames must keep their light; and their normals.
bool needs_light(const PictureOptions& options);
bool needs_normals(const PictureOptions& options);

/// Begins a picture; the format must not refuse the options.
std::expected<std::unique_ptr<PictureWriter>, FileError> begin_picture(
    const PictureFormat& format, const std::filesystem::path& path, const PictureOptions& options);

}  // namespace zeroset
