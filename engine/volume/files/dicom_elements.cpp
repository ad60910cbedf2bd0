#include "engine/volume/files/dicom_elements.hpp"

#include "engine/base/text.hpp"

#include <algorithm>
#include <array>
#include <optional>

// The encoding of DICOM (dicomstandard.org, part 5, section 7).

namespace zeroset {
namespace {

constexpr std::size_t preamble = 132;
constexpr DicomTag syntax_tag = 0x00020010;
constexpr DicomTag pixel_data = 0x7fe00010;
constexpr DicomTag item = 0xfffee000;
constexpr DicomTag item_end = 0xfffee00d;
constexpr DicomTag sequence_end = 0xfffee0dd;
constexpr std::uint32_t undefined_length = 0xffffffff;

/// Types whose lengths have 32 bits.
constexpr std::array long_types{"OB", "OD", "OF", "OL", "OV", "OW", "SQ",
                                "SV", "UC", "UN", "UR", "UT", "UV"};

struct Encoding {
    bool explicit_types = true;
    bool big_endian = false;
};

class Reader {
public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}

    Expected<DicomElements> read(DeflatedPart part) {
        at_ = preamble;
        Encoding encoding;
        while (const auto head = next(encoding)) {
            if (head->tag >> 16U != 2) {
                at_ = head->start;
                break;
            }
            if (!take(*head)) return damaged();
        }
        found_.transfer_syntax = found_.text(bytes_, syntax_tag);
        encoding = {.explicit_types = found_.transfer_syntax != "1.2.840.10008.1.2",
                    .big_endian = found_.transfer_syntax == "1.2.840.10008.1.2.2"};
        found_.big_endian = encoding.big_endian;
        if (found_.transfer_syntax == "1.2.840.10008.1.2.1.99" && part == DeflatedPart::Packed) {
            found_.deflated_from = at_;
            return found_;
        }
        while (at_ < bytes_.size()) {
            const auto head = next(encoding);
            if (!head) return damaged();
            if (head->tag == pixel_data) {
                found_.elements[pixel_data] = {
                    .offset = at_,
                    .length = std::min<std::size_t>(head->length, bytes_.size() - at_)};
                return found_;
            }
            const bool passed =
                head->length == undefined_length ? skip_sequence(*head, encoding, 0) : take(*head);
            if (!passed) return damaged();
        }
        return std::unexpected("it ends before its samples");
    }

private:
    struct Head {
        DicomTag tag;
        std::uint32_t length;
        std::size_t start;
        bool unknown_type;  ///< "UN"
    };

    static std::unexpected<std::string> damaged() {
        return std::unexpected(std::string("its header is damaged or cut off"));
    }
    template <class Number>
    std::optional<Number> number(bool big_endian) {
        if (bytes_.size() - at_ < sizeof(Number)) return std::nullopt;
        at_ += sizeof(Number);
        return number_at<Number>(bytes_, at_ - sizeof(Number), big_endian);
    }
    /// The head of the element that begins here.
    std::optional<Head> next(const Encoding& encoding) {
        Head head{.tag = 0, .length = 0, .start = at_, .unknown_type = false};
        const auto group = number<std::uint16_t>(encoding.big_endian);
        const auto element = number<std::uint16_t>(encoding.big_endian);
        if (!group || !element) return std::nullopt;
        head.tag = DicomTag{*group} << 16U | *element;
        if (encoding.explicit_types && *group != 0xfffe) {
            if (bytes_.size() - at_ < 2) return std::nullopt;
            const std::string_view type = bytes_.substr(at_, 2);
            at_ += 2;
            head.unknown_type = type == "UN";
            if (std::ranges::find(long_types, type) == long_types.end()) {
                const auto length = number<std::uint16_t>(encoding.big_endian);
                if (!length) return std::nullopt;
                head.length = *length;
                return head;
            }
            if (!number<std::uint16_t>(false)) return std::nullopt;  // reserved
        }
        const auto length = number<std::uint32_t>(encoding.big_endian);
        if (!length) return std::nullopt;
        head.length = *length;
        return head;
    }
    /// Notes an element and goes on behind it.
    bool take(const Head& head) {
        if (!skip(head.length)) return false;
        found_.elements[head.tag] = {.offset = at_ - head.length, .length = head.length};
        return true;
    }
    bool skip(std::size_t length) {
        if (length > bytes_.size() - at_) return false;
        at_ += length;
        return true;
    }
    /// Goes on behind a sequence of undefined length.
    bool skip_sequence(const Head& sequence, Encoding encoding, int depth) {
        constexpr int deepest = 32;
        if (depth > deepest) return false;
        if (sequence.unknown_type) encoding.explicit_types = false;
        for (;;) {
            const auto head = next(encoding);
            if (!head) return false;
            if (head->tag == sequence_end) return true;
            if (head->tag != item) return false;
            const bool passed =
                head->length == undefined_length ? skip_item(encoding, depth) : skip(head->length);
            if (!passed) return false;
        }
    }
    bool skip_item(const Encoding& encoding, int depth) {
        for (;;) {
            const auto head = next(encoding);
            if (!head) return false;
            if (head->tag == item_end) return true;
            const bool passed = head->length == undefined_length
                                    ? skip_sequence(*head, encoding, depth + 1)
                                    : skip(head->length);
            if (!passed) return false;
        }
    }

    std::string_view bytes_;
    std::size_t at_ = 0;
    DicomElements found_;
};

}  // namespace

std::string DicomElements::text(std::string_view bytes, DicomTag tag) const {
    const auto found = elements.find(tag);
    if (found == elements.end()) return {};
    std::string_view text = bytes.substr(found->second.offset, found->second.length);
    text = text.substr(0, text.find('\0'));
    return std::string(trimmed(text));
}

int DicomElements::number(std::string_view bytes, DicomTag tag, int otherwise) const {
    const auto found = elements.find(tag);
    if (found == elements.end() || found->second.length < 2) return otherwise;
    return number_at<std::uint16_t>(bytes, found->second.offset, big_endian);
}

Expected<DicomElements> read_dicom_elements(std::string_view bytes, DeflatedPart part) {
    if (bytes.size() < preamble) return std::unexpected("it ends before its header");
    return Reader(bytes).read(part);
}

}  // namespace zeroset
