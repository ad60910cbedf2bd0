#pragma once

#include "engine/mesh/triangle_mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// Red, green and blue as a screen shows them, 0 to 255.
using MeshColor = std::array<std::uint8_t, 3>;

/// One surface in a file.
struct MeshObject {
    std::string name;
    TriangleMesh mesh;
    MeshColor color{200, 200, 200};
    std::vector<MeshColor> colors = {};  ///< of each vertex; none: all have `color`
};

/// All that a file holds.
struct MeshFile {
    std::vector<MeshObject> objects;
    double mm_per_unit = 1.0;
    std::vector<std::string> comment = {};  ///< lines of ASCII
};

/// Units of files, in those of millimetres: of STL, PLY, OBJ and 3MF, of glTF.
inline constexpr std::array mesh_file_units{1.0, 1e-3};

/// A kind of file for meshes.
struct MeshFormat {
    std::string_view ending;  ///< with its dot, in small letters
    std::string_view name;
    std::string_view about;  ///< what it is good for
    bool holds_colors, holds_objects, holds_normals;
    std::string_view unit;  ///< of its coordinates
    /// The file's bytes; an error is why they could not be made.
    std::expected<std::vector<std::byte>, std::string> (*encode)(const MeshFile& file);
};

/// All of them; the first is the usual one.
std::span<const MeshFormat> mesh_formats();
/// The format of a file by its ending; nullptr: there is none.
const MeshFormat* mesh_format_of(const std::filesystem::path& path);

}  // namespace zeroset
