#pragma once

namespace zeroset::ui {

/// Where the keyboard goes, as far as Dear ImGui decides it otherwise: Alt alone takes it from
/// nothing, Escape gives it up instead of marking a whole panel, and where Tab has led is marked.
class Navigation {
public:
    /// To be called right after ImGui::NewFrame().
    void follow();

private:
    bool tabbed_ = false;     ///< Tab was pressed in the previous frame
    bool had_popup_ = false;  ///< in the previous frame
};

}  // namespace zeroset::ui
