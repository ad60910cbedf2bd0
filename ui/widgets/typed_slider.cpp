#include "engine/base/translation.hpp"
#include "ui/style/keys.hpp"
#include "ui/widgets/number_field.hpp"
#include "ui/widgets/slider_row.hpp"

#include <imgui/imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace zeroset::ui {
namespace {

/// True if the user asks in this frame to type into the slider.
bool wants_text(ImGuiID slider) {
    const ImGuiContext& gui = *ImGui::GetCurrentContext();
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return true;
    if (gui.NavActivateInputId != slider) return false;
    const bool enter = is_pressed_once(ImGuiKey_Enter) || is_pressed_once(ImGuiKey_KeyPadEnter);
    // Tab asks for text, too; the slider itself gets the keyboard then.
    return enter || ImGui::GetStateStorage()->GetInt(slider, -1) == ImGui::GetFrameCount();
}

using TypedText = std::array<char, 64>;

/// The text that ImGui's slider begins to be typed into with.
TypedText first_text(ImGuiDataType type, const void* value, const char* format) {
    TypedText number{};
    TypedText trimmed{};
    format = ImParseFormatTrimDecorations(format, trimmed.data(), trimmed.size());
    ImGui::DataTypeFormatString(number.data(), static_cast<int>(number.size()), type, value,
                                format);
    std::ranges::replace(number, '.', decimal_mark());
    return number;
}

/// The format of a slider with its number written in it, as the user's language writes it; the
/// format itself where that is the same or ImGui does not show it.
std::string localized_format(const char* format, double value) {
    if (decimal_mark() == '.' || std::string_view(format).starts_with("##")) return format;
    TypedText text{};
    ImGui::DataTypeFormatString(text.data(), static_cast<int>(text.size()), ImGuiDataType_Double,
                                &value, format);
    std::string shown;
    for (const char letter : localized(text.data())) {
        shown += letter;
        if (letter == '%') shown += letter;
    }
    return shown;
}

/// The value with as many digits as the format shows.
double rounded_to(const char* format, double value) {
    double rounded = value;
    return read_typed(first_text(ImGuiDataType_Double, &value, format).data(), rounded) ? rounded
                                                                                        : value;
}

/// Draws the slider as the text field that it has become; the number typed in this frame, if any.
std::optional<double> draw_text(const char* id, ImGuiID slider, TypedText text) {
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    const ImRect frame(lo, ImVec2(lo.x + ImGui::CalcItemWidth(), lo.y + ImGui::GetFrameHeight()));
    ImGui::ItemSize(frame, ImGui::GetStyle().FramePadding.y);
    if (!ImGui::ItemAdd(frame, slider, &frame, ImGuiItemFlags_Inputable)) return std::nullopt;
    double typed = 0.0;
    constexpr ImGuiInputTextFlags marks_all = ImGuiInputTextFlags_AutoSelectAll;
    constexpr ImGuiInputTextFlags marks_nothing_edited = ImGuiInputTextFlags_NoMarkEdited;
    const bool edited =
        ImGui::TempInputText(frame, slider, id, text.data(), static_cast<int>(text.size()),
                             marks_all | marks_nothing_edited);
    const bool is_number = edited && read_typed(text.data(), typed) && std::isfinite(typed);
    return is_number ? std::optional(typed) : std::nullopt;
}

ImGuiSliderFlags flags_for(ImGuiID slider, ImGuiSliderFlags flags) {
    return wants_text(slider) ? flags : flags | ImGuiSliderFlags_NoInput;
}

}  // namespace

bool slide(const char* id, double& value, double lo, double hi, const char* format,
           ImGuiSliderFlags flags) {
    const ImGuiID slider = ImGui::GetID(id);
    if (!ImGui::TempInputIsActive(slider)) {
        const std::string shown = localized_format(format, value);
        const bool moved = ImGui::SliderScalar(id, ImGuiDataType_Double, &value, &lo, &hi,
                                               shown.c_str(), flags_for(slider, flags));
        if (moved && shown != format) value = rounded_to(format, value);
        return moved;
    }
    std::optional<double> typed =
        draw_text(id, slider, first_text(ImGuiDataType_Double, &value, format));
    if (!typed) return false;
    if ((flags & ImGuiSliderFlags_AlwaysClamp) != 0) typed = std::clamp(*typed, lo, hi);
    const bool changed = *typed != value;
    value = *typed;
    return changed;
}

bool slide(const char* id, int& value, int lo, int hi, const char* format, ImGuiSliderFlags flags) {
    const ImGuiID slider = ImGui::GetID(id);
    if (!ImGui::TempInputIsActive(slider))
        return ImGui::SliderInt(id, &value, lo, hi, format, flags_for(slider, flags));
    const std::optional<double> typed =
        draw_text(id, slider, first_text(ImGuiDataType_S32, &value, format));
    if (!typed || *typed != std::round(*typed)) return false;
    const int read =
        static_cast<int>(std::clamp(*typed, static_cast<double>(lo), static_cast<double>(hi)));
    const bool changed = read != value;
    value = read;
    return changed;
}

void type_into(ImGuiID slider) {
    ImGuiContext& gui = *ImGui::GetCurrentContext();
    gui.NavNextActivateId = slider;
    gui.NavNextActivateFlags = ImGuiActivateFlags_PreferInput;
    ImGui::GetStateStorage()->SetInt(slider, ImGui::GetFrameCount() + 1);
}

bool is_moved_by_keys(ImGuiID slider) {
    const ImGuiContext& gui = *ImGui::GetCurrentContext();
    return gui.ActiveId == slider && gui.ActiveIdSource == ImGuiInputSource_Nav;
}

}  // namespace zeroset::ui
