#include "ui/widgets/number_field.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace zeroset::ui {

bool read_typed(const std::string& typed, double& value) {
    std::string text(trimmed(typed));
    std::ranges::replace(text, ',', '.');
    const char* const end = text.data() + text.size();
    double read = 0.0;
    const auto result = std::from_chars(text.data(), end, read);
    if (text.empty() || result.ec != std::errc() || result.ptr != end) return false;
    value = read;
    return true;
}

bool draw_number_field(const char* id, double& value, double lo, double hi, const char* empty) {
    constexpr int digits = 7;
    const bool blank = empty != nullptr && value == 0.0;
    std::string text = blank ? "" : localized(short_number(value, digits));
    // While it is typed into, ImGui keeps the text as typed and only tells of it.
    if (!ImGui::InputTextWithHint(id, empty, &text, ImGuiInputTextFlags_AutoSelectAll))
        return false;
    double read = 0.0;
    if (empty != nullptr && trimmed(text).empty()) {
        value = 0.0;
        return true;
    }
    if (!read_typed(text, read) || !(read >= lo && read <= hi)) return false;
    value = read;
    return true;
}

bool draw_integer_field(const char* id, int& value, int lo, int hi, const char* empty) {
    double number = value;
    if (!draw_number_field(id, number, lo, hi, empty)) return false;
    value = static_cast<int>(std::lround(number));
    return true;
}

}  // namespace zeroset::ui
