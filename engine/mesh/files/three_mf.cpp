#include "engine/base/translation.hpp"
#include "engine/mesh/files/encoders.hpp"
#include "engine/mesh/files/number_text.hpp"

#include <zip.h>

#include <map>
#include <memory>

// 3MF: core specification 1.3, materials and properties extension 1.2 (3mf.io).

namespace zeroset {
namespace {

constexpr const char* content_types =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";
constexpr const char* relations =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

std::string escaped(const std::string& text) {
    std::string result;
    for (const char letter : text) {
        switch (letter) {
            case '&': result += "&amp;"; break;
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '"': result += "&quot;"; break;
            default: result += letter;
        }
    }
    return result;
}

std::string hex_of(const MeshColor& color) {
    constexpr const char* digits = "0123456789ABCDEF";
    std::string text = "#";
    for (const std::uint8_t channel : color) {
        text += digits[channel >> 4U];
        text += digits[channel & 15U];
    }
    return text;
}

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
        text += escaped(line) + "\n";
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
            object_id + R"(" type="model" name=")" + escaped(file.objects[i].name) + R"(" pid=")" +
            colors_id + R"(" pindex="0">)";
        append_mesh(text, file, file.objects[i], group);
        text += "</object>\n";
        items += "<item objectid=\"" + object_id + "\"/>";
    }
    return text + "</resources>\n<build>" + items + "</build>\n</model>\n";
}

struct CloseSource {
    void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, CloseSource>;

/// Adds a file whose text outlives the archive; whether that worked.
bool add_file(zip_t* archive, const char* name, const std::string& text) {
    zip_source_t* const source = zip_source_buffer(archive, text.data(), text.size(), 0);
    if (source == nullptr) return false;
    if (zip_file_add(archive, name, source, ZIP_FL_ENC_UTF_8) >= 0) return true;
    zip_source_free(source);
    return false;
}

std::expected<std::vector<std::byte>, std::string> bytes_of(zip_source_t* source) {
    zip_stat_t stat;
    if (zip_source_stat(source, &stat) != 0 || zip_source_open(source) != 0)
        return std::unexpected(zip_error_strerror(zip_source_error(source)));
    std::vector<std::byte> bytes(stat.size);
    const zip_int64_t read = zip_source_read(source, bytes.data(), bytes.size());
    zip_source_close(source);
    if (read != static_cast<zip_int64_t>(bytes.size()))
        return std::unexpected(tr("the archive is cut"));
    return bytes;
}

}  // namespace

EncodedMesh encode_3mf(const MeshFile& file) {
    const std::string model = model_of(file);
    const std::string types = content_types;
    const std::string links = relations;
    zip_error_t error;
    zip_error_init(&error);
    const Source source(zip_source_buffer_create(nullptr, 0, 0, &error));
    if (!source) return std::unexpected(zip_error_strerror(&error));
    zip_source_keep(source.get());  // it outlives the archive, which would free it
    zip_t* const archive = zip_open_from_source(source.get(), ZIP_TRUNCATE, &error);
    if (archive == nullptr) {
        zip_source_free(source.get());
        return std::unexpected(zip_error_strerror(&error));
    }
    const bool added = add_file(archive, "[Content_Types].xml", types) &&
                       add_file(archive, "_rels/.rels", links) &&
                       add_file(archive, "3D/3dmodel.model", model);
    if (!added || zip_close(archive) != 0) {
        const std::string reason = zip_strerror(archive);
        zip_discard(archive);
        return std::unexpected(reason);
    }
    return bytes_of(source.get());
}

}  // namespace zeroset
