#include "pipeline/input/input_source.hpp"

#include "document/import/import_choice.hpp"
#include "document/json/document_file.hpp"
#include "document/json/share_text.hpp"
#include "engine/volume/files/volume_file.hpp"

#include <filesystem>
#include <system_error>

namespace zeroset {
namespace {

bool is_folder(const std::string& text) {
    std::error_code ignored;
    return text.contains('/') && std::filesystem::is_directory(text, ignored);
}

/// Whether the text is the name of a file rather than a formula.
bool is_file(const std::string& text) {
    std::error_code ignored;
    return std::filesystem::path(text).has_extension() &&
           std::filesystem::is_regular_file(text, ignored);
}

/// A formula that is being typed may end as a volume's name does: scan = volume("ct.nrrd
bool is_volume(const std::string& text) {
    return is_volume_file(text) && (!text.contains('"') || is_file(text));
}

InputKind kind_of(const std::string& text) {
    if (is_document_name(text) || is_picture_name(text)) return InputKind::Document;
    if (is_import_path(text)) return InputKind::OtherProgram;
    if (is_volume(text)) return InputKind::Volume;
    if (is_folder(text)) return InputKind::Folder;
    if (is_share_text(text)) return InputKind::Shared;
    if (text.starts_with('@')) return InputKind::Gallery;
    if (is_file(text)) return InputKind::OtherFile;
    return text == "-" ? InputKind::StandardInput : InputKind::Formula;
}

}  // namespace

VolumeFolder volumes_beside(const std::filesystem::path& file) {
    return {.folder = file.parent_path(), .closed = true};
}

InputSource classify(const std::string& text) {
    const InputKind kind = kind_of(text);
    if (kind == InputKind::Document || kind == InputKind::OtherProgram)
        return {.kind = kind, .volumes = volumes_beside(text)};
    return {.kind = kind, .volumes = {.folder = {}, .closed = kind == InputKind::Shared}};
}

}  // namespace zeroset
