#include "engine/export/films/film_writer.hpp"

#include "engine/base/translation.hpp"
#include "engine/export/pictures/pixel_rows.hpp"

namespace zeroset {

FilmWriter::FilmWriter(const std::filesystem::path& path, const FilmSettings& settings)
    : path_(path), settings_(settings), file_(path, NewFile::Order::Any) {}

std::unexpected<FileError> FilmWriter::failure(const std::string& reason) const {
    return std::unexpected(
        FileError{filled(tr("cannot write {0}: {1}"), {"'" + path_.string() + "'", reason})});
}

std::expected<std::unique_ptr<FilmWriter>, FileError> FilmWriter::begin(
    const FilmFormat& format, const std::filesystem::path& path, const FilmSettings& settings) {
    if (auto writable = check_writable(path); !writable) return std::unexpected(writable.error());
    std::unique_ptr<FilmWriter> film(new FilmWriter(path, settings));
    auto encoder = open_film(format.codec, film->file_.place(), settings);
    if (!encoder) return film->failure(encoder.error());
    film->encoder_ = std::move(*encoder);
    return film;
}

std::expected<void, FileError> FilmWriter::add(const PictureBand& frame) {
    if (settings_.alpha) take_drawn_pixels(frame, settings_.height, drawn_);
    const auto added = encoder_->add({.width = settings_.width,
                                      .height = settings_.height,
                                      .alpha = settings_.alpha,
                                      .pixels = settings_.alpha ? drawn_ : frame.painted.color});
    if (!added) return failure(added.error());
    return {};
}

std::expected<void, FileError> FilmWriter::finish() {
    if (const auto finished = encoder_->finish(); !finished) return failure(finished.error());
    return file_.keep();
}

}  // namespace zeroset
