#include "ui/panels/statement_field.hpp"

#include "ui/model/soft_wrap.hpp"
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
#include <string_view>
#include <utility>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr std::ptrdiff_t most_lines = 8;

std::ptrdiff_t lines_of(const std::string& text) {
    return 1 + std::count(text.begin(), text.end(), '\n');
}

/// The text as a field of this width shows it, in the current font.
WrappedText as_shown(const std::string& text, float width) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float space = width - 2.0F * style.FramePadding.x - style.ScrollbarSize;
    return wrapped(text, space, [](std::string_view character) {
        const char* const begin = character.data();
        return ImGui::CalcTextSize(begin, begin + character.size()).x;
    });
}

/// Input and output of the text field's callback.
struct FieldEdit {
    const std::string* reload = nullptr;  ///< new text of the field, if not null
    std::optional<RowFocus> focus;        ///< where the caret is to be
    bool ahead = false;                   ///< Delete is pressed
    float width = 0.0F;                   ///< of the field
    WrappedText* shown = nullptr;         ///< what the field shows
    std::string* plain = nullptr;         ///< its text without the breaks that were put in
};

void put_caret(ImGuiInputTextCallbackData& data, const RowFocus& focus, const WrappedText& shown) {
    if (focus.caret == RowFocus::Caret::All) return data.SelectAll();
    if (focus.caret == RowFocus::Caret::At) {
        data.CursorPos = static_cast<int>(shown_place(shown, focus.at));
    } else {
        data.CursorPos = focus.caret == RowFocus::Caret::Start ? 0 : data.BufTextLen;
    }
    data.ClearSelection();
}

int on_edit(ImGuiInputTextCallbackData* data) {
    FieldEdit& edit = *static_cast<FieldEdit*>(data->UserData);
    WrappedText& shown = *edit.shown;
    PlainEdit now{.text = *edit.plain,
                  .caret = plain_place(shown, static_cast<std::size_t>(data->CursorPos))};
    if (edit.reload != nullptr && *edit.reload != *edit.plain) {
        now = {.text = *edit.reload, .caret = edit.reload->size()};
    } else if (shown.text != data->Buf) {
        now = plain_edit(shown, data->Buf, static_cast<std::size_t>(data->CursorPos), edit.ahead);
    }
    shown = as_shown(now.text, edit.width);
    *edit.plain = std::move(now.text);
    if (shown.text != data->Buf) {
        data->DeleteChars(0, data->BufTextLen);
        data->InsertChars(0, shown.text.c_str());
        data->CursorPos = static_cast<int>(shown_place(shown, now.caret));
        data->ClearSelection();
    }
    if (edit.focus) put_caret(*data, *edit.focus, shown);
    return 0;
}

