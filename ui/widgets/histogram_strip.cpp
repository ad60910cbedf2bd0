#include "ui/widgets/histogram_strip.hpp"

#include "document/play.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "ui/style/label.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr float height_em = 2.6F;

/// The most samples in a part, for each column of pixels of the slider's range.
std::vector<std::uint64_t> columns_of(const Histogram& histogram, const Slider& slider,
                                      std::size_t count) {
    std::vector<std::uint64_t> columns(count);
    const double step = (slider.hi - slider.lo) / static_cast<double>(count);
    const auto parts = static_cast<double>(histogram.counts.size());
    for (std::size_t i = 0; i < count; ++i) {
        const double value = slider.lo + static_cast<double>(i) * step;
        const double first = std::floor((value - histogram.first) / histogram.width);
        const double last = std::ceil((value + step - histogram.first) / histogram.width);
        const double from = std::clamp(first, 0.0, parts);
        const double to = std::clamp(std::max(last, first + 1.0), 0.0, parts);
        for (auto part = static_cast<std::size_t>(from); part < static_cast<std::size_t>(to);
             ++part)
            columns[i] = std::max(columns[i], histogram.counts[part]);
    }
    return columns;
}

void draw_columns(const std::vector<std::uint64_t>& columns, ImVec2 lo, ImVec2 hi, ImU32 color) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const double largest =
        std::log1p(static_cast<double>(std::max<std::uint64_t>(std::ranges::max(columns), 1)));
    const float wide = (hi.x - lo.x) / static_cast<float>(columns.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (columns[i] == 0) continue;
        const auto high = static_cast<float>(std::log1p(static_cast<double>(columns[i])) / largest);
        const float left = lo.x + static_cast<float>(i) * wide;
        list.AddRectFilled({left, std::min(hi.y - high * (hi.y - lo.y), hi.y - 1.0F)},
                           {left + wide, hi.y}, color);
    }
}

/// How many samples lie about a value.
std::uint64_t count_at(const Histogram& histogram, double value) {
    const double part = std::floor((value - histogram.first) / histogram.width);
    if (!(part >= 0.0) || part >= static_cast<double>(histogram.counts.size())) return 0;
    return histogram.counts[static_cast<std::size_t>(part)];
}

}  // namespace

void draw_histogram(const char* id, const Histogram& histogram, Slider& slider, float width,
                    const Palette& colors) {
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    const ImVec2 size(std::max(width, 1.0F), em(height_em));
    const ImVec2 hi(lo.x + size.x, lo.y + size.y);
    ImGui::InvisibleButton(id, size);
    // The slider's grab does not reach its ends.
    const ImGuiStyle& style = ImGui::GetStyle();
    const float inset = 2.0F + 0.5F * style.GrabMinSize;
    const float left = lo.x + inset;
    const float track = std::max(size.x - 2.0F * inset, 1.0F);
    const double under =
        slider.lo +
        (slider.hi - slider.lo) *
            std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - left) / track), 0.0, 1.0);
    if (ImGui::IsItemActive()) set_value(slider, on_step(slider, under));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(lo, hi, colors.field, style.FrameRounding);
    draw_columns(
        columns_of(histogram, slider, std::max<std::size_t>(static_cast<std::size_t>(track), 1)),
        {left, lo.y + 2.0F}, {left + track, hi.y}, colors.quiet);
    const auto share = static_cast<float>(
        std::clamp((slider.value - slider.lo) / (slider.hi - slider.lo), 0.0, 1.0));
    const float at = left + share * track;
    list.AddRectFilled({at - 1.0F, lo.y}, {at + 1.0F, hi.y}, colors.accent);
    draw_tooltip(
        filled(tr("How many samples have which value; heights are logarithms. At {0}: {1}.\n"
                  "Press or drag to choose the value of the surface."),
               {localized(short_number(under)), std::to_string(count_at(histogram, under))}));
}

}  // namespace zeroset::ui
