#include "ui/document_menu.hpp"

#include "ui/icons.hpp"
#include "ui/label.hpp"
#include "ui/ui_state.hpp"

#include <imgui/imgui.h>

#include <filesystem>
#include <string>

namespace zeroset::ui {
namespace {

void draw_recent(UiState& state) {
    if (!ImGui::BeginMenu("Open recent", !state.recent.empty())) return;
    for (const std::string& path : state.recent) {
        ImGui::PushID(path.c_str());
        const std::string name = std::filesystem::path(path).filename().string();
        if (ImGui::MenuItem(name.c_str())) state.open_path = path;
        draw_tooltip(path, 40.0F);
        ImGui::PopID();
    }
    ImGui::EndMenu();
}

}  // namespace

void draw_document_menu(UiState& state, const IconLook& look) {
    const std::string about = state.name + (state.unsaved ? " (not saved)" : "");
    if (icon_button("##document", Icon::Menu, look, about)) ImGui::OpenPopup("##document menu");
    if (!ImGui::BeginPopup("##document menu")) return;
    const auto item = [&state](const char* label, const char* keys, Command command) {
        if (ImGui::MenuItem(label, keys)) state.command = command;
    };
    ImGui::TextDisabled("%s", about.c_str());
    ImGui::Separator();
    item("New", "Ctrl+N", Command::New);
    item("Open...", "Ctrl+O", Command::Open);
    draw_recent(state);
    ImGui::Separator();
    item("Save", "Ctrl+S", Command::Save);
    item("Save as...", "Ctrl+Shift+S", Command::SaveAs);
    ImGui::Separator();
    item("Copy as text", "Ctrl+C", Command::Copy);
    item("Paste", "Ctrl+V", Command::Paste);
    ImGui::Separator();
    item("Quit", "Ctrl+Q", Command::Quit);
    ImGui::EndPopup();
}

}  // namespace zeroset::ui
