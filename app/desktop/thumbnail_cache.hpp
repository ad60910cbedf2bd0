#pragma once

#include "engine/image/rgba_image.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace zeroset {

/// Small pictures kept in files, each under the text of all that it depends on. A file that is
/// damaged counts as missing. Any thread; several processes may share the folder.
class ThumbnailCache {
public:
    /// Without a folder nothing is kept. It is made when it is first needed.
    explicit ThumbnailCache(std::optional<std::filesystem::path> folder);

    [[nodiscard]] std::optional<RgbaImage> find(const std::string& key) const;
    /// What cannot be written is left out.
    void keep(const std::string& key, const RgbaImage& image) const;
    /// The file of a key: a PNG with a checksum behind it.
    [[nodiscard]] std::filesystem::path file_of(const std::string& key) const;

private:
    std::optional<std::filesystem::path> folder_;
};

}  // namespace zeroset
