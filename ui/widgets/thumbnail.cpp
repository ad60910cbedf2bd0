#include "ui/widgets/thumbnail.hpp"

#include <cstdint>

namespace zeroset::ui {

void draw_thumbnail(unsigned int name, const ImVec2& lo, const ImVec2& hi, const Palette& colors) {
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    canvas.AddRectFilledMultiColor(lo, hi, colors.sky, colors.sky, colors.ground, colors.ground);
    if (name == 0) {
        const ImVec2 size = ImGui::CalcTextSize("...");
        canvas.AddText(ImVec2(0.5F * (lo.x + hi.x - size.x), 0.5F * (lo.y + hi.y - size.y)),
                       colors.quiet, "...");
        return;
    }
    const auto id = static_cast<std::uintptr_t>(name);
    // ImGui's texture handle is a pointer that the OpenGL renderer uses as a number.
    // NOLINTNEXTLINE(performance-no-int-to-ptr): ImGui keeps OpenGL's number as a pointer
    canvas.AddImage(reinterpret_cast<ImTextureID>(id), lo, hi);
}

}  // namespace zeroset::ui
