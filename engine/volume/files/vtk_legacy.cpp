// VTK's older files of structured points
// (docs.vtk.org/en/latest/vtk_file_formats/vtk_legacy_file_format.html).

#include "engine/base/text.hpp"
#include "engine/volume/files/header_text.hpp"
#include "engine/volume/files/sample_file.hpp"
#include "engine/volume/files/volume_file.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

std::optional<SampleType> vtk_type(std::string name) {
    std::ranges::replace(name, '_', ' ');
    if (name == "char") return SampleType::Int8;
    if (name == "long" || name == "vtktypeint64") return SampleType::Int64;
    if (name == "unsigned long" || name == "vtktypeuint64") return SampleType::UInt64;
    return sample_type(name);
}

/// Reads the header line by line, up to where the samples begin.
class VtkLegacy {
public:
    VtkLegacy(std::filesystem::path file, std::string text)
        : file_(std::move(file)), text_(std::move(text)) {}

    Expected<VolumeFile> read() {
        if (!line().starts_with("# vtk DataFile Version"))
            return std::unexpected("it does not begin with '# vtk DataFile Version'");
        line();  // the title
        const std::string encoding = lower_case(without_spaces(line()));
        if (encoding != "ascii" && encoding != "binary")
            return std::unexpected(wrong_field("encoding", encoding, "it is ASCII or BINARY"));
        SampleBlock block{.file = file_, .big_endian = true};
        if (encoding == "ascii") block.encoding = SampleEncoding::Ascii;
        while (!type_) {
            if (at_ == text_.size())
                return std::unexpected(
                    "its header lacks SCALARS, or an array of one number at each point");
            if (auto problem = take(line()); !problem.empty()) return std::unexpected(problem);
        }
        block.offset = at_;
        block.type = *type_;
        for (std::size_t i = 0; i < 3; ++i) {
            if (in_cells_ && size_[i] > 0) --size_[i];
            block.size[i] = size_[i];
            geometry_.world_from_index[i][i] = spacing_[i];
            geometry_.origin[i] = origin_[i] + (in_cells_ ? spacing_[i] / 2 : 0);
        }
        const auto samples = read_samples(block);
        if (!samples) return std::unexpected(samples.error());
        return VolumeFile{.samples = *samples, .geometry = geometry_};
    }

private:
    std::string_view line() {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        const std::string_view line = std::string_view(text_).substr(at_, end - at_);
        at_ = std::min(end + 1, text_.size());
        return line;
    }
    /// Takes a line of the header; what is wrong with it, or nothing.
    std::string take(std::string_view text) {
        const auto words = words_of(text);
        if (words.empty()) return {};
        const std::string name = lower_case(words[0]);
        const std::string_view rest = text.substr(text.find(words[0]) + words[0].size());
        if (name == "dataset" && lower_case(without_spaces(rest)) != "structured_points")
            return wrong_field("DATASET", without_spaces(rest), "STRUCTURED_POINTS are read");
        if (name == "dimensions") return take_three(name, rest, size_);
        if (name == "origin") return take_three(name, rest, origin_);
        if (name == "spacing" || name == "aspect_ratio") return take_three(name, rest, spacing_);
        if (name == "cell_data" || name == "point_data") in_cells_ = name == "cell_data";
        if (name == "scalars") return take_scalars(words);
        if (name == "field") return take_array(words_of(line()));
        constexpr std::array others{"color_scalars", "vectors", "normals", "texture_coordinates",
                                    "tensors"};
        if (std::ranges::find(others, name) != others.end())
            return "its first array is one of " + name + "; a volume has one number at each point";
        return {};
    }
    template <class Number>
    static std::string take_three(const std::string& name, std::string_view text,
                                  std::array<Number, 3>& numbers) {
        const auto found = numbers_in<Number>(text);
        if (!found || found->size() != 3)
            return wrong_field(name, without_spaces(text), "three numbers are wanted");
        std::ranges::copy(*found, numbers.begin());
        return {};
    }
    /// "SCALARS name type" or "SCALARS name type components", and the line of its colours.
    std::string take_scalars(const std::vector<std::string_view>& words) {
        const std::size_t before = at_;
        if (!lower_case(without_spaces(line())).starts_with("lookup_table")) at_ = before;
        return take_type(words.size() > 2 ? words[2] : std::string_view(),
                         words.size() > 3 ? words[3] : "1");
    }
    /// "name components tuples type", the first array of a field.
    std::string take_array(const std::vector<std::string_view>& words) {
        if (words.size() != 4) return "its FIELD has no array";
        return take_type(words[3], words[1]);
    }
    std::string take_type(std::string_view name, std::string_view components) {
        if (components != "1") {
            return "it has " + printable(components) + " numbers at each point; a volume has one";
        }
        type_ = vtk_type(lower_case(name));
        return type_ ? std::string() : wrong_field("type", name, "a number type is wanted");
    }

    std::filesystem::path file_;
    std::string text_;
    std::size_t at_ = 0;
    std::array<std::uint64_t, 3> size_{};
    std::array<double, 3> origin_{}, spacing_{1, 1, 1};
    bool in_cells_ = false;
    std::optional<SampleType> type_;
    Geometry geometry_;
};

}  // namespace

Expected<VolumeFile> read_vtk_legacy(const std::filesystem::path& file) {
    auto text = first_bytes(file, longest_text_header);
    if (!text) return std::unexpected(text.error());
    return VtkLegacy(file, std::move(*text)).read();
}

}  // namespace zeroset
