#pragma once

#include "engine/volume/files/dicom_elements.hpp"
#include "engine/volume/samples.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// How many rows of samples a slice has, which only files of pictures tell.
inline constexpr DicomTag row_count = 0x00280010;
/// How many numbers there are at each point.
inline constexpr DicomTag samples_per_pixel = 0x00280002;

/// The bytes of a file of DICOM with its elements.
struct DicomHeader {
    std::string bytes;
    DicomElements elements;
    std::optional<std::size_t> frame = {};  ///< the slice of which it is asked

    [[nodiscard]] std::string text(DicomTag tag) const { return elements.text(bytes, tag, frame); }
    [[nodiscard]] int number(DicomTag tag, int otherwise) const {
        return elements.number(bytes, tag, otherwise);
    }
    /// The `count` finite numbers of an element, or nothing where it does not hold just these.
    [[nodiscard]] std::optional<std::vector<double>> numbers(DicomTag tag, std::size_t count) const;
    /// Takes a number where there is one; what is wrong with it, or nothing.
    std::string take(DicomTag tag, const char* name, double& number) const;
};

/// Reads a file's bytes and elements; `elements.problem` is what is wrong with it.
DicomHeader read_dicom_header(const std::filesystem::path& file);

/// How many slices a file has.
Expected<std::uint64_t> frames_of(const DicomHeader& header);

}  // namespace zeroset
