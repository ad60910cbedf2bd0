#include "engine/volume/files/dicom_elements.hpp"

#include "engine/base/text.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

// The encoding of DICOM (dicomstandard.org, part 5, section 7).

namespace zeroset {
namespace {

constexpr std::size_t preamble = 128;
constexpr std::string_view mark = "DICM";
constexpr DicomTag syntax_tag = 0x00020010;
constexpr DicomTag float_pixel_data = 0x7fe00008;
constexpr DicomTag double_pixel_data = 0x7fe00009;
constexpr DicomTag shared_groups = 0x52009229;
constexpr DicomTag frame_groups = 0x52009230;
/// The groups that tell where a slice lies and what its numbers mean (part 3, C.7.6.16): measures
/// of pixels, position, orientation, transformation of values.
constexpr std::array<DicomTag, 4> wanted_groups{0x00289110, 0x00209113, 0x00209116, 0x00289145};
constexpr DicomTag item_tag = 0xfffee000;
constexpr DicomTag item_end = 0xfffee00d;
constexpr DicomTag sequence_end = 0xfffee0dd;
constexpr std::uint32_t undefined_length = 0xffffffff;

constexpr const char* implicit_syntax = "1.2.840.10008.1.2";
constexpr const char* explicit_syntax = "1.2.840.10008.1.2.1";

/// Types of the elements that a file without a preamble may begin with.
constexpr std::array first_types{"UL", "OB", "CS", "DA", "UI"};

/// Types whose lengths have 32 bits.
constexpr std::array long_types{"OB", "OD", "OF", "OL", "OV", "OW", "SQ",
                                "SV", "UC", "UN", "UR", "UT", "UV"};

struct Encoding {
    bool explicit_types = true;
    bool big_endian = false;
};

bool has_mark(std::string_view bytes) {
    return bytes.size() >= preamble && bytes.substr(preamble).starts_with(mark);
}

class Reader {
public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}

    DicomElements read(DeflatedPart part) && {
        found_.problem = read_all(part);
        return std::move(found_);
    }

private:
    struct Head {
        DicomTag tag;
        std::uint32_t length;
        std::size_t start;
        bool unknown_type;  ///< "UN"
    };

