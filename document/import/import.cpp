#include "document/import/import.hpp"

#include "document/import/cannot_open.hpp"
#include "document/import/readers.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

namespace zeroset {
namespace {

namespace fs = std::filesystem;

/// A reader whose texts name no files.
template <ReadImport (*read)(std::string_view)>
ReadImport alone(std::string_view bytes, const FieldSource* /*files*/) {
    return read(bytes);
}

constexpr std::array formats{
    ImportFormat{.name = "SURFER", .endings = ".jsurf", .read = alone<read_jsurf>},
    ImportFormat{.name = "surf", .endings = ".pic .surf", .read = alone<read_surf_script>},
    ImportFormat{.name = "MathMod", .endings = ".js", .read = alone<read_mathmod>},
    ImportFormat{.name = "K3DSurf", .endings = ".k3ds", .read = alone<read_k3ds>},
    ImportFormat{.name = "Fidget, libfive", .endings = ".vm", .read = alone<read_instructions>},
    ImportFormat{.name = "ImpVis", .endings = ".toml", .read = alone<read_impvis>},
    ImportFormat{
        .name = "3MF", .endings = ".3mf", .read = alone<read_three_mf>, .largest = 64U << 20U},
    ImportFormat{.name = "formulas", .endings = ".txt", .read = read_formulas},
    ImportFormat{.name = "POV-Ray", .endings = ".pov .inc", .read = alone<read_pov>},
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

/// `name` without blanks and signs that a list of names could not show.
std::string clean_name(std::string_view name) {
    std::string result;
    for (const char letter : trimmed(name))
        result += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
    return result.substr(0, 100);
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
    const ImportFormat* const format = import_format(file_name);
    if (format == nullptr) return import_error(0, tr("it is no file of a format that is read"));
    if (bytes.size() > format->largest) return import_error(0, tr("it is too large"));
    ReadImport imported = format->read(bytes, files.get());
    if (!imported) return imported;
    const std::string stem = fs::path(file_name).stem().string();
    for (ImportedDocument& document : imported->documents) {
        document.name = clean_name(document.name);
        if (document.name.empty()) document.name = stem;
        document.document.files = files;
        check_rows(document);
    }
    return imported;
}

ReadImport load_import(const fs::path& path, const std::shared_ptr<const FieldSource>& files) {
    const ImportFormat* const format = import_format(path.filename().string());
    const auto bytes = bytes_of(path, format ? format->largest : largest_script);
    if (!bytes) return cannot_open(path, bytes.error());
    ReadImport imported = read_import(path.filename().string(), *bytes, files);
    if (!imported) return cannot_open(path, imported.error());
    return imported;
}

}  // namespace zeroset
