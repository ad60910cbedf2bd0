#include "document/json/document_file.hpp"

#include "document/json/document_json.hpp"

#include <cerrno>
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

std::unexpected<std::string> cannot_read(const fs::path& path, const std::string& reason) {
    return std::unexpected("cannot open '" + path.string() + "': " + reason);
}

std::string note_of(const std::vector<std::string>& unknown) {
    if (unknown.empty()) return {};
    std::string note = "not understood, and lost when it is saved:";
    for (const std::string& name : unknown)
        note += " " + name;
    return note;
}

}  // namespace

bool is_document_name(const std::string& name) { return name.ends_with(document_ending); }

std::expected<LoadedDocument, std::string> load_document(const fs::path& path) {
    std::error_code error;
    if (!fs::exists(path, error)) return cannot_read(path, "there is no such file");
    if (!fs::is_regular_file(path, error)) return cannot_read(path, "it is no file");
    if (fs::file_size(path, error) > largest_file) return cannot_read(path, "it is too large");
    std::ifstream file(path, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    if (!file) return cannot_read(path, std::generic_category().message(errno));
    auto read = document_from(text);
    if (!read) return cannot_read(path, read.error());
    return LoadedDocument{.document = std::move(read->document), .note = note_of(read->unknown)};
}

std::expected<void, FileError> save_document(const fs::path& path, const Document& document) {
    return write_text(path.string(), text_of(document));
}

}  // namespace zeroset
