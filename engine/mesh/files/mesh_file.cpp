#include "engine/mesh/files/mesh_file.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/mesh/files/encoders.hpp"

#include <algorithm>

namespace zeroset {
namespace {

constexpr std::array formats{
    MeshFormat{.ending = ".stl",
               .name = "STL, binary",
               .about = marked("shape alone: every printer takes it"),
               .holds_colors = false,
               .holds_objects = false,
               .holds_normals = false,
               .unit = "mm",
               .encode = encode_stl},
    MeshFormat{.ending = ".3mf",
               .name = "3MF",
               .about = marked("for printers: millimetres, colors, several surfaces"),
               .holds_colors = true,
               .holds_objects = true,
               .holds_normals = false,
               .unit = "mm",
               .encode = encode_3mf},
    MeshFormat{.ending = ".ply",
               .name = "PLY, binary",
               .about = marked("colors at every vertex"),
               .holds_colors = true,
               .holds_objects = false,
               .holds_normals = true,
               .unit = "mm",
               .encode = encode_ply},
    MeshFormat{.ending = ".obj",
               .name = "Wavefront OBJ",
               .about = marked("every 3D program takes it"),
               .holds_colors = false,
               .holds_objects = true,
               .holds_normals = true,
               .unit = "mm",
               .encode = encode_obj},
    MeshFormat{.ending = ".glb",
               .name = "glTF 2.0, binary",
               .about = marked("for the web and for 3D programs, with colors"),
               .holds_colors = true,
               .holds_objects = true,
               .holds_normals = true,
               .unit = "m",
               .encode = encode_glb},
};

}  // namespace

std::span<const MeshFormat> mesh_formats() { return formats; }

const MeshFormat* mesh_format_of(const std::filesystem::path& path) {
    const std::string ending = lower_case(path.extension().string());
    const auto* const found = std::ranges::find(formats, ending, &MeshFormat::ending);
    return found == formats.end() ? nullptr : found;
}

}  // namespace zeroset
