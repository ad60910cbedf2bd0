#include "ui/actions/action_functions.hpp"
#include "ui/actions/action_parts.hpp"

#include <array>

// Actions of the document: files, rows, undo.

namespace zeroset::ui {
namespace {

/// Opens the export page for a kind of file, or closes it if it shows that.
template <ExportKind kind>
void open_exports(UiState& state) {
    ExportPage& page = state.pages.exports;
    page.open = !(page.open && page.wish.kind == kind);
    page.begins = true;
    page.wish.kind = kind;
}

template <ExportKind kind>
bool has_exports(const UiState& state) {
    return state.pages.exports.open && state.pages.exports.wish.kind == kind;
}

constexpr auto document_table = std::to_array<Action>({
    {.section = section::document,
     .name = "Undo",
     .keys = "Ctrl+Z",
     .about = "undo anything, the view included",
     .run = give<Command::Undo>,
     .enabled = [](const UiState& state) { return state.shown.document.can_undo; },
     .repeats = true,
     .for_readers = true},
    {.section = section::document,
     .name = "Redo",
     .keys = "Ctrl+Shift+Z, Ctrl+Y",
     .run = give<Command::Redo>,
     .enabled = [](const UiState& state) { return state.shown.document.can_redo; },
     .repeats = true,
     .for_readers = true},
    {.section = section::document, .name = "New", .keys = "Ctrl+N", .run = give<Command::New>},
    {.section = section::document,
     .name = "Open...",
     .keys = "Ctrl+O",
     .about =
         "open a file, also one of SURFER, MathMod or POV-Ray; it can be dropped on the window",
     .run = give<Command::Open>},
    {.section = section::document,
     .name = "Open a folder...",
     .about = "the sessions and the files of other programs in it, to choose from like the gallery",
     .run = give<Command::OpenFolder>},
    {.section = section::document, .name = "Save", .keys = "Ctrl+S", .run = give<Command::Save>},
    {.section = section::document,
     .name = "Save as...",
     .keys = "Ctrl+Shift+S",
     .run = give<Command::SaveAs>},
    {.section = section::document,
     .name = "Save the picture...",
     .keys = "Ctrl+E",
     .about = "of any size; a PNG opens again as a session",
     .run = open_exports<ExportKind::Picture>,
     .is_on = has_exports<ExportKind::Picture>},
    {.section = section::document,
     .name = "Save a film...",
     .about = "a turn, changing parameters, a way of the camera",
     .run = open_exports<ExportKind::Film>,
     .is_on = has_exports<ExportKind::Film>},
    {.section = section::document,
     .name = "Save the mesh...",
     .about = "triangles, for printing and for 3D programs",
     .run = open_exports<ExportKind::Mesh>,
     .is_on = has_exports<ExportKind::Mesh>},
    {.section = section::document,
     .name = "Save a drawing...",
     .about = "lines for papers, SVG or PDF",
     .run = open_exports<ExportKind::Drawing>,
     .is_on = has_exports<ExportKind::Drawing>},
    {.section = section::document,
     .name = "Go to the error",
     .keys = "F8",
     .about = "the caret goes to where a row is wrong; again: the next one",
     .run = go_to_next_error,
     .enabled = has_errors},
    {.section = section::document,
     .name = "Stop saving",
     .about = "give up what is being saved",
     .run = [](UiState& state) { state.wishes.stop_export = true; },
     .enabled = [](const UiState& state) { return !state.shown.export_progress.name.empty(); }},
    {.section = section::document,
     .name = "Copy the picture",
     .keys = "Ctrl+Shift+C",
     .about = "the picture on the screen, to be pasted elsewhere",
     .run = [](UiState& state) { state.wishes.copy_picture = true; },
     .for_readers = true},
    {.section = section::document,
     .name = "Copy as text",
     .keys = "Ctrl+C",
     .about = "outside a row: copy all as text, or the selected marker's coordinates",
     .run = give<Command::Copy>,
     .in_fields = false},
    {.section = section::document,
     .name = "Copy as one line",
     .about = "copy the session as a line of text to be sent; paste it to open it",
     .run = give<Command::Share>},
    {.section = section::document,
     .name = "Paste",
     .keys = "Ctrl+V",
     .about = "outside a row: paste a document or statements",
     .run = give<Command::Paste>,
     .in_fields = false},
});

}  // namespace

std::span<const Action> document_actions() { return document_table; }

}  // namespace zeroset::ui
