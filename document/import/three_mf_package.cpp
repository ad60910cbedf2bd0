#include "document/import/three_mf_package.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <pugixml.hpp>
#include <zip.h>

#include <memory>
#include <optional>

namespace zeroset {
namespace {

constexpr std::size_t largest_model = 64U << 20U;

struct ZipClosed {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct ZipFileClosed {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};

/// The text of a part; nothing is allocated on the word of its header. Nothing where it is larger
/// than any model.
std::optional<std::string> part_of(zip_t* archive, zip_uint64_t index) {
    const std::unique_ptr<zip_file_t, ZipFileClosed> file(zip_fopen_index(archive, index, 0));
    std::string text;
    std::string block(1U << 16U, '\0');
    while (file) {
        const zip_int64_t read = zip_fread(file.get(), block.data(), block.size());
        if (read <= 0) break;
        text.append(block.data(), static_cast<std::size_t>(read));
        if (text.size() > largest_model) return std::nullopt;
    }
    return text;
}

/// The name of the model that the package's relationships tell of; empty where they tell of none.
std::string root_model(zip_t* archive) {
    const zip_int64_t at = zip_name_locate(archive, "_rels/.rels", ZIP_FL_NOCASE);
    if (at < 0) return {};
    const auto text = part_of(archive, static_cast<zip_uint64_t>(at));
    pugi::xml_document xml;
    if (text) xml.load_buffer(text->data(), text->size());
    for (const pugi::xml_node& list : xml.children()) {
        for (const pugi::xml_node& relation : list.children()) {
            const std::string_view type = relation.attribute("Type").value();
            std::string_view target = relation.attribute("Target").value();
            if (!type.ends_with("/3dmodel")) continue;
            while (target.starts_with('/'))
                target.remove_prefix(1);
            return std::string(target);
        }
    }
    return {};
}

/// The model that is the package's root, else the first part whose name ends in .model.
zip_int64_t model_index(zip_t* archive) {
    const std::string root = root_model(archive);
    const zip_int64_t told =
        root.empty() ? -1 : zip_name_locate(archive, root.c_str(), ZIP_FL_NOCASE);
    if (told >= 0) return told;
    const zip_int64_t count = zip_get_num_entries(archive, 0);
    for (zip_int64_t i = 0; i < count; ++i) {
        const char* const name = zip_get_name(archive, static_cast<zip_uint64_t>(i), 0);
        if (name != nullptr && lower_case(name).ends_with(".model")) return i;
    }
    return -1;
}

}  // namespace

std::expected<std::string, std::string> model_of_package(std::string_view bytes) {
    zip_error_t error{};
    zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    if (source == nullptr) return std::unexpected(tr("it is no package of 3MF"));
    const std::unique_ptr<zip_t, ZipClosed> archive(
        zip_open_from_source(source, ZIP_RDONLY, &error));
    if (!archive) {
        zip_source_free(source);
        return std::unexpected(tr("it is no package of 3MF"));
    }
    const zip_int64_t index = model_index(archive.get());
    if (index < 0) return std::unexpected(tr("it is no package of 3MF: it has no model"));
    auto text = part_of(archive.get(), static_cast<zip_uint64_t>(index));
    if (!text) return std::unexpected(tr("it is too large"));
    return *std::move(text);
}

}  // namespace zeroset
