#include "document/json/document_file.hpp"

#include "document/import/cannot_open.hpp"
#include "document/import/import_choice.hpp"
#include "document/json/document_json.hpp"
#include "engine/base/translation.hpp"
#include "engine/export/pictures/picture_writer.hpp"
#include "engine/export/png.hpp"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

namespace fs = std::filesystem;

/// Files larger than this, in bytes, are not read as documents.
constexpr std::uintmax_t largest_file = 64U << 20U;

std::string note_of(const std::vector<std::string>& unknown) {
    if (unknown.empty()) return {};
    std::string names;
    for (const std::string& name : unknown)
        names += (names.empty() ? "" : " ") + name;
    return filled(tr("not understood, and lost when it is saved: {0}"), {names});
}

std::expected<std::string, std::string> text_of_file(const fs::path& path) {
    std::error_code error;
    if (fs::file_size(path, error) > largest_file) return std::unexpected(tr("it is too large"));
    std::ifstream file(path, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(file), {});
    if (!file) return std::unexpected(std::generic_category().message(errno));
    return text;
}

/// The beginning of a picture: the session is before the pixels, so that no more need be read.
std::expected<std::vector<std::byte>, std::string> begin_of_picture(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::error_code error;
    std::vector<std::byte> bytes(std::min(fs::file_size(path, error), largest_file));
    if (error || !file) return std::unexpected(std::generic_category().message(errno));
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!file) return std::unexpected(std::generic_category().message(errno));
    return bytes;
}

std::expected<std::string, std::string> session_of_picture(const fs::path& path) {
    const auto bytes = begin_of_picture(path);
    if (!bytes) return std::unexpected(bytes.error());
    auto session = text_in_png(*bytes, document_keyword);
    if (!session) return std::unexpected(tr("the picture holds no session of Zeroset"));
    return *session;
}

std::expected<LoadedDocument, std::string> imported_document(
    const fs::path& path, const std::shared_ptr<const FieldSource>& files) {
    auto imported = load_imported(import_place(path.string()), files);
    if (!imported) return std::unexpected(imported.error());
    return LoadedDocument{.document = std::move(imported->document),
                          .note = notes_listed(imported->notes),
                          .shown_on = std::nullopt,
                          .is_source = true};
}

}  // namespace

bool is_picture_name(const std::string& name) { return name.ends_with(".png"); }

bool is_document_name(const std::string& name) { return name.ends_with(document_ending); }

std::expected<LoadedDocument, std::string> load_document(
    const fs::path& path, const std::shared_ptr<const FieldSource>& files) {
    if (is_import_path(path.string())) return imported_document(path, files);
    std::error_code error;
    if (!fs::exists(path, error)) return cannot_open(path, tr("there is no such file"));
    if (!fs::is_regular_file(path, error)) return cannot_open(path, tr("it is no file"));
    const bool from_picture = is_picture_name(path.string());
    auto text = from_picture ? session_of_picture(path) : text_of_file(path);
    if (!text) return cannot_open(path, text.error());
    auto read = document_from(*text);
    if (!read) return cannot_open(path, read.error());
    read->document.files = files;
    return LoadedDocument{.document = std::move(read->document),
                          .note = note_of(read->unknown),
                          .shown_on = read->shown_on,
                          .is_source = from_picture};
}

bool holds_picture_of(const fs::path& path, const Document& document, glm::ivec2 size_px) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) return false;
    const auto bytes = begin_of_picture(path);
    if (!bytes) return false;
    const auto size = size_of_png(*bytes);
    return size && std::cmp_equal(size->width, size_px.x) &&
           std::cmp_equal(size->height, size_px.y) &&
           text_in_png(*bytes, document_keyword) == text_of(document);
}

std::expected<void, FileError> save_document(const fs::path& path, const Document& document,
                                             const std::optional<Background>& shown_on) {
    return write_text(path.string(), text_of(document, shown_on));
}

}  // namespace zeroset
