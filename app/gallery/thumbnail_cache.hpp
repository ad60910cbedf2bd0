#pragma once

#include "engine/image/rgba_image.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace zeroset {

/// Small pictures in files, each under a text of all that it depends on. A damaged file counts as
/// missing. Any thread; several processes may share the folder.
class ThumbnailCache {
public:
    /// Makes the folder when it is first needed. Without a folder nothing is kept.
    explicit ThumbnailCache(std::optional<std::filesystem::path> folder);

    [[nodiscard]] std::optional<RgbaImage> find(const std::string& key) const;
    /// Writes the picture; a failure is ignored.
    void keep(const std::string& key, const RgbaImage& image) const;
    /// The file of a key: a PNG followed by a checksum.
    [[nodiscard]] std::filesystem::path file_of(const std::string& key) const;

private:
    std::optional<std::filesystem::path> folder_;
};

}  // namespace zeroset
