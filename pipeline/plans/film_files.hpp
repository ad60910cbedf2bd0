#pragma once

#include "engine/export/films/film_formats.hpp"
#include "engine/export/films/film_writer.hpp"
#include "engine/export/films/frame_names.hpp"
#include "engine/export/pictures/picture_formats.hpp"
#include "pipeline/plans/film.hpp"

#include <expected>
#include <filesystem>
#include <memory>
#include <optional>

namespace zeroset {

/// The file, or files, that frames go into.
struct FilmTarget {
    std::filesystem::path path;        ///< of a film
    const FilmFormat* film = nullptr;  ///< nullptr: numbered pictures
    FilmSettings settings;
    std::optional<FrameNames> names;
    const PictureFormat* picture = nullptr;
    PictureOptions picture_options;

    [[nodiscard]] bool transparent() const {
        return names ? picture_options.alpha : settings.alpha;
    }
};

/// Writes a film's frames. One thread calls.
class FrameFiles {
public:
    explicit FrameFiles(FilmTarget target) : target_(std::move(target)) {}

    /// Begins the film, or sees whether pictures can be written.
    std::expected<void, FileError> begin();
    std::expected<void, FileError> take(const FilmFrame& frame);
    /// Gives a film its name.
    std::expected<void, FileError> finish();
    /// Whether a numbered picture is there and shows this document in this size.
    [[nodiscard]] bool has(int number, const Document& document) const;
    [[nodiscard]] double writing_ms() const { return writing_ms_; }

private:
    [[nodiscard]] std::expected<void, FileError> write_picture(const FilmFrame& frame) const;

    FilmTarget target_;
    std::unique_ptr<FilmWriter> film_;
    double writing_ms_ = 0.0;
};

}  // namespace zeroset
