#include "pipeline/plans/film_files.hpp"

#include "document/json/document_file.hpp"
#include "document/json/document_json.hpp"
#include "engine/base/clock.hpp"

namespace zeroset {

std::expected<void, FileError> FrameFiles::begin() {
    if (target_.names) return check_writable(target_.names->path(0));
    auto film = FilmWriter::begin(*target_.film, target_.path, target_.settings);
    if (!film) return std::unexpected(film.error());
    film_ = std::move(*film);
    return {};
}

std::expected<void, FileError> FrameFiles::write_picture(const FilmFrame& frame) const {
    PictureOptions options = target_.picture_options;
    options.document = text_of(frame.document);
    options.camera = *frame.document.camera;
    auto picture = begin_picture(*target_.picture, target_.names->path(frame.number), options);
    if (!picture) return std::unexpected(picture.error());
    if (auto added = (*picture)->add(frame.picture); !added) return added;
    return (*picture)->finish();
}

std::expected<void, FileError> FrameFiles::take(const FilmFrame& frame) {
    const auto start = TimeLimit::Clock::now();
    auto taken = target_.names ? write_picture(frame) : film_->add(frame.picture);
    writing_ms_ += ms_since(start);
    return taken;
}

std::expected<void, FileError> FrameFiles::finish() {
    const auto start = TimeLimit::Clock::now();
    std::expected<void, FileError> finished;
    if (film_ != nullptr) finished = film_->finish();
    writing_ms_ += ms_since(start);
    return finished;
}

bool FrameFiles::has(int number, const Document& document) const {
    const std::filesystem::path path = target_.names->path(number);
    const ImageSize& size = target_.picture_options.size;
    return holds_picture_of(path, document, {size.width, size.height});
}

}  // namespace zeroset
