#pragma once

#include "engine/export/films/film_formats.hpp"
#include "engine/export/new_file.hpp"
#include "engine/export/pictures/picture_writer.hpp"

#include <cstdint>
#include <expected>
#include <filesystem>
#include <memory>
#include <vector>

namespace zeroset {

/// Writes a film, beside its place until it is finished. One thread calls.
class FilmWriter {
public:
    /// Begins a film; the format must not refuse the settings.
    static std::expected<std::unique_ptr<FilmWriter>, FileError> begin(
        const FilmFormat& format, const std::filesystem::path& path, const FilmSettings& settings);

    /// Appends a frame: a band that is the whole picture.
    std::expected<void, FileError> add(const PictureBand& frame);
    /// Gives the complete file its name, after one frame at least.
    std::expected<void, FileError> finish();

private:
    FilmWriter(const std::filesystem::path& path, const FilmSettings& settings);
    [[nodiscard]] std::unexpected<FileError> failure(const std::string& reason) const;

    std::filesystem::path path_;
    FilmSettings settings_;
    NewFile file_;
    std::unique_ptr<FilmEncoder> encoder_;
    std::vector<std::uint32_t> drawn_;  ///< memory, kept from frame to frame
};

}  // namespace zeroset
