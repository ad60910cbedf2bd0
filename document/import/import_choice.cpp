#include "document/import/import_choice.hpp"

#include "document/import/import.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <ranges>
#include <system_error>

namespace zeroset {
namespace {

/// The document that a choice means.
std::optional<std::size_t> chosen(const std::vector<ImportedDocument>& documents,
                                  const std::string& choice) {
    if (choice.empty()) return 0;
    const auto named = std::ranges::find(documents, choice, &ImportedDocument::name);
    if (named != documents.end()) return static_cast<std::size_t>(named - documents.begin());
    const auto number = number_from<std::size_t>(choice);
    if (number && *number >= 1 && *number <= documents.size()) return *number - 1;
    return std::nullopt;
}

}  // namespace

ImportPlace import_place(const std::string& path) {
    std::error_code error;
    const std::size_t mark = path.find('#');
    if (mark == std::string::npos || std::filesystem::exists(path, error))
        return {.file = path, .choice = {}};
    return {.file = path.substr(0, mark), .choice = std::string(trimmed(path.substr(mark + 1)))};
}

bool is_import_path(const std::string& path) {
    if (path.contains('\n')) return false;
    return is_import_name(import_place(path).file.string());
}

std::expected<ImportedDocument, std::string> load_imported(
    const ImportPlace& place, const std::shared_ptr<const FieldSource>& files) {
    auto imported = load_import(place.file, files);
    if (!imported) return std::unexpected(imported.error());
    const auto index = chosen(imported->documents, place.choice);
    const std::size_t count = imported->documents.size();
    if (!index) {
        return std::unexpected(filled(tr("cannot open {0}: it has no surface '{1}'; its first is "
                                         "'{2}', and they have the numbers 1 to {3}"),
                                      {"'" + place.file.string() + "'", place.choice,
                                       imported->documents[0].name, std::to_string(count)}));
    }
    ImportedDocument document = std::move(imported->documents[*index]);
    std::ranges::move(imported->notes, std::back_inserter(document.notes));
    std::ranges::stable_sort(document.notes, {}, &ImportNote::line);
    if (count > 1 && place.choice.empty()) {
        document.note(0, "",
                      filled(tr("the first of {0}; the others are opened as {1}#2 and so on, or "
                                "brought all at once by zeroset import"),
                             {std::to_string(count), place.file.filename().string()}));
    }
    if (!document.tells_box)
        document.note(
            0, "",
            tr("the file tells no clip box; F, or --fit, finds how far the surface reaches"));
    return document;
}

std::string note_text(std::string_view file, const ImportNote& note) {
    std::string text(file);
    if (note.line > 0) text += ":" + std::to_string(note.line);
    text += ": ";
    if (!note.entry.empty()) text += note.entry + ": ";
    return text + note.reason;
}

std::string notes_listed(const std::vector<ImportNote>& notes) {
    constexpr std::size_t most_listed = 12;
    std::string text;
    for (const ImportNote& note : notes | std::views::take(most_listed)) {
        if (!text.empty()) text += '\n';
        if (note.line > 0) text += filled(tr("line {0}: "), {std::to_string(note.line)});
        if (!note.entry.empty()) text += note.entry + ": ";
        text += note.reason;
    }
    if (notes.size() <= most_listed) return text;
    const std::string more = std::to_string(notes.size() - most_listed);
    return text + '\n' + filled(tr("and {0} more, which zeroset import lists"), {more});
}

}  // namespace zeroset
