#include "engine/volume/files/dicom_header.hpp"

#include "engine/base/text.hpp"
#include "engine/volume/files/sample_file.hpp"

#include <cmath>
#include <fstream>
#include <iterator>
#include <string_view>

namespace zeroset {

std::optional<std::vector<double>> DicomHeader::numbers(DicomTag tag, std::size_t count) const {
    const std::string all = text(tag);
    std::vector<double> numbers;
    for (const std::string_view part : split(all, '\\')) {
        const auto number = number_from<double>(part);
        if (!number || !std::isfinite(*number)) return std::nullopt;
        numbers.push_back(*number);
    }
    if (numbers.size() != count) return std::nullopt;
    return numbers;
}

std::string DicomHeader::take(DicomTag tag, const char* name, double& number) const {
    if (text(tag).empty()) return {};
    const auto read = numbers(tag, 1);
    if (!read) return wrong_field(name, text(tag), "a number is wanted");
    number = read->front();
    return {};
}

DicomHeader read_dicom_header(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    DicomHeader header{.bytes = {std::istreambuf_iterator<char>(stream), {}}, .elements = {}};
    if (!stream) {
        header.elements.problem = "it cannot be read";
        return header;
    }
    header.elements = read_dicom_elements(header.bytes);
    const std::size_t from = header.elements.deflated_from;
    if (from == 0) return header;
    constexpr std::uint64_t most = std::uint64_t{1} << 32U;
    const auto rest =
        unpacked_bytes(std::string_view(header.bytes).substr(from), most, PackedAs::Deflate);
    if (!rest) {
        header.elements.problem = "what is packed in it is damaged";
        return header;
    }
    header.bytes = header.bytes.substr(0, from) + *rest;
    header.elements = read_dicom_elements(header.bytes, DeflatedPart::Unpacked);
    return header;
}

Expected<std::uint64_t> frames_of(const DicomHeader& header) {
    constexpr DicomTag number_of_frames = 0x00280008;
    constexpr double most = 1U << 24U;
    double frames = 1;
    const std::string problem = header.take(number_of_frames, "NumberOfFrames", frames);
    if (!problem.empty()) return std::unexpected(problem);
    if (!(frames >= 1 && frames <= most && frames == std::floor(frames))) {
        return std::unexpected(wrong_field("NumberOfFrames", header.text(number_of_frames),
                                           "a whole number from 1 on is wanted"));
    }
    return static_cast<std::uint64_t>(frames);
}

}  // namespace zeroset
