#include "app/desktop/desktop_portal.hpp"

#include "ui/model/dialog_state.hpp"

#include <filesystem>
#include <string>
#include <system_error>

namespace zeroset {
namespace {

namespace fs = std::filesystem;
using Purpose = ui::FileChoice::Purpose;

/// Appends the ending where it is missing, as the program's own file dialog does. If
/// that names another file that exists, the user is asked in the window.
void take_saved(ui::FileChoice& choice, const std::string& chosen) {
    const fs::path path(ui::with_ending(choice, chosen));
    std::error_code ignored;
    if (path != fs::path(chosen) && fs::exists(path, ignored)) {
        choice.folder = path.parent_path().string();
        choice.name = path.filename().string();
        choice.asks_replace = true;
        return;
    }
    choice.path = path.string();
    choice.finished = true;
}

}  // namespace

void DesktopPortal::follow(ui::Edited& edited, ui::Dialogs& dialogs) {
    if (const auto wish = portal_.take_wish()) {
        wish_ = *wish;
        is_wish_known_ = true;
    }
    if (edited.follows_desktop && is_wish_known_) {
        edited.theme = wish_ == ColorWish::Light ? ui::Theme::Light : ui::Theme::Dark;
    }
    follow_files(dialogs);
}

void DesktopPortal::follow_files(ui::Dialogs& dialogs) {
    if (!dialogs.file || !dialogs.file->elsewhere) {
        if (asks_) portal_.give_up();
        asks_ = false;
    }
    if (!dialogs.file) return;
    ui::FileChoice& choice = *dialogs.file;
    if (choice.begins && has_dialogs_) {
        portal_.ask({.title = choice.title,
                     .saves = choice.saves(),
                     .opens_folder = choice.purpose == Purpose::OpenFolder,
                     .folder = choice.folder,
                     .name = ui::with_ending(choice, choice.name),
                     .ending = choice.ending,
                     .other_endings = choice.other_endings,
                     .parent = parent_});
        choice.elsewhere = true;
        asks_ = true;
    }
    choice.begins = false;
    if (asks_) take_answer(choice);
}

void DesktopPortal::take_answer(ui::FileChoice& choice) {
    const auto answer = portal_.take_answer();
    if (!answer) return;
    asks_ = false;
    choice.elsewhere = false;
    has_dialogs_ = answer->asked;
    if (!answer->asked) return;
    if (answer->path.empty()) {
        choice.finished = true;
    } else if (choice.saves()) {
        take_saved(choice, answer->path);
    } else {
        choice.path = answer->path;
        choice.finished = true;
    }
}

}  // namespace zeroset
