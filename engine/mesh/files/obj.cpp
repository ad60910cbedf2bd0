#include "engine/mesh/files/corner_normals.hpp"
#include "engine/mesh/files/encoders.hpp"
#include "engine/mesh/files/number_text.hpp"

#include <span>

namespace zeroset {
namespace {

void append_vector(std::string& text, const char* word, const glm::dvec3& vector) {
    text += word;
    for (int axis = 0; axis < 3; ++axis) {
        text += ' ';
        append_number(text, static_cast<float>(vector[axis]));
    }
    text += '\n';
}

/// Numbers of the first vertex and the first normal, from 1 on.
struct First {
    std::size_t vertex = 1, normal = 1;
};

void append_faces(std::string& text, const MeshObject& object, const First& first) {
    std::size_t face = first.normal + object.mesh.vertices.size();
    for (const Triangle& triangle : object.mesh.triangles) {
        text += 'f';
        for (const std::uint32_t v : triangle) {
            text += ' ';
            append_number(text, first.vertex + v);
            text += "//";
            append_number(text, is_round(object.mesh.vertices[v]) ? first.normal + v : face);
        }
        text += '\n';
        ++face;
    }
}

}  // namespace

EncodedMesh encode_obj(const MeshFile& file) {
    std::string text;
    for (const std::string& line : file.comment)
        text += "# " + line + "\n";
    text += "# millimetres\n";
    First first;
    for (std::size_t i = 0; i < file.objects.size(); ++i) {
        const MeshObject& object = file.objects[i];
        text += "o surface_" + std::to_string(i + 1) + "\n";
        for (const MeshVertex& vertex : object.mesh.vertices)
            append_vector(text, "v", file.mm_per_unit * vertex.point);
        // The normals of the vertices, then those of the triangles.
        for (const glm::dvec3& normal : vertex_normals(object.mesh))
            append_vector(text, "vn", normal);
        for (const Triangle& triangle : object.mesh.triangles)
            append_vector(text, "vn", face_normal(object.mesh, triangle));
        append_faces(text, object, first);
        first.vertex += object.mesh.vertices.size();
        first.normal += object.mesh.vertices.size() + object.mesh.triangles.size();
    }
    const auto bytes = std::as_bytes(std::span(text));
    return std::vector<std::byte>(bytes.begin(), bytes.end());
}

}  // namespace zeroset
