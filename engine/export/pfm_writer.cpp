#include "engine/export/pfm_writer.hpp"

#include <bit>
#include <span>
#include <string>

namespace zeroset {

PfmWriter::PfmWriter(const std::filesystem::path& path, int width, int height)
    : file_(path, NewFile::Order::Any), height_(height) {
    const std::string header =
        "Pf\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1.0\n";
    header_ = static_cast<std::streamoff>(header.size());
    file_.append(std::as_bytes(std::span(header)));
}

std::expected<void, FileError> PfmWriter::add(const Framebuffer& band, int row) {
    static_assert(std::endian::native == std::endian::little);
    const auto width = static_cast<std::size_t>(band.width);
    // Rows from the bottom: those of a band lie one after the other, its last one first.
    const auto below = static_cast<std::streamoff>(height_ - row - band.height);
    const auto row_bytes = static_cast<std::streamoff>(width * sizeof(float));
    file_.stream().seekp(header_ + below * row_bytes);
    for (int i = band.height; i-- > 0;) {
        const std::span<const float> depths(&band.depth[band.index(0, i)], width);
        if (!file_.append(std::as_bytes(depths))) return file_.error();
    }
    return {};
}

}  // namespace zeroset
