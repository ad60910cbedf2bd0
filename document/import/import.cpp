#include "document/import/import.hpp"

#include "document/import/cannot_open.hpp"
#include "document/import/plain_text.hpp"
#include "document/import/readers.hpp"
#include "engine/base/file_stamp.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>

namespace zeroset {
namespace {

namespace fs = std::filesystem;

/// A reader whose texts name no files.
template <ReadImport (*read)(std::string_view)>
ReadImport alone(std::string_view bytes, const ImportFiles& /*files*/) {
    return read(bytes);
}

constexpr std::array formats{
    ImportFormat{.name = "SURFER", .endings = ".jsurf", .read = alone<read_jsurf>},
    ImportFormat{.name = "surf", .endings = ".pic .surf", .read = alone<read_surf_script>},
    ImportFormat{.name = "MathMod", .endings = ".js", .read = alone<read_mathmod>},
    ImportFormat{.name = "K3DSurf", .endings = ".k3ds", .read = alone<read_k3ds>},
    ImportFormat{.name = "Fidget, libfive", .endings = ".vm", .read = alone<read_instructions>},
    ImportFormat{.name = "ImpVis", .endings = ".toml", .read = alone<read_impvis>},
    ImportFormat{.name = "3MF",
                 .endings = ".3mf",
                 .read = alone<read_three_mf>,
                 .is_text = false,
                 .largest = 64U << 20U},
    ImportFormat{.name = "formulas", .endings = ".txt", .read = read_formulas},
    ImportFormat{.name = "POV-Ray", .endings = ".pov .inc", .read = read_pov},
};

std::expected<std::string, std::string> bytes_of(const fs::path& path, std::size_t largest) {
    std::error_code error;
    if (!fs::exists(path, error)) return std::unexpected(tr("there is no such file"));
    if (!fs::is_regular_file(path, error)) return std::unexpected(tr("it is no file"));
    if (fs::file_size(path, error) > largest) return std::unexpected(tr("it is too large"));
    std::ifstream file(path, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(file), {});
    if (!file) return std::unexpected(std::generic_category().message(errno));
    return bytes;
}

/// The text of a file in a folder or in those below it. Links and ".." that lead out of it are not
/// followed, so that a scene reads nothing that lies elsewhere.
std::optional<std::string> text_below(const fs::path& folder, std::string_view name) {
    std::string path(name);
    std::ranges::replace(path, '\\', '/');
    std::error_code error;
    const fs::path root = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, error);
    const fs::path file = fs::weakly_canonical(root / path, error);
    if (!is_within(file, root)) return std::nullopt;
    const auto bytes = bytes_of(file, largest_script);
    return bytes ? std::optional(plain_text(*bytes)) : std::nullopt;
}

/// `name` without blanks and signs that a list of names could not show.
std::string clean_name(std::string_view name) {
    std::string result;
    for (const char letter : trimmed(name))
        result += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
    return result.substr(0, 100);
}

/// Reads the bytes of a file of this name; see read_import.
ReadImport read_bytes(std::string_view file_name, std::string_view bytes,
                      const std::shared_ptr<const FieldSource>& fields, const ImportFiles& files) {
    const ImportFormat* const format = import_format(file_name);
    if (format == nullptr) return import_error(0, tr("it is no file of a format that is read"));
    if (bytes.size() > format->largest) return import_error(0, tr("it is too large"));
    ReadImport imported =
        format->is_text ? format->read(plain_text(bytes), files) : format->read(bytes, files);
    if (!imported) return imported;
    const std::string stem = fs::path(file_name).stem().string();
    for (ImportedDocument& document : imported->documents) {
        document.name = clean_name(document.name);
        if (document.name.empty()) document.name = stem;
        document.document.files = fields;
        check_rows(document);
    }
    return imported;
}

}  // namespace

const ImportFormat* import_format(std::string_view file_name) {
    const std::string name = lower_case(file_name);
    for (const ImportFormat& format : formats) {
        for (const std::string_view ending : split(format.endings, ' '))
            if (name.ends_with(ending) && name.size() > ending.size()) return &format;
    }
    return nullptr;
}

bool is_import_name(std::string_view file_name) { return import_format(file_name) != nullptr; }

std::string import_endings() {
    std::string all;
    for (const ImportFormat& format : formats)
        all += (all.empty() ? "" : " ") + std::string(format.endings);
    return all;
}

ReadImport read_import(std::string_view file_name, std::string_view bytes,
                       const std::shared_ptr<const FieldSource>& files) {
    return read_bytes(file_name, bytes, files, {.fields = files.get()});
}

ReadImport load_import(const fs::path& path, const std::shared_ptr<const FieldSource>& files) {
    const ImportFormat* const format = import_format(path.filename().string());
    const auto bytes = bytes_of(path, format ? format->largest : largest_script);
    if (!bytes) return cannot_open(path, bytes.error());
    const auto text_beside = [&](std::string_view name) {
        return text_below(path.parent_path(), name);
    };
    ReadImport imported = read_bytes(path.filename().string(), *bytes, files,
                                     {.fields = files.get(), .text_beside = text_beside});
    if (!imported) return cannot_open(path, imported.error());
    return imported;
}

}  // namespace zeroset
