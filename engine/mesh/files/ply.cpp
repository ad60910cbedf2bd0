#include "engine/base/translation.hpp"
#include "engine/mesh/files/bytes.hpp"
#include "engine/mesh/files/corner_normals.hpp"
#include "engine/mesh/files/encoders.hpp"

namespace zeroset {
namespace {

std::string header_of(const MeshFile& file, std::size_t vertices, std::size_t triangles) {
    std::string text = "ply\nformat binary_little_endian 1.0\n";
    for (const std::string& line : file.comment)
        text += "comment " + line + "\n";
    text += "comment millimetres; quality: the measured distance from the surface\n";
    text += "element vertex " + std::to_string(vertices) + "\n";
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
        text += std::string("property float ") + name + "\n";
    for (const char* name : {"red", "green", "blue"})
        text += std::string("property uchar ") + name + "\n";
    text += "property float quality\n";
    text += "element face " + std::to_string(triangles) + "\n";
    return text + "property list uchar int vertex_indices\nend_header\n";
}

void put_vertices(const MeshFile& file, const MeshObject& object, ByteWriter& out) {
    const std::vector<glm::dvec3> normals = vertex_normals(object.mesh);
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const MeshVertex& vertex = object.mesh.vertices[v];
        out.put_floats(file.mm_per_unit * vertex.point);
        out.put_floats(normals[v]);
        for (const std::uint8_t channel : object.colors.empty() ? object.color : object.colors[v])
            out.put(channel);
        out.put(static_cast<float>(file.mm_per_unit * double{vertex.error}));
    }
}

}  // namespace

EncodedMesh encode_ply(const MeshFile& file) {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    for (const MeshObject& object : file.objects) {
        vertices += object.mesh.vertices.size();
        triangles += object.mesh.triangles.size();
    }
    if (vertices > 0x7FFFFFFFU)
        return std::unexpected(tr("a PLY file of this kind holds at most 2147483647 vertices"));
    ByteWriter out(31 * vertices + 13 * triangles + 1000);
    out.put_text(header_of(file, vertices, triangles));
    for (const MeshObject& object : file.objects)
        put_vertices(file, object, out);
    std::uint32_t first = 0;
    for (const MeshObject& object : file.objects) {
        for (const Triangle& triangle : object.mesh.triangles) {
            out.put(std::uint8_t{3});
            for (const std::uint32_t v : triangle)
                out.put(first + v);
        }
        first += static_cast<std::uint32_t>(object.mesh.vertices.size());
    }
    return out.take();
}

}  // namespace zeroset
