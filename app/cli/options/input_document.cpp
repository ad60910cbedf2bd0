#include "app/cli/options/input_document.hpp"

#include "document/import/import.hpp"
#include "document/import/import_choice.hpp"
#include "document/json/document_file.hpp"
#include "document/json/document_json.hpp"
#include "document/json/share_text.hpp"
#include "engine/base/printable.hpp"
#include "engine/base/text.hpp"
#include "engine/volume/files/volume_file.hpp"
#include "pipeline/gallery.hpp"
#include "pipeline/volume_document.hpp"
#include "pipeline/volume_source.hpp"

#include <algorithm>
#include <cctype>
#include <expected>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

namespace zeroset {
namespace {

/// The folder from which an equation names its volumes: a typed one may name any file, a document
/// or a shared session only those beside it.
VolumeFolder folder_of_volumes(const std::string& equation) {
    if (is_document_name(equation) || is_picture_name(equation) || is_import_path(equation))
        return {.folder = std::filesystem::path(equation).parent_path(), .closed = true};
    return {.folder = {}, .closed = is_share_text(equation)};
}

/// The document of a text, in the clip box of its volumes.
ReadDocument typed_document(std::string_view text) {
    ReadDocument read = read_document_text(trimmed(text));
    if (read.rows) fit_to_volumes(*read.rows->program, read.document);
    return read;
}

/// Reads another program's file, and says on stderr what was not taken over.
OrInputError<InputDocument> imported_document(const std::string& path) {
    auto imported = load_imported(import_place(path));
    if (!imported) return wrong_input(imported.error());
    for (const ImportNote& note : imported->notes)
        std::cerr << "zeroset: " << printable(note_text(path, note)) << "\n";
    return InputDocument{
        read_document(std::move(imported->document)), {}, notes_listed(imported->notes), {}, true};
}

/// Whether the text is the name of a file rather than a formula, though of none that is opened.
bool names_other_file(const std::string& equation) {
    std::error_code ignored;
    return std::filesystem::path(equation).has_extension() &&
           std::filesystem::is_regular_file(equation, ignored);
}

/// Whether a text that is no formula may well name a file: /tmp/scene.json, scan.dcm.
bool may_name_file(const std::string& text) {
    const auto is_plain = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
    const auto is_of_path = [&](char c) {
        return is_plain(c) || std::string_view("/._-~").contains(c) || c < 0;
    };
    const std::string ending = std::filesystem::path(text).extension().string();
    return ending.size() > 3 && std::isalpha(static_cast<unsigned char>(ending[1])) != 0 &&
           std::ranges::all_of(ending.substr(1), is_plain) && std::ranges::all_of(text, is_of_path);
}

std::string what_is_opened(const std::string& file) {
    return "'" + file + "' is no kind of file that is opened; those end in " +
           std::string(document_ending) + " " + import_endings() + " " + known_endings() +
           "; raw samples of a volume are read by volume(\"" + file +
           "\", size 256 256 109, uint8)";
}

/// The document of a formula; an error of its own for what may name a file.
OrInputError<InputDocument> formula_document(const std::string& equation) {
    ReadDocument read = typed_document(equation);
    if (!read.rows && may_name_file(equation)) {
        return wrong_input("'" + equation + "': there is no such file, and it is no formula: " +
                           read.rows.error().reason);
    }
    return InputDocument{std::move(read)};
}

}  // namespace

OrInputError<InputDocument> stored_document(const std::string& equation) {
    use_volume_folder(folder_of_volumes(equation));
    if (is_document_name(equation) || is_picture_name(equation)) {
        auto loaded = load_document(equation);
        if (!loaded) return wrong_input(loaded.error());
        if (loaded->shown_on && !loaded->document.light.background)
            loaded->document.light.background = loaded->shown_on;
        return InputDocument{read_document(std::move(loaded->document)),
                             loaded->is_source ? "" : equation, loaded->note, loaded->shown_on,
                             true};
    }
    if (is_import_path(equation)) return imported_document(equation);
    if (is_volume_file(equation) && !equation.contains('"')) {
        auto volume = document_of_volume(equation);
        if (!volume) return std::unexpected(volume.error());
        return InputDocument{read_document(std::move(*volume))};
    }
    std::error_code ignored;
    if (equation.contains('/') && std::filesystem::is_directory(equation, ignored)) {
        return wrong_input("'" + equation +
                           "' is a folder: the window shows what is in it, with zeroset " +
                           equation + "; for a picture type one of its files");
    }
    if (is_share_text(equation)) {
        auto shared = document_from(equation);
        if (!shared) return wrong_input("zeroset:...: " + shared.error());
        return InputDocument{read_document(std::move(shared->document)), {}, {}, {}, true};
    }
    if (equation.starts_with('@')) {
        const auto item = gallery_item(std::string_view(equation).substr(1));
        if (!item) return std::unexpected(item.error());
        return InputDocument{read_document(*item)};
    }
    if (names_other_file(equation)) return wrong_input(what_is_opened(equation));
    if (equation != "-") return formula_document(equation);
    const std::string text(std::istreambuf_iterator<char>(std::cin), {});
    return InputDocument{typed_document(text)};
}

}  // namespace zeroset
