#include "engine/base/translation.hpp"
#include "ui/exports/export_parts.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/number_field.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace zeroset::ui {
namespace {

using Shape = MeshExport::Shape;

struct ShapeText {
    Shape shape;
    const char* name;
    const char* about;
};
constexpr std::array<ShapeText, 4> shapes{{
    {.shape = Shape::Solid, .name = "Solid", .about = "Where f < 0, closed where the box ends it."},
    {.shape = Shape::Wall, .name = "Wall", .about = "The surface as a wall that can be printed."},
    {.shape = Shape::Open,
     .name = "Open surface",
     .about = "The surface alone, without thickness."},
    {.shape = Shape::Formula,
     .name = "Formula",
     .about = "The formula itself as an implicit function of 3MF, without triangles; few programs "
              "read it yet."},
}};

void draw_shape(ExportPage& page) {
    MeshExport& wish = page.wish.mesh;
    draw_export_label(tr("shape"), tr("What becomes of the surface."));
    const auto* const chosen = std::ranges::find(shapes, wish.shape, &ShapeText::shape);
    if (!ImGui::BeginCombo("##shape", tr(chosen->name))) return;
    for (const ShapeText& text : shapes) {
        if (ImGui::Selectable(tr(text.name), text.shape == wish.shape)) {
            wish.shape = text.shape;
            if (text.shape == Shape::Formula)
                page.endings.at(static_cast<std::size_t>(ExportKind::Mesh)) = formula_ending;
        }
        draw_tooltip(tr(text.about));
    }
    ImGui::EndCombo();
}

/// Draws what is chosen of triangles.
void draw_triangles(MeshExport& wish) {
    draw_export_label(tr("exact to, mm"),
                      tr("How far triangles may be from the surface, where the clip box's longest "
                         "edge has the size above."));
    draw_number_field("##tolerance", wish.tolerance_mm, 1e-9, 1e9);
    draw_export_label(tr("triangles"), tr("At most about so many for each surface."));
    draw_integer_field("##triangles", wish.most_triangles, 4, 1'000'000'000,
                       tr("as many as needed"));
}

}  // namespace

void draw_mesh_part(UiState& state, const ExportFormat& format) {
    MeshExport& wish = state.pages.exports.wish.mesh;
    // Another format was chosen, which has no formulas.
    if (wish.shape == Shape::Formula && format.ending != formula_ending) wish.shape = Shape::Solid;
    draw_shape(state.pages.exports);
    if (wish.shape == Shape::Wall) {
        draw_export_label(tr("wall, mm"), tr("How thick the wall is."));
        draw_number_field("##wall", wish.wall_mm, 1e-6, 1e6);
    }
    const bool has_triangles = wish.shape != Shape::Formula;
    draw_export_label(tr("size, mm"), has_triangles ? tr("The longest edge of what is written.")
                                                    : tr("The longest edge of the clip box."));
    draw_number_field("##size", wish.size_mm, 1e-6, 1e6);
    if (has_triangles) draw_triangles(wish);
}

}  // namespace zeroset::ui