/// Height of a field that shows this, breaks included.
float height_of(const std::string& shown) {
    const float line = font(FontRole::Formula)->FontSize * ImGui::GetIO().FontGlobalScale;
    const auto lines = static_cast<float>(std::min(lines_of(shown), most_lines));
    return std::ceil(lines * line + 2.0F * ImGui::GetStyle().FramePadding.y);
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
std::optional<RowFocus> wished_focus(const UiState& state, int row, ImGuiID field) {
    if (!state.wishes.focus || state.wishes.focus->row != row) return std::nullopt;
    if (!is_active(field)) ask_for_keyboard(field);
    return state.wishes.focus;
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

/// The text that is selected in the field, without the breaks that were put in.
std::string selection_in(ImGuiID field, const WrappedText& shown) {
    const ImGuiInputTextState* typing = ImGui::GetInputTextState(field);
    if (typing == nullptr || typing->Stb.select_start == typing->Stb.select_end) return {};
    const auto [first, last] = std::minmax(typing->Stb.select_start, typing->Stb.select_end);
    // ImGui counts in characters.
    const ImWchar* const begin = typing->TextW.Data;
    const auto place = [begin](int count) {
        return static_cast<std::size_t>(ImTextCountUtf8BytesFromStr(begin, begin + count));
    };
    return plain_part(shown, place(std::min(first, typing->CurLenW)),
                      place(std::min(last, typing->CurLenW)));
}

bool is_copying() {
    const ImGuiIO& io = ImGui::GetIO();
    return (io.KeyCtrl &&
            (is_letter_pressed('c') || is_letter_pressed('x') || is_pressed(ImGuiKey_Insert))) ||
           (io.KeyShift && is_pressed(ImGuiKey_Delete));
}

/// Draws the text field itself; true if its text, `edit.plain`, changed.
bool edit_text(const char* id, FieldEdit& edit) {
    constexpr ImGuiInputTextFlags flags = ImGuiInputTextFlags_CtrlEnterForNewLine |
                                          ImGuiInputTextFlags_NoUndoRedo |
                                          ImGuiInputTextFlags_CallbackAlways;
    const ShiftEnter shift_enter;
    const ImGuiID field = ImGui::GetID(id);
    const std::string selected = is_copying() ? selection_in(field, *edit.shown) : std::string();
    const std::string before = *edit.plain;
    std::string text = edit.shown->text;
    ImGui::InputTextMultiline(id, &text, ImVec2(edit.width, height_of(text)), flags, on_edit,
                              &edit);
    if (!selected.empty()) ImGui::SetClipboardText(selected.c_str());
    return *edit.plain != before;
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

float statement_field_height(const std::string& text, float width) {
    ImGui::PushFont(font(FontRole::Formula));
    const float height = height_of(as_shown(text, width).text);
    ImGui::PopFont();
    return height;
}

FieldEvent draw_statement_field(UiState& state, Statement& statement, const RowError* error,
                                float width, const char* hint) {
    ImGui::PushFont(font(FontRole::Formula));
    const char* const id = "##equation";
    const ImGuiID field = ImGui::GetID(id);
    FieldEvent event = FieldEvent::None;
    const bool typing = is_active(field);
    // A field at work shows what it showed in the frame before.
    WrappedText shown = typing && state.input.typed.row == statement.id
                            ? state.input.typed.shown
                            : as_shown(statement.text, width);
    const CaretLines caret = caret_lines(field, shown.text);
    if (typing) event = list_key(statement.text);
    if (typing && event == FieldEvent::None) event = arrow_key(caret);
    const bool escape = typing && is_pressed(ImGuiKey_Escape);
    // Leave before the field sees Escape: it would restore the text it had when editing began.
    if (escape) leave_field();
    if (leads_to_row(state, statement.id, event)) ImGui::NavMoveRequestCancel();
    const std::string typed = statement.text;
    const std::string reloaded = statement.text;
    FieldEdit edit{.focus = wished_focus(state, statement.id, field),
                   .ahead = is_pressed(ImGuiKey_Delete),
                   .width = width,
                   .shown = &shown,
                   .plain = &statement.text};
    if (state.wishes.reload == statement.id) {
        edit.reload = &reloaded;
        state.wishes.reload.reset();
    }
    const bool changed = edit_text(id, edit);
    if (edit.focus && is_active(field)) state.wishes.focus.reset();
    if (changed && came_at_once(typed, statement.text)) event = FieldEvent::Paste;
    // Leave only after the field has taken the characters typed before the key.
    if (is_active(field) && event != FieldEvent::None) leave_field();
    if (typing || is_active(field)) {
        state.input.typing_row = statement.id;
        state.input.typed = {.row = statement.id, .shown = shown};
    }

    const auto& children = ImGui::GetCurrentWindow()->DC.ChildWindows;
    if (!children.empty()) {
        const FieldView view = view_of(field, *children.back());
        if (statement.text.empty() && hint != nullptr) {
            draw_hint(view, hint, palette(state.edited.theme).quiet);
        } else if (error != nullptr && !(error->unfinished && is_active(field))) {
            const std::size_t at = shown_place(shown, std::min(error->at, statement.text.size()));
            draw_error_mark(view, shown.text, at, palette(state.edited.theme).error);
        }
    }
    ImGui::PopFont();
    return event;
}

}  // namespace zeroset::ui