    /// Why it was read no further, or nothing.
    std::string read_all(DeflatedPart part) {
        constexpr const char* damaged = "its header is damaged or cut off";
        if (!starts_as_dicom(bytes_)) return "it ends before its header";
        at_ = has_mark(bytes_) ? preamble + mark.size() : 0;
        Encoding encoding;
        while (const auto head = next(encoding)) {
            if (head->tag >> 16U != 2) {
                at_ = head->start;
                break;
            }
            if (!take(*head)) return damaged;
        }
        found_.transfer_syntax = found_.text(bytes_, syntax_tag);
        if (found_.transfer_syntax.empty())
            found_.transfer_syntax = has_type(at_) ? explicit_syntax : implicit_syntax;
        // Some writers have types where they say that they do not, or the other way round.
        encoding = {.explicit_types = has_type(at_),
                    .big_endian = found_.transfer_syntax == "1.2.840.10008.1.2.2"};
        found_.big_endian = encoding.big_endian;
        if (found_.transfer_syntax == "1.2.840.10008.1.2.1.99" && part == DeflatedPart::Packed) {
            found_.deflated_from = at_;
            return {};
        }
        while (at_ < bytes_.size()) {
            const auto head = next(encoding);
            if (!head) return damaged;
            if (head->tag == pixel_data) {
                found_.elements[pixel_data] = {
                    .offset = at_,
                    .length = std::min<std::size_t>(head->length, bytes_.size() - at_)};
                return {};
            }
            if (head->tag == float_pixel_data || head->tag == double_pixel_data)
                return "its samples are no whole numbers, but floats";
            if (!take_any(*head, encoding)) return damaged;
        }
        return {};
    }
    /// Whether the element there has a type of two capitals.
    [[nodiscard]] bool has_type(std::size_t at) const {
        constexpr std::size_t tag_bytes = 4;
        const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
        return bytes_.size() - at >= tag_bytes + 2 && is_capital(bytes_[at + tag_bytes]) &&
               is_capital(bytes_[at + tag_bytes + 1]);
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
    bool take(const Head& head) { return take_to(head, found_.elements); }
    bool take_to(const Head& head, DicomElements::Elements& elements) {
        if (!skip(head.length)) return false;
        elements[head.tag] = {.offset = at_ - head.length, .length = head.length};
        return true;
    }
    bool take_any(const Head& head, const Encoding& encoding) {
        const bool of_frames = head.tag == frame_groups;
        if ((of_frames || head.tag == shared_groups) && !head.unknown_type) {
            return for_each_item(head, encoding, [&](const Head& group) {
                auto& elements = of_frames ? found_.frames.emplace_back() : found_.shared;
                return take_groups(group, encoding, elements);
            });
        }
        return head.length == undefined_length ? skip_sequence(head, encoding, 0) : take(head);
    }
    /// Where a sequence or an item ends at most; nothing where that is beyond the file.
    [[nodiscard]] std::optional<std::size_t> end_of(const Head& head) const {
        if (head.length == undefined_length) return bytes_.size();
        if (head.length > bytes_.size() - at_) return std::nullopt;
        return at_ + head.length;
    }
    /// Calls `take(head)` for what is in a sequence or an item, up to its end, until it is false.
    template <class Take>
    bool for_each(const Head& outer, const Encoding& encoding, DicomTag end_tag, const Take& take) {
        const auto end = end_of(outer);
        if (!end) return false;
        while (at_ < *end) {
            const auto head = next(encoding);
            if (!head) return false;
            if (head->tag == end_tag) return outer.length == undefined_length;
            if (!take(*head)) return false;
        }
        return outer.length != undefined_length && at_ == *end;
    }
    template <class Take>
    bool for_each_item(const Head& sequence, const Encoding& encoding, const Take& take) {
        return for_each(sequence, encoding, sequence_end,
                        [&](const Head& head) { return head.tag == item_tag && take(head); });
    }
    /// Takes the elements of the wanted groups of a slice.
    bool take_groups(const Head& groups, const Encoding& encoding,
                     DicomElements::Elements& elements) {
        return for_each(groups, encoding, item_end, [&](const Head& head) {
            const bool wanted = std::ranges::find(wanted_groups, head.tag) != wanted_groups.end();
            if (!wanted || head.unknown_type) return pass(head, encoding);
            return for_each_item(head, encoding, [&](const Head& group) {
                return for_each(group, encoding, item_end, [&](const Head& element) {
                    if (element.length == undefined_length) return pass(element, encoding);
                    return take_to(element, elements);
                });
            });
        });
    }
    bool pass(const Head& head, const Encoding& encoding) {
        return head.length == undefined_length ? skip_sequence(head, encoding, 0)
                                               : skip(head.length);
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
            if (head->tag != item_tag) return false;
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

std::string DicomElements::text(std::string_view bytes, DicomTag tag,
                                std::optional<std::size_t> frame) const {
    const Element* element = nullptr;
    const auto look = [&](const Elements& in) {
        const auto found = in.find(tag);
        if (element == nullptr && found != in.end()) element = &found->second;
    };
    if (frame && *frame < frames.size()) look(frames[*frame]);
    if (frame) look(shared);
    look(elements);
    if (element == nullptr) return {};
    std::string_view text = bytes.substr(element->offset, element->length);
    text = text.substr(0, text.find('\0'));
    return std::string(trimmed(text));
}

int DicomElements::number(std::string_view bytes, DicomTag tag, int otherwise) const {
    const auto found = elements.find(tag);
    if (found == elements.end() || found->second.length < 2) return otherwise;
    return number_at<std::uint16_t>(bytes, found->second.offset, big_endian);
}

DicomElements read_dicom_elements(std::string_view bytes, DeflatedPart part) {
    return Reader(bytes).read(part);
}

bool starts_as_dicom(std::string_view start) {
    if (has_mark(start)) return true;
    // Without a preamble the first element is a low one of group 2, or of group 8 (the length of
    // the group, the character set, the kind of image), with a type or with a short length.
    constexpr std::size_t head = 8;
    if (start.size() < head) return false;
    const auto group = number_at<std::uint16_t>(start, 0, false);
    const auto element = number_at<std::uint16_t>(start, 2, false);
    const bool is_first = (group == 2 && element <= 2) || (group == 8 && element <= 0x18);
    if (!is_first) return false;
    const auto type = start.substr(4, 2);
    if (std::ranges::find(first_types, type) != first_types.end()) return true;
    constexpr std::uint32_t longest = 128;
    const auto length = number_at<std::uint32_t>(start, 4, false);
    return group == 8 && length > 0 && length <= longest && length % 2 == 0;
}

}  // namespace zeroset
