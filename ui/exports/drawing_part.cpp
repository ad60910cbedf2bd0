#include "engine/base/translation.hpp"
#include "ui/exports/export_parts.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/number_field.hpp"

#include <imgui/imgui.h>

#include <array>
#include <cfloat>
#include <cstddef>
#include <string>

namespace zeroset::ui {
namespace {

using Hidden = DrawingExport::Hidden;

constexpr std::array<const char*, 3> hidden_names{marked("left out"), marked("dashed"),
                                                  marked("as the others")};

struct KindText {
    const char* name;
    const char* about;
    const char* usual_width;  ///< shown where none is chosen
};
/// In the order of CurveKind.
constexpr std::array<KindText, 5> kinds{{
    {.name = "silhouettes",
     .about = "Where rays from the eye touch the surface.",
     .usual_width = nullptr},
    {.name = "creases",
     .about = "Where the surface has an edge, or meets itself.",
     .usual_width = "0.8 \xC3\x97 silhouettes"},
    {.name = "boundaries",
     .about = "Where the box, a section or a jump ends the surface.",
     .usual_width = "0.8 \xC3\x97 silhouettes"},
    {.name = "intersections",
     .about = "Where two surfaces meet.",
     .usual_width = "0.8 \xC3\x97 silhouettes"},
    {.name = "contours",
     .about = "The contour lines that are chosen in the section Look.",
     .usual_width = "0.4 \xC3\x97 silhouettes"},
}};

void draw_page_size(glm::dvec2& size_mm) {
    draw_export_label(tr("page, mm"), tr("Width and height."));
    const float space = ImGui::GetContentRegionAvail().x - em(1.6F);
    ImGui::SetNextItemWidth(0.5F * space);
    draw_number_field("##page width", size_mm.x, 4.0, 3500.0);
    ImGui::SameLine(0.0F, em(0.4F));
    ImGui::TextUnformatted("\xC3\x97");
    ImGui::SameLine(0.0F, em(0.4F));
    ImGui::SetNextItemWidth(0.5F * space);
    draw_number_field("##page height", size_mm.y, 4.0, 3500.0);
}

/// Draws the row of one kind of line, with its width.
void draw_kind(DrawingExport& wish, std::size_t kind) {
    ImGui::Checkbox(tr(kinds.at(kind).name), &wish.kinds.at(kind));
    draw_tooltip(tr(kinds.at(kind).about));
    ImGui::SameLine(em(11.0F));
    ImGui::SetNextItemWidth(-FLT_MIN);
    const std::string id = std::string("##width of ") + kinds.at(kind).name;
    const bool is_silhouette = kind == 0;
    draw_number_field(id.c_str(), is_silhouette ? wish.width_pt : wish.widths_pt.at(kind),
                      is_silhouette ? 0.01 : 0.0, 100.0,
                      is_silhouette ? nullptr : tr(kinds.at(kind).usual_width));
    draw_tooltip(is_silhouette ? tr("Width in points.")
                               : tr("Width in points; 0: by that of silhouettes."));
}

void draw_hidden(DrawingExport& wish) {
    draw_export_label(tr("hidden lines"), tr("What becomes of the parts that surfaces hide."));
    const auto chosen = static_cast<std::size_t>(wish.hidden);
    if (!ImGui::BeginCombo("##hidden", tr(hidden_names.at(chosen)))) return;
    for (std::size_t i = 0; i < hidden_names.size(); ++i) {
        if (ImGui::Selectable(tr(hidden_names.at(i)), i == chosen))
            wish.hidden = static_cast<Hidden>(i);
    }
    ImGui::EndCombo();
}

}  // namespace

void draw_drawing_part(UiState& state) {
    DrawingExport& wish = state.pages.exports.wish.drawing;
    draw_page_size(wish.size_mm);
    draw_export_label(tr("tolerance, pt"),
                      tr("How far lines may be from the true ones on the page."));
    draw_number_field("##tolerance", wish.tolerance_pt, 1e-4, 10.0);
    draw_hidden(wish);
    draw_export_label(tr("lines"), tr("Which are drawn, and how wide they are, in points."));
    ImGui::NewLine();
    for (std::size_t i = 0; i < kinds.size(); ++i)
        draw_kind(wish, i);
}

}  // namespace zeroset::ui
