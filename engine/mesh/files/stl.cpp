#include "engine/base/translation.hpp"
#include "engine/mesh/files/bytes.hpp"
#include "engine/mesh/files/corner_normals.hpp"
#include "engine/mesh/files/encoders.hpp"

#include <limits>

namespace zeroset {

EncodedMesh encode_stl(const MeshFile& file) {
    constexpr std::size_t header_bytes = 80;
    constexpr std::size_t triangle_bytes = 50;
    std::size_t triangles = 0;
    for (const MeshObject& object : file.objects)
        triangles += object.mesh.triangles.size();
    if (triangles > std::numeric_limits<std::uint32_t>::max())
        return std::unexpected(tr("an STL file holds at most 4294967295 triangles"));
    ByteWriter out(header_bytes + 4 + triangle_bytes * triangles);
    // Readers take a header that begins with "solid" for a text file's.
    std::string header = "zeroset";
    for (const std::string& line : file.comment)
        header += "; " + line;
    out.put_text(std::string_view(header).substr(0, header_bytes));
    out.pad_to(header_bytes, std::byte{' '});
    out.put(static_cast<std::uint32_t>(triangles));
    for (const MeshObject& object : file.objects) {
        for (const Triangle& triangle : object.mesh.triangles) {
            out.put_floats(face_normal(object.mesh, triangle));
            for (const std::uint32_t v : triangle)
                out.put_floats(file.mm_per_unit * object.mesh.vertices[v].point);
            out.put(std::uint16_t{0});
        }
    }
    return out.take();
}

}  // namespace zeroset
