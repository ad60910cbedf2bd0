#include "engine/base/translation.hpp"
#include "ui/actions/actions.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr float longest_title_em = 22.0F;

void draw_recent(const std::vector<std::string>& paths, Wishes& wishes) {
    if (!ImGui::BeginMenu(tr("Open recent"), !paths.empty())) return;
    for (const std::string& path : paths) {
        ImGui::PushID(path.c_str());
        const std::string name = std::filesystem::path(path).filename().string();
        if (ImGui::MenuItem(elided(name, em(longest_title_em)).c_str())) wishes.open_path = path;
        draw_tooltip(path, 40.0F);
        ImGui::PopID();
    }
    ImGui::EndMenu();
}

/// Draws the choice of a language, each named in itself: who reads none of the others finds it.
void draw_languages(std::optional<Language>& chosen) {
    if (!ImGui::BeginMenu(tr("Language"))) return;
    if (ImGui::MenuItem(tr("As the desktop"), nullptr, !chosen)) chosen.reset();
    for (const Language language : all_languages) {
        if (ImGui::MenuItem(own_name(language), nullptr, chosen == language)) chosen = language;
    }
    ImGui::EndMenu();
}

void draw_items(UiState& state, std::initializer_list<const char*> names) {
    for (const char* const name : names) {
        const Action& action = action_named(name);
        const std::string keys = shown_keys(action);
        if (ImGui::MenuItem(tr(name), keys.c_str(), false, is_enabled(action, state))) {
            action.run(state);
        }
    }
}

}  // namespace

void draw_document_menu(UiState& state, const IconLook& look) {
    const DocumentStatus& document = state.shown.document;
    const std::string about =
        document.unsaved ? filled(tr("{0} (not saved)"), {document.name}) : document.name;
    if (icon_button("##document", Icon::Menu, look, about)) ImGui::OpenPopup("##document menu");
    if (!ImGui::BeginPopup("##document menu")) return;
    const std::string title = elided(about, em(longest_title_em));
    ImGui::TextDisabled("%s", title.c_str());
    if (title != about) draw_tooltip(about, 40.0F);
    ImGui::Separator();
    draw_items(state, {"New", "Open...", "Open a folder..."});
    draw_recent(document.recent, state.wishes);
    ImGui::Separator();
    draw_items(state, {"Save", "Save as..."});
    ImGui::Separator();
    draw_items(state,
               {"Save the picture...", "Save a film...", "Save the mesh...", "Save a drawing..."});
    ImGui::Separator();
    draw_items(state, {"Copy the picture", "Copy as text", "Copy as one line", "Paste"});
    ImGui::Separator();
    draw_languages(state.edited.layout.language);
    draw_items(state, {"Find a command...", "Quit"});
    ImGui::EndPopup();
}

}  // namespace zeroset::ui
