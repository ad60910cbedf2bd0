#include "ui/exports/export_parts.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/number_field.hpp"

#include <imgui/imgui.h>

#include <array>
#include <cstddef>

namespace zeroset::ui {
namespace {

using Hidden = DrawingExport::Hidden;

constexpr std::array<const char*, 3> hidden_names{"left out", "dashed", "as the others"};

struct KindText {
    const char* name;
    const char* about;
};
/// In the order of CurveKind.
constexpr std::array<KindText, 5> kinds{{
    {.name = "silhouettes", .about = "Where rays from the eye touch the surface."},
    {.name = "creases", .about = "Where the surface has an edge, or meets itself."},
    {.name = "boundaries", .about = "Where the box or a section ends the surface."},
    {.name = "intersections", .about = "Where two surfaces meet."},
    {.name = "contours", .about = "The contour lines of the section Look."},
}};

void draw_page_size(glm::dvec2& size_mm) {
    draw_export_label("page, mm", "Width and height.");
    const float room = ImGui::GetContentRegionAvail().x - em(1.6F);
    ImGui::SetNextItemWidth(0.5F * room);
    draw_number_field("##page width", size_mm.x, 4.0, 3500.0);
    ImGui::SameLine(0.0F, em(0.4F));
    ImGui::TextUnformatted("\xC3\x97");
    ImGui::SameLine(0.0F, em(0.4F));
    ImGui::SetNextItemWidth(0.5F * room);
    draw_number_field("##page height", size_mm.y, 4.0, 3500.0);
}

void draw_hidden(DrawingExport& wish) {
    draw_export_label("hidden lines", "What becomes of the parts that surfaces hide.");
    const auto chosen = static_cast<std::size_t>(wish.hidden);
    if (!ImGui::BeginCombo("##hidden", hidden_names.at(chosen))) return;
    for (std::size_t i = 0; i < hidden_names.size(); ++i) {
        if (ImGui::Selectable(hidden_names.at(i), i == chosen))
            wish.hidden = static_cast<Hidden>(i);
    }
    ImGui::EndCombo();
}

}  // namespace

void draw_drawing_part(UiState& state) {
    DrawingExport& wish = state.pages.exports.wish.drawing;
    draw_page_size(wish.size_mm);
    draw_export_label("width, pt", "Of silhouettes; the other lines are thinner.");
    draw_number_field("##line width", wish.width_pt, 0.01, 100.0);
    draw_export_label("tolerance, pt", "How far lines may be from the true ones on the page.");
    draw_number_field("##tolerance", wish.tolerance_pt, 1e-4, 10.0);
    draw_hidden(wish);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (i % 3 != 0) ImGui::SameLine(em(9.0F) * static_cast<float>(i % 3) + em(0.6F));
        ImGui::Checkbox(kinds.at(i).name, &wish.kinds.at(i));
        draw_tooltip(kinds.at(i).about);
    }
}

}  // namespace zeroset::ui
