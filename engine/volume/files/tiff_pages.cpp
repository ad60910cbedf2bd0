#include "engine/volume/files/tiff_pages.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace zeroset {
namespace {

class TiffReader {
public:
    explicit TiffReader(std::string_view bytes) : bytes_(bytes) {}

    Expected<TiffPages> read() {
        constexpr std::size_t most_pages = 65536;
        constexpr const char* no_tiff = "it does not begin as TIFF does";
        big_endian_ = bytes_.starts_with("MM");
        if (!big_endian_ && !bytes_.starts_with("II")) return std::unexpected(no_tiff);
        const auto version = number_at<std::uint16_t>(bytes_, 2, big_endian_);
        if (version == 43)
            return std::unexpected("it is a BigTIFF; only TIFF of up to 4 GB is read");
        if (version != 42) return std::unexpected(no_tiff);
        TiffPages result{.pages = {}, .big_endian = big_endian_};
        std::size_t at = number_at<std::uint32_t>(bytes_, 4, big_endian_);
        for (std::size_t n = 0; at != 0; ++n) {
            if (n >= most_pages) return std::unexpected("it has more than 65536 pages");
            TiffPage page;
            const auto next = read_page(at, page);
            if (!next) return std::unexpected("its pages are damaged or cut off");
            const bool is_copy = (page.number(TiffTag::NewSubfileType, 0) & 1U) != 0;
            if (!is_copy) result.pages.push_back(std::move(page));
            at = *next;
        }
        if (result.pages.empty()) return std::unexpected("it has no page");
        return result;
    }

private:
    /// Reads a page's tags; the place of the next page, 0 behind the last.
    std::optional<std::size_t> read_page(std::size_t at, TiffPage& page) {
        constexpr std::size_t entry = 12;
        if (at + 2 > bytes_.size()) return std::nullopt;
        const std::size_t count = number_at<std::uint16_t>(bytes_, at, big_endian_);
        const std::size_t end = at + 2 + entry * count;
        if (end + 4 > bytes_.size()) return std::nullopt;
        taken_ += 2 + entry * count;
        for (std::size_t i = 0; i < count; ++i)
            take(at + 2 + entry * i, page);
        if (takes_too_much()) return std::nullopt;
        return number_at<std::uint32_t>(bytes_, end, big_endian_);
    }
    /// Takes a tag's values: whole numbers, a fraction or a text, within the file.
    void take(std::size_t at, TiffPage& page) {
        constexpr std::array<std::size_t, 6> widths{0, 1, 1, 2, 4, 8};
        const auto tag = number_at<std::uint16_t>(bytes_, at, big_endian_);
        const std::size_t type = number_at<std::uint16_t>(bytes_, at + 2, big_endian_);
        const std::uint64_t count = number_at<std::uint32_t>(bytes_, at + 4, big_endian_);
        if (type == 0 || type >= widths.size()) return;
        const std::uint64_t size = count * widths[type];
        const std::size_t place =
            size <= 4 ? at + 8 : number_at<std::uint32_t>(bytes_, at + 8, big_endian_);
        if (place > bytes_.size() || size > bytes_.size() - place) return;
        if (size > 4) taken_ += size;
        if (takes_too_much()) return;
        if (type == 2) {
            const std::string_view text = bytes_.substr(place, size);
            if (tag == static_cast<std::uint16_t>(TiffTag::ImageDescription))
                page.description = text.substr(0, text.find('\0'));
            return;
        }
        if (type == 5) {
            const auto above = number_at<std::uint32_t>(bytes_, place, big_endian_);
            const auto below = number_at<std::uint32_t>(bytes_, place + 4, big_endian_);
            page.fractions[TiffTag{tag}] = static_cast<double>(above) / static_cast<double>(below);
            return;
        }
        auto& numbers = page.numbers[TiffTag{tag}];
        for (std::uint64_t i = 0; i < count; ++i)
            numbers.push_back(whole(place + i * widths[type], widths[type]));
    }
    /// Pages may share values, as of their resolution; but links in a circle do so without end.
    [[nodiscard]] bool takes_too_much() const { return taken_ / 8 > bytes_.size(); }
    [[nodiscard]] std::uint64_t whole(std::size_t at, std::size_t width) const {
        if (width == 1) return static_cast<unsigned char>(bytes_[at]);
        if (width == 2) return number_at<std::uint16_t>(bytes_, at, big_endian_);
        return number_at<std::uint32_t>(bytes_, at, big_endian_);
    }

    std::string_view bytes_;
    bool big_endian_ = false;
    std::size_t taken_ = 0;  ///< bytes of directories and values
};

}  // namespace

Expected<TiffPages> read_tiff_pages(std::string_view bytes) { return TiffReader(bytes).read(); }

}  // namespace zeroset
