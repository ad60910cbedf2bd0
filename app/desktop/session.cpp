#include "app/desktop/session.hpp"

#include "app/platform/folders.hpp"
#include "document/import/import.hpp"
#include "document/import/import_choice.hpp"
#include "document/json/document_file.hpp"
#include "document/json/share_text.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/base/utf8.hpp"
#include "engine/volume/files/volume_file.hpp"
#include "pipeline/input/input_source.hpp"
#include "pipeline/volume_document.hpp"
#include "pipeline/volume_source.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/window/clipboard.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <system_error>
#include <utility>

namespace zeroset {
namespace {

namespace fs = std::filesystem;
using Purpose = ui::FileChoice::Purpose;

/// Returns the folder in which a file dialog begins: the document's, else the current one.
std::string first_folder(const std::string& path) {
    std::error_code error;
    const fs::path file = path.empty() ? fs::path() : fs::absolute(path, error);
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::current_path(error);
    return error ? "/" : folder.string();
}

std::string bare_name(const std::string& path) {
    const std::string name = fs::path(path).filename().string();
    return is_document_name(name)
               ? name.substr(0, name.size() - std::string(document_ending).size())
               : name;
}

/// Returns the first text that is not empty, as a name for a document without one.
std::string first_text(const Document& document) {
    for (const Statement& statement : document.statements) {
        if (!statement.text.empty()) return ui::in_one_line(statement.text);
    }
    return tr("Untitled");
}

/// How the dialog for a file to be saved is called, and the file in it.
std::pair<std::string, std::string> names_of(ExportKind kind) {
    switch (kind) {
        case ExportKind::Picture:
            return {tr("Save the picture"), tr_in("name of a file", "picture")};
        case ExportKind::Film: return {tr("Save the film"), tr_in("name of a file", "film")};
        case ExportKind::Mesh: return {tr("Save the mesh"), tr_in("name of a file", "mesh")};
        case ExportKind::Drawing:
            return {tr("Save the drawing"), tr_in("name of a file", "drawing")};
    }
    return {};
}

/// The name, cut where it is too long for a question.
std::string shortened(const std::string& name) {
    constexpr std::size_t longest = 60;
    if (name.size() <= longest) return name;
    std::size_t end = longest;
    while (end > 0 && continues_character(name[end]))
        --end;
    return name.substr(0, end) + "\xE2\x80\xA6";
}

std::optional<fs::path> folder_for(const SessionOptions& options) {
    return options.keeps_files && !options.read_only ? state_folder() : std::nullopt;
}

}  // namespace

Session::Session(ui::UiState& state, const SessionOptions& options)
    : state_(state),
      files_(options.files),
      read_only_(options.read_only),
      browse_(options.browse),
      history_(state.edited.document),
      saved_(state.edited.document),
      path_(options.path),
      recent_(folder_for(options)),
      autosave_(folder_for(options)),
      lost_(autosave_.lost()),
      kept_(state.edited.document),
      volumes_(files_) {
    if (!path_.empty()) recent_.add(path_);
    if (lost_) {
        ask(Subject::Restore,
            filled(tr("Zeroset ended without being closed. Restore what was open?\n\n{0}"),
                   {shortened(first_text(lost_->document))}),
            {tr("Restore"), tr("Discard")});
    } else if (!options.note.empty()) {
        say(options.note);
    }
    refresh();
}

void Session::follow(double now_s) {
    follow_question();
    follow_file_choice();
    if (state_.wishes.command || state_.wishes.open_path) follow_command();
    history_.follow(current(), now_s, state_.input.gesture, state_.input.held);
    keep(now_s);
    ask_for_volumes();
    export_target_.follow(
        state_, export_folder(),
        path_.empty() ? names_of(state_.pages.exports.wish.kind).second : bare_name(path_));
    refresh();
}

void Session::amend(const std::function<void(Document&)>& change) {
    const bool clean = !unsaved();
    change(current());
    history_.amend(change);
    if (clean) saved_ = current();
}

void Session::played() {
    if (state_.edited.playing.empty()) return;
    history_.amend([this](Document& document) {
        document.w = current().w;
        document.parameters = current().parameters;
    });
}

void Session::show(Document document) {
    const bool clean = !unsaved();
    current() = renumbered(std::move(document), unused_id(current()));
    state_.edited.playing.clear();
    history_.end_step();
    path_.clear();
    if (clean) saved_ = current();
}

void Session::open(const std::vector<std::string>& paths) {
    if (paths.empty() || asked_ != Subject::Nothing || read_only_) return;
    if (browse(paths.front())) return;
    attempt({.intent = Intent::OpenPath, .path = paths.front()});
}

void Session::abandon() {
    if (unsaved()) autosave_.keep(current());
    autosave_.abandon();
}

std::optional<double> Session::due_s(double now_s) const {
    if (!unsaved() || kept_ == current()) return std::nullopt;
    return std::max(kept_s_ + autosave_s - now_s, 0.0);
}

std::string Session::title() const { return (unsaved() ? "* " : "") + state_.shown.document.name; }

void Session::refresh() {
    ui::DocumentStatus& status = state_.shown.document;
    status.name = path_.empty() ? first_text(current()) : bare_name(path_);
    status.unsaved = unsaved();
    status.can_undo = history_.can_undo();
    status.can_redo = history_.can_redo();
    status.recent = recent_.paths();
}

void Session::keep(double now_s) {
    if (kept_ == current() || now_s < kept_s_ + autosave_s) return;
    kept_ = current();
    kept_s_ = now_s;
    if (unsaved()) {
        autosave_.keep(kept_);
    } else {
        autosave_.forget();
    }
}

void Session::tell(const std::string& text) {
    if (asked_ == Subject::Nothing) say(text);
}

void Session::say_failure(const std::string& predicate) {
    // Translators: {0} is what failed and why, such as "cannot open 'a.zeroset': it is no file".
    say(filled(tr("I {0}."), {predicate}));
}

void Session::follow_command() {
    if (const auto path = std::exchange(state_.wishes.open_path, std::nullopt)) {
        attempt({.intent = Intent::OpenPath, .path = *path});
    }
    const auto command = std::exchange(state_.wishes.command, std::nullopt);
    if (!command) return;
    switch (*command) {
        case ui::Command::New: return attempt({.intent = Intent::New, .path = {}});
        case ui::Command::Open: return attempt({.intent = Intent::ChooseFile, .path = {}});
        case ui::Command::OpenFolder: return perform({.intent = Intent::ChooseFolder, .path = {}});
        case ui::Command::Save: return save();
        case ui::Command::SaveAs: return save_as();
        case ui::Command::Export: return choose_export();
        case ui::Command::Undo: return undo(true);
        case ui::Command::Redo: return undo(false);
        case ui::Command::Copy: return copy();
        case ui::Command::Share: return ui::set_clipboard(share_text(current()));
        case ui::Command::Paste: return paste();
        case ui::Command::CopyCamera: return copy_camera();
        case ui::Command::PasteCamera: return paste_camera(ui::clipboard());
        case ui::Command::Quit: return close();
    }
}

void Session::undo(bool back) {
    current() = back ? history_.undo() : history_.redo();
    if (state_.input.typing_row != 0) state_.wishes.reload = state_.input.typing_row;
}

void Session::attempt(Action action) {
    if (!unsaved()) return perform(action);
    waiting_ = std::move(action);
    ask(Subject::LoseWork,
        filled(tr("Save the changes to {0}?"), {shortened(state_.shown.document.name)}),
        {tr("Save"), tr("Don't save"), tr("Cancel")});
}

void Session::perform(const Action& action) {
    switch (action.intent) {
        case Intent::New: return begin_new();
        case Intent::ChooseFile: return choose_file_to_open(Purpose::Open);
        case Intent::ChooseFolder: return choose_file_to_open(Purpose::OpenFolder);
        case Intent::OpenPath: return load(action.path);
        case Intent::Quit: closed_ = true;
    }
}

void Session::choose_file_to_open(Purpose purpose) {
    ui::FileChoice& choice = state_.pages.dialogs.file.emplace();
    choice.purpose = purpose;
    choice.title =
        purpose == Purpose::OpenFolder ? tr("Open a folder as a gallery") : tr("Open a document");
    const std::string endings = import_endings() + " " + known_endings() + " .png";
    for (const std::string_view ending : split(endings, ' '))
        choice.other_endings.emplace_back(ending);
    choice.folder = first_folder(path_);
}

bool Session::browse(const std::string& path) {
    if (!browse_ || classify(path).kind == InputKind::Volume) return false;
    auto collection = collection_at(path);
    if (!collection) {
        say_failure(collection.error());
    } else if (*collection) {
        browse_(std::move(**collection));
    } else {
        return false;
    }
    return true;
}

void Session::begin(Document document, const std::string& path) {
    current() = renumbered(std::move(document), unused_id(current()));
    state_.edited.playing.clear();
    history_ = History(current());
    saved_ = kept_ = current();
    path_ = path;
    volumes_.forget();
    autosave_.forget();
    if (path.empty()) {
        state_.wishes.focus = ui::RowFocus{.row = current().statements.front().id, .caret = {}};
    }
}

void Session::begin_new() {
    Document document = ui::new_document(state_.edited.layout);
    document.files = volume_source({}, files_);
    begin(std::move(document), {});
}

void Session::load(const std::string& path) {
    if (classify(path).kind == InputKind::Volume) return load_volume(path);
    auto loaded = load_document(path, volume_source(volumes_beside(path), files_));
    if (!loaded) return say_failure(loaded.error());
    if (is_import_path(path)) ui::smooth_as_new(loaded->document, state_.edited.layout);
    begin(std::move(loaded->document), loaded->is_source ? "" : path);
    if (!loaded->is_source) recent_.add(path);
    const bool is_list = loaded->note.contains('\n');
    if (!loaded->note.empty()) say(bare_name(path) + (is_list ? ":\n\n" : ": ") + loaded->note);
}

void Session::load_volume(const std::string& path) {
    auto document = document_of_volume(path, files_);
    if (!document) return say_failure(document.error().reason);
    ui::smooth_as_new(*document, state_.edited.layout);
    begin(std::move(*document), {});
}

void Session::save() {
    if (path_.empty()) return save_as();
    write(path_);
}

void Session::choose_file_for(ui::FileChoice choice, const std::string& usual_name) {
    choice.folder = first_folder(path_);
    choice.name = path_.empty() ? usual_name : bare_name(path_);
    state_.pages.dialogs.file = std::move(choice);
}

void Session::save_as() {
    ui::FileChoice choice;
    choice.purpose = Purpose::Save;
    choice.title = tr("Save as");
    choose_file_for(std::move(choice), tr_in("name of a file", "untitled"));
}

std::string Session::export_folder() const {
    return export_folder_.empty() ? first_folder(path_) : export_folder_;
}

void Session::choose_export() {
    const ui::ExportPage& page = state_.pages.exports;
    const auto kind = static_cast<std::size_t>(page.wish.kind);
    const std::string& ending = page.endings.at(kind);
    const std::string ending_of_files = ending.substr(ending.find('.'));
    const auto [title, usual_name] = names_of(page.wish.kind);
    ui::FileChoice choice;
    choice.purpose = Purpose::Export;
    choice.title = title;
    choice.ending = ending_of_files;
    choose_file_for(std::move(choice), usual_name);
    state_.pages.dialogs.file->folder = export_folder();
    // Numbered pictures have their number in the name.
    std::string& name = state_.pages.dialogs.file->name;
    name += ending.substr(0, ending.find('.')) + ending_of_files;
}

void Session::write(const std::string& path) {
    // The usual background of pictures is dark: not what a light window shows.
    const bool light = state_.edited.theme == ui::Theme::Light;
    const auto written = save_document(
        path, current(),
        light ? std::optional(ui::picture_background(ui::Theme::Light)) : std::nullopt);
    if (!written) {
        waiting_.reset();
        return say_failure(written.error().message);
    }
    path_ = path;
    saved_ = kept_ = current();
    autosave_.forget();
    recent_.add(path);
    if (const auto action = std::exchange(waiting_, std::nullopt)) perform(*action);
}

void Session::follow_file_choice() {
    std::optional<ui::FileChoice>& file = state_.pages.dialogs.file;
    if (!file || !file->finished) return;
    const ui::FileChoice choice = *std::exchange(file, std::nullopt);
    if (choice.path.empty()) {
        waiting_.reset();
        return;
    }
    switch (choice.purpose) {
        case Purpose::Open:
        case Purpose::OpenFolder:
            if (!browse(choice.path)) load(choice.path);
            return;
        case Purpose::Save: return write(choice.path);
        case Purpose::Export:
            export_folder_ = first_folder(choice.path);
            state_.wishes.export_path = choice.path;
    }
}

}  // namespace zeroset
