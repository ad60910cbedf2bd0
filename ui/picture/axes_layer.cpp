#include "engine/annotate/axes.hpp"
#include "engine/annotate/axis_shapes.hpp"
#include "engine/annotate/shapes.hpp"
#include "ui/picture/draw_shapes.hpp"
#include "ui/picture/layers.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

namespace zeroset::ui {
namespace {

AxesView view_of(const Document& document, const ShownPicture& picture, const ImVec2& extent) {
    return {.clip = document.clip,
            .camera = picture.camera,
            .up = document.up,
            .width = static_cast<int>(extent.x),
            .height = static_cast<int>(extent.y),
            .em = small_em(),
            .names = document.axis_names,
            .of_pi = picture.of_pi};
}

AxisStyle style_of(const Edited& edited) {
    const Background background =
        edited.document.light.background.value_or(picture_background(edited.theme));
    AxisStyle style = axis_style_on(background, small_em());
    style.least_width = 1.0 / static_cast<double>(ImGui::GetIO().DisplayFramebufferScale.x);
    return style;
}

}  // namespace

void draw_axes(ImDrawList& canvas, const ImVec2& lo, const ImVec2& hi, const Edited& edited,
               const ShownPicture& picture) {
    const Document& document = edited.document;
    const AxesChoice choice{
        .axes = document.axes, .clip_box = document.clip_box, .grid = document.grid};
    const ImVec2 extent(hi.x - lo.x, hi.y - lo.y);
    if (!choice.any() || picture.frame == nullptr || extent.x < 1.0F || extent.y < 1.0F) return;
    const Axes axes = make_axes(view_of(document, picture, extent), choice, *picture.frame);
    canvas.PushClipRect(lo, hi, true);
    draw_shapes(canvas, lo, axis_shapes(axes, style_of(edited)));
    canvas.PopClipRect();
}

}  // namespace zeroset::ui
