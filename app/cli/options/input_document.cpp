#include "app/cli/options/input_document.hpp"

#include "document/import/import.hpp"
#include "document/import/import_choice.hpp"
#include "document/json/document_file.hpp"
#include "document/json/document_json.hpp"
#include "document/json/share_text.hpp"
#include "engine/base/text.hpp"
#include "engine/volume/files/volume_file.hpp"
#include "pipeline/gallery.hpp"
#include "pipeline/input/input_source.hpp"
#include "pipeline/volume_document.hpp"
#include "pipeline/volume_source.hpp"

#include <algorithm>
#include <cctype>
#include <expected>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <string_view>
#include <utility>

namespace zeroset {
namespace {

using Files = std::shared_ptr<const FieldSource>;

/// The document of a text, in the clip box of its volumes or commands.
ReadDocument typed_document(std::string_view text, const Files& files) {
    ReadDocument read = read_document_text(trimmed(text), files);
    if (read.rows) fit_to_program(*read.rows->program, read.document);
    return read;
}

/// Reads another program's file, and says on stderr what was not taken over.
OrInputError<InputDocument> imported_document(const std::string& path, const Files& files) {
    auto imported = load_imported(import_place(path), files);
    if (!imported) return wrong_input(imported.error());
    for (const ImportNote& note : imported->notes)
        std::cerr << "zeroset: " << printable(note_text(path, note)) << "\n";
    return InputDocument{
        read_document(std::move(imported->document)), {}, notes_listed(imported->notes), {}, true};
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

/// A document that was typed, not opened.
InputDocument as_typed(ReadDocument read) {
    InputDocument input{std::move(read)};
    input.typed = true;
    return input;
}

/// The document of a formula; an error of its own for what may name a file.
OrInputError<InputDocument> formula_document(const std::string& equation, const Files& files) {
    ReadDocument read = typed_document(equation, files);
    if (!read.rows && may_name_file(equation)) {
        return wrong_input("'" + equation + "': there is no such file, and it is no formula: " +
                           read.rows.error().reason);
    }
    return as_typed(std::move(read));
}

/// The document of a file of a session, or of a picture that holds one.
OrInputError<InputDocument> saved_document(const std::string& path, const Files& files) {
    auto loaded = load_document(path, files);
    if (!loaded) return wrong_input(loaded.error());
    if (loaded->shown_on && !loaded->document.light.background)
        loaded->document.light.background = loaded->shown_on;
    return InputDocument{read_document(std::move(loaded->document)), loaded->is_source ? "" : path,
                         loaded->note, loaded->shown_on, true};
}

OrInputError<InputDocument> volume_document(const std::string& path,
                                            const std::shared_ptr<FileAccess>& access) {
    auto volume = document_of_volume(path, access);
    if (!volume) return std::unexpected(volume.error());
    return InputDocument{read_document(std::move(*volume))};
}

OrInputError<InputDocument> shared_document(const std::string& text, const Files& files) {
    auto shared = document_from(text);
    if (!shared) return wrong_input("zeroset:...: " + shared.error());
    shared->document.files = files;
    return InputDocument{read_document(std::move(shared->document)), {}, {}, {}, true};
}

OrInputError<InputDocument> gallery_document(std::string_view name, const Files& files) {
    const auto item = gallery_item(name);
    if (!item) return std::unexpected(item.error());
    return InputDocument{read_document(*item, files)};
}

}  // namespace

OrInputError<InputDocument> stored_document(const std::string& equation,
                                            const std::shared_ptr<FileAccess>& access) {
    const InputSource source = classify(equation);
    const Files files = volume_source(source.volumes, access);
    switch (source.kind) {
        case InputKind::Document: return saved_document(equation, files);
        case InputKind::OtherProgram: return imported_document(equation, files);
        case InputKind::Volume: return volume_document(equation, access);
        case InputKind::Folder:
            return wrong_input("'" + equation +
                               "' is a folder: the window shows what is in it, with zeroset " +
                               equation + "; for a picture type one of its files");
        case InputKind::Shared: return shared_document(equation, files);
        case InputKind::Gallery:
            return gallery_document(std::string_view(equation).substr(1), files);
        case InputKind::OtherFile: return wrong_input(what_is_opened(equation));
        case InputKind::StandardInput:
            return as_typed(
                typed_document(std::string(std::istreambuf_iterator<char>(std::cin), {}), files));
        case InputKind::Formula: break;
    }
    return formula_document(equation, files);
}

}  // namespace zeroset
