#include "ui/window/gui_context.hpp"

#include "ui/model/theme.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/theme.hpp"
#include "ui/window/gl.hpp"
#include "ui/window/window.hpp"

#include <GL/gl.h>
#include <imgui/backends/imgui_impl_opengl3.h>
#include <imgui/imgui.h>

#include <algorithm>

namespace zeroset::ui {

GuiContext::GuiContext(GlLoader loader) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    io.ConfigInputTextCursorBlink = true;
    ready_ = load_gl(loader) && ImGui_ImplOpenGL3_Init("#version 330 core");
}

GuiContext::~GuiContext() {
    if (ready_) ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
}

void GuiContext::begin_frame(Theme theme, float content_scale, float pixels_per_point) {
    const Style wanted{
        .theme = theme, .content_scale = content_scale, .pixels_per_point = pixels_per_point};
    if (wanted != style_) {
        const bool same_fonts = style_.content_scale == content_scale;
        style_ = wanted;
        if (!same_fonts) {
            ImGui_ImplOpenGL3_DestroyFontsTexture();
            load_fonts(content_scale);
            ImGui_ImplOpenGL3_CreateFontsTexture();
        }
        ImGui::GetIO().FontGlobalScale = 1.0F / pixels_per_point;
        apply_theme(theme, content_scale / pixels_per_point);
    }
    ImGui_ImplOpenGL3_NewFrame();
}

void GuiContext::begin_panels() {
    ImGui::NewFrame();
    navigation_.follow();
}

void GuiContext::end_frame() { ImGui::Render(); }

void GuiContext::rasterize(int width_px, int height_px) {
    gl().viewport(0, 0, width_px, height_px);
    gl().clear_color(0.0F, 0.0F, 0.0F, 1.0F);
    gl().clear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

float GuiContext::scale_of_letters(float content_scale, float letters, int width_px,
                                   int height_px) {
    const float space = std::min(static_cast<float>(width_px) / static_cast<float>(min_width),
                                 static_cast<float>(height_px) / static_cast<float>(min_height));
    const float wanted = content_scale * letters;
    return letters > 1.0F ? std::clamp(space, content_scale, std::max(wanted, content_scale))
                          : wanted;
}

bool GuiContext::wants_text() { return ImGui::GetIO().WantTextInput; }

}  // namespace zeroset::ui
