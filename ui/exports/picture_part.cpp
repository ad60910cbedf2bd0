#include "engine/base/translation.hpp"
#include "ui/exports/export_parts.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/number_field.hpp"
#include "ui/widgets/slider_row.hpp"

#include <imgui/imgui.h>

#include <array>
#include <cfloat>
#include <string>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr int largest_picture = 65536;

/// A size that is often wanted.
struct UsualSize {
    std::string name;
    glm::ivec2 px;
};

std::vector<UsualSize> usual_sizes(const glm::ivec2& window_px) {
    return {{.name = tr("As the window"), .px = window_px},
            {.name = tr("Twice the window"), .px = 2 * window_px},
            {.name = "HD, 1280 \xC3\x97 720", .px = {1280, 720}},
            {.name = "Full HD, 1920 \xC3\x97 1080", .px = {1920, 1080}},
            {.name = "4K, 3840 \xC3\x97 2160", .px = {3840, 2160}},
            {.name = "8K, 7680 \xC3\x97 4320", .px = {7680, 4320}},
            {.name = tr("Square, 1080 \xC3\x97 1080"), .px = {1080, 1080}},
            {.name = tr("Upright, 1080 \xC3\x97 1920"), .px = {1080, 1920}},
            {.name = tr("A4 at 300 dpi, 3508 \xC3\x97 2480"), .px = {3508, 2480}},
            {.name = tr("A3 at 300 dpi, 4961 \xC3\x97 3508"), .px = {4961, 3508}}};
}

void draw_bits(PictureExport& wish, const ExportFormat& format) {
    if (!format.deep) return;
    draw_export_label(tr("bits"), tr("Of each color channel."));
    const int bits = wish.bits == format.bits[1] ? wish.bits : format.bits[0];
    if (!ImGui::BeginCombo("##bits", std::to_string(bits).c_str())) return;
    for (const int choice : format.bits) {
        if (ImGui::Selectable(std::to_string(choice).c_str(), choice == bits)) wish.bits = choice;
    }
    ImGui::EndCombo();
}

}  // namespace

void draw_export_label(const char* label, const char* about) {
    draw_label(label, about, export_label_em);
}

void draw_size_fields(glm::ivec2& size_px, const glm::ivec2& window_px, int largest, bool even) {
    draw_export_label(tr("size"), tr("Width and height in pixels."));
    const float arrow = ImGui::GetFrameHeight();
    const float space = ImGui::GetContentRegionAvail().x - arrow - em(2.0F);
    ImGui::SetNextItemWidth(0.5F * space);
    draw_integer_field("##width", size_px.x, 1, largest);
    ImGui::SameLine(0.0F, em(0.4F));
    ImGui::TextUnformatted("\xC3\x97");
    ImGui::SameLine(0.0F, em(0.4F));
    ImGui::SetNextItemWidth(0.5F * space);
    draw_integer_field("##height", size_px.y, 1, largest);
    ImGui::SameLine(0.0F, em(0.4F));
    if (ImGui::BeginCombo("##sizes", "",
                          ImGuiComboFlags_NoPreview | ImGuiComboFlags_HeightLarge |
                              ImGuiComboFlags_PopupAlignLeft)) {
        for (const UsualSize& usual : usual_sizes(window_px)) {
            if (ImGui::Selectable(usual.name.c_str(), usual.px == size_px)) size_px = usual.px;
        }
        ImGui::EndCombo();
    }
    draw_tooltip(tr("Usual sizes"));
    if (even) size_px += size_px % 2;
}

void draw_surface_checks(bool& smooth, bool& alpha, bool has_alpha) {
    ImGui::Checkbox(tr("Smooth edges"), &smooth);
    draw_tooltip(tr("Pixels at edges are mixed by how much of them the surface covers."));
    if (!has_alpha) return;
    ImGui::SameLine(0.0F, em(1.2F));
    ImGui::Checkbox(tr("Transparent"), &alpha);
    draw_tooltip(tr("Leave the background transparent."));
}

void draw_picture_part(UiState& state, const ExportFormat& format) {
    PictureExport& wish = state.pages.exports.wish.picture;
    draw_size_fields(wish.size_px, state.input.viewport_px, largest_picture);
    draw_bits(wish, format);
    if (format.density) {
        draw_export_label(tr("dots per inch"), tr("What printers are told; it changes no pixel."));
        draw_integer_field("##dpi", wish.dots_per_inch, 1, 100'000, tr("not told"));
    }
    if (format.quality) {
        draw_export_label(tr("quality"), tr("Less makes smaller files."));
        draw_integer_slider("##quality", wish.quality, 1, 100, nullptr);
    }
    draw_surface_checks(wish.smooth, wish.alpha, format.alpha);
}

}  // namespace zeroset::ui
