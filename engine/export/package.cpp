#include "engine/export/package.hpp"

#include "engine/base/translation.hpp"

#include <zip.h>

#include <memory>

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

std::expected<std::vector<std::byte>, std::string> package_of_3mf(const std::string& model) {
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

std::string xml_escaped(std::string_view text) {
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

std::string hex_of(const std::array<std::uint8_t, 3>& color) {
    constexpr const char* digits = "0123456789ABCDEF";
    std::string text = "#";
    for (const std::uint8_t channel : color) {
        text += digits[channel >> 4U];
        text += digits[channel & 15U];
    }
    return text;
}

}  // namespace zeroset
