#include "ui/pages/file_browser.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/keys.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <cfloat>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace zeroset::ui {
namespace {

namespace fs = std::filesystem;
using Purpose = FileChoice::Purpose;

struct Entry {
    std::string name;
    bool is_folder;
};

bool is_offered(const FileChoice& choice, const std::string& name) {
    const std::string small = lower_case(name);
    return name.ends_with(choice.ending) ||
           std::ranges::any_of(choice.other_endings, [&small](const std::string& ending) {
               return small.ends_with(ending);
           });
}

/// Returns folders, then the files that are offered, each sorted by name; without hidden ones.
std::vector<Entry> entries_of(const FileChoice& choice) {
    std::vector<Entry> entries;
    std::error_code error;
    for (fs::directory_iterator at(choice.folder, error), end; !error && at != end;
         at.increment(error)) {
        std::error_code ignored;
        const std::string name = at->path().filename().string();
        const bool is_folder = at->is_directory(ignored);
        if (name.starts_with('.')) continue;
        if (is_folder || is_offered(choice, name))
            entries.push_back({.name = name, .is_folder = is_folder});
    }
    std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
        return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
    });
    return entries;
}

void go_to(FileChoice& choice, const fs::path& folder) {
    choice.folder = folder.lexically_normal().string();
    choice.asks_replace = false;
    if (!choice.saves()) choice.name.clear();
}

/// Path of the typed name in the shown folder; a file to save gets an ending if it has none.
fs::path typed_path(const FileChoice& choice) {
    const fs::path folder(choice.folder);
    std::error_code ignored;
    if (!choice.saves() || fs::is_directory(folder / choice.name, ignored))
        return folder / choice.name;
    return folder / with_ending(choice, choice.name);
}

/// The file that saving replaces first: that of a film in numbered pictures has zeros for its #.
fs::path first_written(const fs::path& path) {
    std::string name = path.filename().string();
    for (std::size_t i = name.find_last_of('#'); i < name.size() && name[i] == '#'; --i)
        name[i] = '0';
    return path.parent_path() / name;
}

/// Opens the typed folder or accepts the typed file; asks once before a file is replaced.
void accept(FileChoice& choice) {
    const bool folder = choice.purpose == Purpose::OpenFolder;
    if (choice.name.empty() && !folder) return;
    const fs::path path = typed_path(choice);
    std::error_code ignored;
    if (fs::is_directory(path, ignored) && !choice.name.empty()) {
        choice.name.clear();
        return go_to(choice, path);
    }
    const bool exists = fs::exists(first_written(path), ignored);
    if (choice.saves() && exists && !choice.asks_replace) {
        choice.asks_replace = true;
        return;
    }
    choice.path = path.string();
    choice.finished = true;
}

void draw_places(FileChoice& choice, const Palette& colors) {
    const float size = ImGui::GetFrameHeight();
    if (icon_button("##up", Icon::Up, {.size = size, .color = colors.quiet},
                    tr("The folder above"))) {
        go_to(choice, fs::path(choice.folder).parent_path());
    }
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    if (draw_elided(choice.folder, ImGui::GetContentRegionAvail().x)) draw_tooltip(choice.folder);
}

void draw_entry(FileChoice& choice, const Entry& entry, const Palette& colors) {
    const float indent = em(1.6F);
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    const float height = em(1.7F);
    const bool marked = entry.name == choice.name;
    if (ImGui::Selectable(
            ("##" + entry.name).c_str(), marked,
            ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups,
            ImVec2(0.0F, height))) {
        choice.asks_replace = false;
        if (entry.is_folder) {
            go_to(choice, fs::path(choice.folder) / entry.name);
        } else {
            choice.name = entry.name;
            if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) accept(choice);
        }
    }
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    const float middle = lo.y + 0.5F * height;
    if (entry.is_folder) {
        draw_icon(canvas, Icon::Folder, ImVec2(lo.x + em(0.8F), middle), em(0.9F), colors.quiet);
    }
    const std::string name = elided(entry.name, ImGui::GetItemRectMax().x - lo.x - indent);
    if (name != entry.name) draw_tooltip(entry.name, 40.0F);
    canvas.AddText(ImVec2(lo.x + indent, middle - 0.5F * ImGui::GetFontSize()), colors.text,
                   name.c_str());
}

void draw_entries(FileChoice& choice, float height, const Palette& colors) {
    ImGui::PushStyleColor(ImGuiCol_ChildBg, colors.field);
    ImGui::BeginChild("##entries", ImVec2(0.0F, height));
    const std::vector<Entry> entries = entries_of(choice);
    for (const Entry& entry : entries)
        draw_entry(choice, entry, colors);
    if (entries.empty())
        ImGui::TextDisabled("  %s", filled(tr("none here (*{0})"), {choice.ending}).c_str());
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

void draw_buttons(FileChoice& choice, const Palette& colors) {
    if (choice.asks_replace) {
        ImGui::PushStyleColor(ImGuiCol_Text, colors.warning);
        ImGui::TextUnformatted(tr("This file exists. Save again to replace it."));
        ImGui::PopStyleColor();
    }
    const char* const verb = !choice.saves()       ? tr("Open")
                             : choice.asks_replace ? tr("Replace")
                                                   : tr("Save");
    if (ImGui::Button(verb, ImVec2(em(7.0F), 0.0F))) accept(choice);
    ImGui::SameLine();
    if (ImGui::Button(tr("Cancel"), ImVec2(em(7.0F), 0.0F))) choice.finished = true;
}

void draw_name(FileChoice& choice) {
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (ImGui::InputTextWithHint("##name", tr("name or path"), &choice.name,
                                 ImGuiInputTextFlags_AutoSelectAll)) {
        choice.asks_replace = false;
    }
}

}  // namespace

void draw_file_browser(FileChoice& choice, const Palette& colors) {
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove;
    if (!ImGui::IsPopupOpen("##files")) ImGui::OpenPopup("##files");
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const ImVec2 size(std::min(em(38.0F), 0.95F * window.x), std::min(em(32.0F), 0.92F * window.y));
    ImGui::SetNextWindowPos(ImVec2(0.5F * (window.x - size.x), 0.45F * (window.y - size.y)));
    ImGui::SetNextWindowSize(size);
    if (!ImGui::BeginPopupModal("##files", nullptr, flags)) return;
    ImGui::TextUnformatted(choice.title.c_str());
    draw_places(choice, colors);
    draw_name(choice);
    const float below = (choice.asks_replace ? 2.2F : 1.2F) * ImGui::GetFrameHeightWithSpacing();
    draw_entries(choice, ImGui::GetContentRegionAvail().y - below, colors);
    draw_buttons(choice, colors);
    if (is_pressed_once(ImGuiKey_Enter) || is_pressed_once(ImGuiKey_KeyPadEnter)) accept(choice);
    if (is_pressed_once(ImGuiKey_Escape)) choice.finished = true;
    if (choice.finished) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace zeroset::ui
