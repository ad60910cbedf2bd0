#include "engine/mesh/files/mesh_file.hpp"

#include "engine/base/text.hpp"
#include "engine/mesh/files/encoders.hpp"

#include <algorithm>

namespace zeroset {
namespace {

constexpr std::array formats{
    MeshFormat{.ending = ".stl",
               .name = "STL, binary",
               .holds_colors = false,
               .holds_objects = false,
               .holds_normals = false,
               .unit = "mm",
               .encode = encode_stl},
    MeshFormat{.ending = ".3mf",
               .name = "3MF",
               .holds_colors = true,
               .holds_objects = true,
               .holds_normals = false,
               .unit = "mm",
               .encode = encode_3mf},
    MeshFormat{.ending = ".ply",
               .name = "PLY, binary",
               .holds_colors = true,
               .holds_objects = false,
               .holds_normals = true,
               .unit = "mm",
               .encode = encode_ply},
    MeshFormat{.ending = ".obj",
               .name = "Wavefront OBJ",
               .holds_colors = false,
               .holds_objects = true,
               .holds_normals = true,
               .unit = "mm",
               .encode = encode_obj},
    MeshFormat{.ending = ".glb",
               .name = "glTF 2.0, binary",
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
