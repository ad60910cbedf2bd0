#include "engine/base/translation.hpp"
#include "engine/mesh/files/bytes.hpp"
#include "engine/mesh/files/corner_normals.hpp"
#include "engine/mesh/files/encoders.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

// glTF 2.0, sections 3.6 (buffers), 3.7 (meshes), 4 (GLB).

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;

constexpr int type_float = 5126;
constexpr int type_byte = 5121;
constexpr int type_index = 5125;
constexpr int array_buffer = 34962;
constexpr int index_buffer = 34963;

/// z up to y up.
glm::dvec3 turned(const glm::dvec3& v) { return {v.x, v.z, -v.y}; }

/// Vertices as viewers want them: one for each normal.
struct ViewedMesh {
    std::vector<glm::vec3> points, normals;
    std::vector<std::uint32_t> sources;  ///< which vertex of the mesh each is
    std::vector<std::uint32_t> indices;
};

void add_vertex(ViewedMesh& viewed, const TriangleMesh& mesh, std::uint32_t v,
                const glm::dvec3& normal, double metres_per_unit) {
    const glm::dvec3 shown = normal == glm::dvec3(0.0) ? glm::dvec3(0.0, 0.0, 1.0) : normal;
    viewed.points.emplace_back(turned(metres_per_unit * mesh.vertices[v].point));
    viewed.normals.emplace_back(turned(shown));
    viewed.sources.push_back(v);
}

ViewedMesh viewed_mesh(const TriangleMesh& mesh, double metres_per_unit) {
    ViewedMesh viewed;
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v)
        add_vertex(viewed, mesh, v, mesh.vertices[v].normal, metres_per_unit);
    for (const Triangle& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            std::uint32_t v = triangle[k];
            if (!is_round(mesh.vertices[v])) {
                v = static_cast<std::uint32_t>(viewed.points.size());
                add_vertex(viewed, mesh, triangle[k], corner_normal(mesh, triangle, k),
                           metres_per_unit);
            }
            viewed.indices.push_back(v);
        }
    }
    return viewed;
}

/// The file's two chunks.
class GlbWriter {
public:
    void add(const MeshObject& object, double metres_per_unit);
    std::vector<std::byte> finish(const std::vector<std::string>& comment);

private:
    std::size_t accessor(std::size_t first_byte, int target, const Json& about) {
        json_["bufferViews"].push_back({{"buffer", 0},
                                        {"byteOffset", first_byte},
                                        {"byteLength", data_.size() - first_byte},
                                        {"target", target}});
        Json item = about;
        item["bufferView"] = json_["bufferViews"].size() - 1;
        json_["accessors"].push_back(item);
        return json_["accessors"].size() - 1;
    }
    std::size_t put_vectors(const std::vector<glm::vec3>& vectors, bool with_ends);
    std::size_t put_colors(const MeshObject& object, const ViewedMesh& viewed);
    std::size_t put_indices(const std::vector<std::uint32_t>& indices);

    Json json_;
    ByteWriter data_;
};

std::size_t GlbWriter::put_vectors(const std::vector<glm::vec3>& vectors, bool with_ends) {
    const std::size_t first = data_.size();
    glm::vec3 lo(std::numeric_limits<float>::max());
    glm::vec3 hi(-std::numeric_limits<float>::max());
    for (const glm::vec3& vector : vectors) {
        data_.put_floats(vector);
        lo = glm::min(lo, vector);
        hi = glm::max(hi, vector);
    }
    Json about{{"componentType", type_float}, {"count", vectors.size()}, {"type", "VEC3"}};
    if (with_ends) {
        about["min"] = {lo.x, lo.y, lo.z};
        about["max"] = {hi.x, hi.y, hi.z};
    }
    return accessor(first, array_buffer, about);
}

/// Colours in linear light, as glTF wants those of vertices.
std::size_t GlbWriter::put_colors(const MeshObject& object, const ViewedMesh& viewed) {
    const std::size_t first = data_.size();
    for (const std::uint32_t v : viewed.sources) {
        for (const std::uint8_t channel : object.colors.empty() ? object.color : object.colors[v]) {
            const double shown = channel / 255.0;
            const double light =
                shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
            data_.put(static_cast<std::uint8_t>(std::lround(255.0 * light)));
        }
        data_.put(std::uint8_t{255});
    }
    return accessor(first, array_buffer,
                    {{"componentType", type_byte},
                     {"normalized", true},
                     {"count", viewed.sources.size()},
                     {"type", "VEC4"}});
}

std::size_t GlbWriter::put_indices(const std::vector<std::uint32_t>& indices) {
    const std::size_t first = data_.size();
    for (const std::uint32_t index : indices)
        data_.put(index);
    return accessor(first, index_buffer,
                    {{"componentType", type_index}, {"count", indices.size()}, {"type", "SCALAR"}});
}

void GlbWriter::add(const MeshObject& object, double metres_per_unit) {
    const ViewedMesh viewed = viewed_mesh(object.mesh, metres_per_unit);
    Json attributes;
    attributes["POSITION"] = put_vectors(viewed.points, true);
    attributes["NORMAL"] = put_vectors(viewed.normals, false);
    attributes["COLOR_0"] = put_colors(object, viewed);
    const std::size_t indices = put_indices(viewed.indices);
    const std::size_t number = json_["meshes"].size();
    json_["meshes"].push_back(
        {{"name", object.name},
         {"primitives",
          Json::array({{{"attributes", attributes}, {"indices", indices}, {"material", 0}}})}});
    json_["nodes"].push_back({{"mesh", number}, {"name", object.name}});
    json_["scenes"][0]["nodes"].push_back(number);
}

std::vector<std::byte> GlbWriter::finish(const std::vector<std::string>& comment) {
    json_["asset"] = {
        {"version", "2.0"}, {"generator", "Zeroset"}, {"extras", {{"comment", comment}}}};
    json_["scene"] = 0;
    json_["materials"] = Json::array(
        {{{"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", 0.6}}}}});
    std::vector<std::byte> data = data_.take();
    json_["buffers"] = Json::array({{{"byteLength", data.size()}}});
    std::string text = json_.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    constexpr std::uint32_t magic = 0x46546C67;
    constexpr std::uint32_t json_chunk = 0x4E4F534A;
    constexpr std::uint32_t data_chunk = 0x004E4942;
    const std::size_t whole = 12 + 8 + text.size() + 8 + data.size();
    ByteWriter out(whole);
    for (const std::size_t number :
         {std::size_t{magic}, std::size_t{2}, whole, text.size(), std::size_t{json_chunk}})
        out.put(static_cast<std::uint32_t>(number));
    out.put_text(text);
    out.put(static_cast<std::uint32_t>(data.size()));
    out.put(data_chunk);
    out.put_text({reinterpret_cast<const char*>(data.data()), data.size()});
    return out.take();
}

}  // namespace

EncodedMesh encode_glb(const MeshFile& file) {
    constexpr double metres_per_mm = mesh_file_units[1];
    GlbWriter writer;
    std::size_t bytes = 0;
    for (const MeshObject& object : file.objects)
        bytes += 120 * object.mesh.triangles.size() + 28 * object.mesh.vertices.size();
    if (bytes > std::numeric_limits<std::uint32_t>::max())
        return std::unexpected(tr("a glb file holds at most 4 GB; ask for fewer triangles"));
    for (const MeshObject& object : file.objects)
        writer.add(object, metres_per_mm * file.mm_per_unit);
    return writer.finish(file.comment);
}

}  // namespace zeroset
