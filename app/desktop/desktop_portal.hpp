#pragma once

#include "app/platform/portal.hpp"
#include "ui/model/dialog_state.hpp"
#include "ui/model/edited.hpp"

#include <functional>
#include <string>
#include <utility>

namespace zeroset {

/// Connects the window's state to the desktop's portal: the theme follows the desktop until the
/// user has chosen one, and files are chosen in the desktop's dialog where there is one. The
/// window's thread only.
class DesktopPortal {
public:
    /// Calls `wake` from another thread when there is news; `parent` as in FileRequest.
    DesktopPortal(std::function<void()> wake, std::string parent)
        : parent_(std::move(parent)), portal_(std::move(wake)) {}

    /// To be called before the panels are drawn.
    void follow(ui::Edited& edited, ui::Dialogs& dialogs);
    /// Shows the file in the desktop's manager of files, where there is one.
    void show(const std::string& path) { portal_.show(path); }

private:
    void follow_files(ui::Dialogs& dialogs);
    void take_answer(ui::FileChoice& choice);

    std::string parent_;
    Portal portal_;
    ColorWish wish_ = ColorWish::None;
    bool is_wish_known_ = false;
    bool asks_ = false;        ///< the desktop's dialog is open
    bool has_dialogs_ = true;  ///< false once the desktop turned out to have no dialogs
};

}  // namespace zeroset
