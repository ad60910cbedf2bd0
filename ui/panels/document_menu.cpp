#include "ui/panels/document_menu.hpp"

#include "ui/actions/actions.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr float longest_title_em = 22.0F;

void draw_recent(const std::vector<std::string>& paths, Wishes& wishes) {
    if (!ImGui::BeginMenu("Open recent", !paths.empty())) return;
    for (const std::string& path : paths) {
        ImGui::PushID(path.c_str());
        const std::string name = std::filesystem::path(path).filename().string();
        if (ImGui::MenuItem(elided(name, em(longest_title_em)).c_str())) wishes.open_path = path;
        draw_tooltip(path, 40.0F);
        ImGui::PopID();
    }
    ImGui::EndMenu();
}

void draw_items(UiState& state, std::initializer_list<const char*> names) {
    for (const char* const name : names) {
        const Action& action = action_named(name);
        const std::string keys = shown_keys(action);
        if (ImGui::MenuItem(name, keys.c_str(), false, is_enabled(action, state))) {
            action.run(state);
        }
    }
}

}  // namespace

void draw_document_menu(UiState& state, const IconLook& look) {
    const DocumentStatus& document = state.shown.document;
    const std::string about = document.name + (document.unsaved ? " (not saved)" : "");
    if (icon_button("##document", Icon::Menu, look, about)) ImGui::OpenPopup("##document menu");
    if (!ImGui::BeginPopup("##document menu")) return;
    const std::string title = elided(about, em(longest_title_em));
    ImGui::TextDisabled("%s", title.c_str());
    if (title != about) draw_tooltip(about, 40.0F);
    ImGui::Separator();
    draw_items(state, {"New", "Open..."});
    draw_recent(document.recent, state.wishes);
    ImGui::Separator();
    draw_items(state, {"Save", "Save as..."});
    ImGui::Separator();
    draw_items(state,
               {"Save the picture...", "Save a film...", "Save the mesh...", "Save a drawing..."});
    ImGui::Separator();
    draw_items(state, {"Copy the picture", "Copy as text", "Copy as one line", "Paste"});
    ImGui::Separator();
    draw_items(state, {"Find a command...", "Quit"});
    ImGui::EndPopup();
}

}  // namespace zeroset::ui
