#include "ui/panels/statement_field.hpp"

#include "ui/model/ui_state.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/keys.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/error_mark.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr std::ptrdiff_t most_lines = 8;

std::ptrdiff_t lines_of(const std::string& text) {
    return 1 + std::count(text.begin(), text.end(), '\n');
}

/// Input and output of the text field's callback.
struct FieldEdit {
    const std::string* reload = nullptr;  ///< new text of the field, if not null
    std::optional<RowFocus::Caret> caret;
    bool in_first_line = true;
    bool in_last_line = true;
};

int on_edit(ImGuiInputTextCallbackData* data) {
    FieldEdit& edit = *static_cast<FieldEdit*>(data->UserData);
    if (edit.reload != nullptr && *edit.reload != data->Buf) {
        data->DeleteChars(0, data->BufTextLen);
        data->InsertChars(0, edit.reload->c_str());
        edit.caret = RowFocus::Caret::End;
    }
    if (edit.caret == RowFocus::Caret::All) {
        data->SelectAll();
    } else if (edit.caret) {
        data->CursorPos = edit.caret == RowFocus::Caret::Start ? 0 : data->BufTextLen;
        data->ClearSelection();
    }
    const char* const caret = data->Buf + data->CursorPos;
    edit.in_first_line = std::find(static_cast<const char*>(data->Buf), caret, '\n') == caret;
    const char* const end = data->Buf + data->BufTextLen;
    edit.in_last_line = std::find(caret, end, '\n') == end;
    return 0;
}

bool is_active(ImGuiID field) { return ImGui::GetActiveID() == field; }

/// Returns the event of a key that the list handles, checked before the field sees it; None leaves
/// the key to the field.
FieldEvent list_key(const std::string& text) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyAlt && is_pressed(ImGuiKey_UpArrow)) return FieldEvent::MoveUp;
    if (io.KeyAlt && is_pressed(ImGuiKey_DownArrow)) return FieldEvent::MoveDown;
    if (io.KeyCtrl && is_letter_pressed('d')) return FieldEvent::Duplicate;
    if (is_pressed(ImGuiKey_Tab)) {
        return io.KeyShift ? FieldEvent::TabBackward : FieldEvent::TabForward;
    }
    if (text.empty() && is_pressed(ImGuiKey_Backspace)) return FieldEvent::DeleteBack;
    if (text.empty() && is_pressed(ImGuiKey_Delete)) return FieldEvent::DeleteAhead;
    const bool enter = is_pressed(ImGuiKey_Enter) || is_pressed(ImGuiKey_KeyPadEnter);
    if (enter && !io.KeyShift && !io.KeyCtrl) return FieldEvent::NextRow;
    return FieldEvent::None;
}

/// Takes the keyboard from the field; characters of the next frame go elsewhere.
void leave_field() {
    ImGui::ClearActiveID();
    ImGui::GetCurrentContext()->WantTextInputNextFrame = -1;
}

/// True where the caret was in the first, in the last line at the end of the previous frame: there
/// the arrow keys Up, Down leave the field.
struct CaretLines {
    bool first = true;
    bool last = true;
};

FieldEvent arrow_key(const CaretLines& caret) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyShift || io.KeyCtrl || io.KeyAlt) return FieldEvent::None;
    if (caret.first && is_pressed(ImGuiKey_UpArrow)) return FieldEvent::Up;
    if (caret.last && is_pressed(ImGuiKey_DownArrow)) return FieldEvent::Down;
    return FieldEvent::None;
}

CaretLines caret_lines(ImGuiID field, const std::string& text) {
    const ImGuiInputTextState* typing = ImGui::GetInputTextState(field);
    if (typing == nullptr) return {};
    // ImGui counts in characters, not bytes; line ends count as one in both.
    const ImWchar* const begin = typing->TextW.Data;
    const ImWchar* const caret = begin + std::min(typing->Stb.cursor, typing->CurLenW);
    const auto before = std::count(begin, caret, static_cast<ImWchar>('\n'));
    return {.first = before == 0, .last = before == lines_of(text) - 1};
}

/// Asks ImGui for the keyboard, which it gives in the next frame. A second request in that frame
/// would begin again and lose the frame's keys.
void ask_for_keyboard(ImGuiID field) {
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const int frame = ImGui::GetFrameCount();
    if (storage.GetInt(field, -1) == frame - 1) return;
    storage.SetInt(field, frame);
    ImGui::SetKeyboardFocusHere();
}

/// Returns the wished caret position if the keyboard is to go to this field, and asks for the
/// keyboard.
std::optional<RowFocus::Caret> wished_caret(const UiState& state, int row, ImGuiID field) {
    if (!state.wishes.focus || state.wishes.focus->row != row) return std::nullopt;
    if (!is_active(field)) ask_for_keyboard(field);
    return state.wishes.focus->caret;
}

