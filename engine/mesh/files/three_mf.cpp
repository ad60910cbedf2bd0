#include "engine/export/package.hpp"
#include "engine/mesh/files/encoders.hpp"
#include "engine/mesh/files/number_text.hpp"

#include <map>

// 3MF: core specification 1.3, materials and properties extension 1.2 (3mf.io).

namespace zeroset {
namespace {

/// The colours of an object, each once, and which of them each vertex has.
struct ColorGroup {
    std::vector<MeshColor> colors;
    std::vector<std::uint32_t> of_vertex;  ///< none: all have the first
};

ColorGroup group_of(const MeshObject& object) {
    if (object.colors.empty()) return {.colors = {object.color}, .of_vertex = {}};
    ColorGroup group;
    std::map<MeshColor, std::uint32_t> known;
    for (const MeshColor& color : object.colors) {
        const auto next = static_cast<std::uint32_t>(group.colors.size());
        const auto [found, fresh] = known.emplace(color, next);
        if (fresh) group.colors.push_back(color);
        group.of_vertex.push_back(found->second);
    }
    return group;
}

void append_attribute(std::string& text, const char* name, auto value) {
    text += name;
    append_number(text, value);
    text += '"';
}

void append_mesh(std::string& text, const MeshFile& file, const MeshObject& object,
                 const ColorGroup& group) {
    text += "<mesh><vertices>\n";
    for (const MeshVertex& vertex : object.mesh.vertices) {
        const glm::vec3 point(file.mm_per_unit * vertex.point);
        append_attribute(text, "<vertex x=\"", point.x);
        append_attribute(text, " y=\"", point.y);
        append_attribute(text, " z=\"", point.z);
        text += "/>\n";
    }
    text += "</vertices><triangles>\n";
    for (const Triangle& t : object.mesh.triangles) {
        append_attribute(text, "<triangle v1=\"", t[0]);
        append_attribute(text, " v2=\"", t[1]);
        append_attribute(text, " v3=\"", t[2]);
        if (!group.of_vertex.empty()) {
            append_attribute(text, " p1=\"", group.of_vertex[t[0]]);
            append_attribute(text, " p2=\"", group.of_vertex[t[1]]);
            append_attribute(text, " p3=\"", group.of_vertex[t[2]]);
        }
        text += "/>\n";
    }
    text += "</triangles></mesh>";
}

std::string model_of(const MeshFile& file) {
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en-US\" "
        "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
        "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\">\n"
        "<metadata name=\"Application\">Zeroset</metadata>\n<metadata name=\"Description\">";
    for (const std::string& line : file.comment)
        text += xml_escaped(line) + "\n";
    text += "</metadata>\n<resources>\n";
    std::string items;
    for (std::size_t i = 0; i < file.objects.size(); ++i) {
        const std::string colors_id = std::to_string(2 * i + 1);
        const std::string object_id = std::to_string(2 * i + 2);
        const ColorGroup group = group_of(file.objects[i]);
        text += "<m:colorgroup id=\"" + colors_id + "\">\n";
        for (const MeshColor& color : group.colors)
            text += "<m:color color=\"" + hex_of(color) + "\"/>\n";
        text +=
            "</m:colorgroup>\n"
            R"(<object id=")" +
            object_id + R"(" type="model" name=")" + xml_escaped(file.objects[i].name) +
            R"(" pid=")" + colors_id + R"(" pindex="0">)";
        append_mesh(text, file, file.objects[i], group);
        text += "</object>\n";
        items += "<item objectid=\"" + object_id + "\"/>";
    }
    return text + "</resources>\n<build>" + items + "</build>\n</model>\n";
}

}  // namespace

EncodedMesh encode_3mf(const MeshFile& file) { return package_of_3mf(model_of(file)); }

}  // namespace zeroset
