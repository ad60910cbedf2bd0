#include "engine/base/translation.hpp"
#include "ui/pages/file_browser.hpp"
#include "ui/pages/pages_drawn.hpp"
#include "ui/style/keys.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cstddef>

namespace zeroset::ui {
namespace {

/// Moves the mark to the next or the previous answer.
void follow_arrows(Question& question) {
    const bool shift = ImGui::GetIO().KeyShift;
    const bool tab = is_pressed(ImGuiKey_Tab);
    const std::size_t count = question.answers.size();
    if (is_pressed(ImGuiKey_RightArrow) || is_pressed(ImGuiKey_DownArrow) || (tab && !shift))
        question.marked = (question.marked + 1) % count;
    if (is_pressed(ImGuiKey_LeftArrow) || is_pressed(ImGuiKey_UpArrow) || (tab && shift))
        question.marked = (question.marked + count - 1) % count;
}

/// Chooses an answer by key: Enter the marked one, Escape the last, a letter the answer that begins
/// with it. No letter and no Space choose the first one, such as to save: they may be of a text
/// that was being typed.
void follow_keys(Question& question) {
    follow_arrows(question);
    for (std::size_t i = 1; i < question.answers.size(); ++i) {
        const char first = question.answers[i].front();
        if (is_typed(static_cast<char>(first - 'A' + 'a'))) question.chosen = i;
    }
    const bool space = is_pressed_once(ImGuiKey_Space) && question.marked > 0;
    if (is_pressed_once(ImGuiKey_Enter) || is_pressed_once(ImGuiKey_KeyPadEnter) || space)
        question.chosen = question.marked;
    if (is_pressed_once(ImGuiKey_Escape)) question.chosen = question.answers.size() - 1;
}

void draw_answers(Question& question, const Palette& colors) {
    for (std::size_t i = 0; i < question.answers.size(); ++i) {
        if (i > 0) ImGui::SameLine();
        const bool marked = i == question.marked;
        if (marked) {
            ImGui::PushStyleColor(ImGuiCol_Button, colors.accent);
            ImGui::PushStyleColor(ImGuiCol_ButtonHovered, colors.accent);
            ImGui::PushStyleColor(ImGuiCol_Text, colors.bar);
        }
        if (ImGui::Button(question.answers[i].c_str())) question.chosen = i;
        if (marked) ImGui::PopStyleColor(3);
    }
}

void draw_question(Question& question, const Palette& colors) {
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration |
                                       ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoNav;
    if (!ImGui::IsPopupOpen("##question")) ImGui::OpenPopup("##question");
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(0.5F * window.x, 0.45F * window.y), ImGuiCond_Always,
                            ImVec2(0.5F, 0.5F));
    if (!ImGui::BeginPopupModal("##question", nullptr, flags)) return;
    ImGui::PushTextWrapPos(std::min(em(28.0F), 0.85F * window.x));
    ImGui::TextUnformatted(question.text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::Dummy(ImVec2(em(16.0F), em(0.3F)));
    draw_answers(question, colors);
    follow_keys(question);
    if (question.chosen) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

/// Draws a question that cancels the desktop's file dialog, while that is open.
void draw_waiting(FileChoice& choice, const Palette& colors) {
    Question question{.text = tr("Choose the file in the desktop's dialog."),
                      .answers = {tr("Cancel")},
                      .chosen = {}};
    draw_question(question, colors);
    if (question.chosen) choice.finished = true;
}

}  // namespace

void draw_dialogs(Dialogs& dialogs, Theme theme) {
    if (dialogs.question && !dialogs.question->chosen) {
        draw_question(*dialogs.question, palette(theme));
    } else if (dialogs.file && !dialogs.file->finished) {
        FileChoice& choice = *dialogs.file;
        const auto draw = choice.elsewhere ? draw_waiting : draw_file_browser;
        draw(choice, palette(theme));
    }
}

}  // namespace zeroset::ui