/// Makes Shift+Enter insert a line break while it lives, by pretending that it is ImGui's
/// Ctrl+Enter.
class ShiftEnter {
public:
    ShiftEnter() : ctrl_(ImGui::GetIO().KeyCtrl), mods_(ImGui::GetIO().KeyMods) {
        ImGuiIO& io = ImGui::GetIO();
        const bool enter = is_pressed(ImGuiKey_Enter) || is_pressed(ImGuiKey_KeyPadEnter);
        if (!enter || !io.KeyShift) return;
        io.KeyCtrl = true;
        io.KeyMods |= ImGuiKeyModFlags_Ctrl;
    }
    ~ShiftEnter() {
        ImGui::GetIO().KeyCtrl = ctrl_;
        ImGui::GetIO().KeyMods = mods_;
    }
    ShiftEnter(const ShiftEnter&) = delete;
    ShiftEnter& operator=(const ShiftEnter&) = delete;

private:
    bool ctrl_;
    ImGuiKeyModFlags mods_;
};

/// Draws the text field itself; true if its text changed.
bool edit_text(const char* id, std::string& text, float width, FieldEdit& edit) {
    constexpr ImGuiInputTextFlags flags = ImGuiInputTextFlags_CtrlEnterForNewLine |
                                          ImGuiInputTextFlags_NoUndoRedo |
                                          ImGuiInputTextFlags_CallbackAlways;
    const ShiftEnter shift_enter;
    return ImGui::InputTextMultiline(id, &text, ImVec2(width, statement_field_height(text)), flags,
                                     on_edit, &edit);
}

/// True if a Tab goes to another row; from the last and the first one ImGui leads on.
bool leads_to_row(const UiState& state, int row, FieldEvent event) {
    const std::vector<Statement>& rows = state.edited.document.statements;
    return (event == FieldEvent::TabForward && row != rows.back().id) ||
           (event == FieldEvent::TabBackward && row != rows.front().id);
}

bool came_at_once(const std::string& before, const std::string& after) {
    return after.size() > before.size() + 1 && lines_of(after) > lines_of(before);
}

}  // namespace

float statement_field_height(const std::string& text) {
    const float line = font(FontRole::Formula)->FontSize * ImGui::GetIO().FontGlobalScale;
    const auto lines = static_cast<float>(std::min(lines_of(text), most_lines));
    return std::ceil(lines * line + 2.0F * ImGui::GetStyle().FramePadding.y);
}

FieldEvent draw_statement_field(UiState& state, Statement& statement, const RowError* error,
                                float width, const char* hint) {
    ImGui::PushFont(font(FontRole::Formula));
    const char* const id = "##equation";
    const ImGuiID field = ImGui::GetID(id);
    FieldEvent event = FieldEvent::None;
    FieldEdit edit;
    edit.caret = wished_caret(state, statement.id, field);
    const bool typing = is_active(field);
    const CaretLines caret = caret_lines(field, statement.text);
    if (typing) event = list_key(statement.text);
    if (typing && event == FieldEvent::None) event = arrow_key(caret);
    const bool escape = typing && is_pressed(ImGuiKey_Escape);
    // Leave before the field sees Escape: it would restore the text it had when editing began.
    if (escape) leave_field();
    if (leads_to_row(state, statement.id, event)) ImGui::NavMoveRequestCancel();
    const std::string typed = statement.text;
    const std::string reloaded = statement.text;
    if (state.wishes.reload == statement.id) {
        edit.reload = &reloaded;
        state.wishes.reload.reset();
    }
    const bool changed = edit_text(id, statement.text, width, edit);
    if (edit.caret && is_active(field)) state.wishes.focus.reset();
    if (changed && came_at_once(typed, statement.text)) event = FieldEvent::Paste;
    // Leave only after the field has taken the characters typed before the key.
    if (is_active(field) && event != FieldEvent::None) leave_field();
    if (typing || is_active(field)) state.input.typing_row = statement.id;

    const auto& children = ImGui::GetCurrentWindow()->DC.ChildWindows;
    if (!children.empty()) {
        const FieldView view = view_of(field, *children.back());
        if (statement.text.empty() && hint != nullptr) {
            draw_hint(view, hint, palette(state.edited.theme).quiet);
        } else if (error != nullptr && !error->unfinished) {
            draw_error_mark(view, statement.text, error->at, palette(state.edited.theme).error);
        }
    }
    ImGui::PopFont();
    return event;
}

}  // namespace zeroset::ui
