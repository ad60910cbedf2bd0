#include "ui/style/label.hpp"

#include "engine/base/utf8.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace zeroset::ui {

std::string labelled(const char* text, const char* id) { return std::string(text) + id; }

void draw_tooltip(const std::string& text, float width) {
    if (text.empty() || !ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(std::min(em(width), 0.8F * ImGui::GetIO().DisplaySize.x));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void draw_focus_ring() {
    ImGui::RenderNavHighlight(ImRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax()),
                              ImGui::GetItemID(), ImGuiNavHighlightFlags_TypeThin);
}

bool draw_elided(const std::string& text, float width) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float baseline = ImGui::GetCurrentWindow()->DC.CurrLineTextBaseOffset;
    const ImVec2 lo(at.x, at.y + baseline);
    const ImVec2 hi(lo.x + width,
                    lo.y + size.y + em(0.2F));  // room for an underscore
    ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), lo, hi, lo.x + width, lo.x + width,
                              text.c_str(), text.c_str() + text.size(), &size);
    ImGui::Dummy(ImVec2(std::min(size.x, width), size.y + baseline));
    return size.x > width;
}

std::string elided(const std::string& text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    const std::string ellipsis = "\xE2\x80\xA6";
    const float space = width - ImGui::CalcTextSize(ellipsis.c_str()).x;
    // Whole characters of UTF-8 only.
    std::size_t end = text.size();
    while (end > 0) {
        do {
            --end;
        } while (end > 0 && continues_character(text[end]));
        const char* const begin = text.c_str();
        if (ImGui::CalcTextSize(begin, begin + end).x <= space) break;
    }
    return text.substr(0, end) + ellipsis;
}

std::string elided_in_combo(const std::string& text) {
    return elided(text, ImGui::CalcItemWidth() - ImGui::GetFrameHeight() -
                            2.0F * ImGui::GetStyle().FramePadding.x);
}

void flow(float width, float gap, float column) {
    const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + gap + width <= right) {
        ImGui::SameLine(0.0F, gap);
    } else {
        ImGui::SetCursorPosX(column);
    }
}

std::string in_one_line(const std::string& text) {
    std::string line;
    for (const char character : text) {
        if (character == '\n') {
            line += "; ";
        } else {
            line += character;
        }
    }
    return line;
}

}  // namespace zeroset::ui
