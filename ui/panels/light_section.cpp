#include "engine/base/translation.hpp"
#include "engine/image/gamma.hpp"
#include "engine/scene/lighting.hpp"
#include "ui/actions/actions.hpp"
#include "ui/panels/sections.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/card_grid.hpp"
#include "ui/widgets/color_picker.hpp"
#include "ui/widgets/light_ball.hpp"
#include "ui/widgets/look_names.hpp"
#include "ui/widgets/slider_row.hpp"

#include <glm/glm.hpp>
#include <imgui/imgui.h>

#include <algorithm>
#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr glm::vec2 look_picture_em(4.4F, 3.3F);
constexpr float ball_rows = 3.0F;  ///< the height of a light's ball, in lines of the panel

const char* about(Look look) {
    switch (look) {
        case Look::Standard: return tr("A little gloss; quickest to draw.");
        case Look::Phong: return tr("One light and a sharp highlight, as in figures of papers.");
        case Look::Matte: return tr("No gloss at all.");
        case Look::Porcelain: return tr("Whitish, under a clear glaze.");
        case Look::Metal: return tr("Mirrors its surroundings in its own color.");
        case Look::Glass: return tr("Mostly seen through, mirrors where it is seen from aside.");
        case Look::Clay: return tr("Matte and muted, darker in its hollows.");
        case Look::Technical: return tr("Pale, with lines at silhouettes, creases and edges.");
    }
    return "";
}

/// Draws a line of the list of looks: a picture of what is drawn in that look, and its name.
void draw_look_line(Look look, const UiState& state, LightChoice& light) {
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    const ImVec2 size(em(look_picture_em.x), em(look_picture_em.y));
    const char* const name = shown_name(look);
    if (ImGui::Selectable(labelled("##", name).c_str(), look == light.look, 0,
                          ImVec2(0.0F, size.y)))
        light.look = look;
    draw_tooltip(about(look));
    const Palette& colors = palette(state.edited.theme);
    const auto picture = state.shown.look_pictures.find(look);
    draw_thumbnail(picture == state.shown.look_pictures.end() ? 0 : picture->second, lo,
                   ImVec2(lo.x + size.x, lo.y + size.y), colors);
    const float down = 0.5F * (size.y - ImGui::GetTextLineHeight());
    ImGui::GetWindowDrawList()->AddText(ImVec2(lo.x + size.x + em(0.7F), lo.y + down),
                                        ImGui::GetColorU32(ImGuiCol_Text), name);
}

void draw_look(UiState& state) {
    LightChoice& light = state.edited.document.light;
    draw_label(tr("look"), tr("What the surfaces look as if they were made of."));
    if (!ImGui::BeginCombo("##look", shown_name(light.look), ImGuiComboFlags_HeightLargest)) return;
    const float scale = ImGui::GetIO().DisplayFramebufferScale.x;
    state.wishes.look_pictures_px =
        glm::ivec2(glm::round(em(1.0F) * scale * glm::vec2(look_picture_em)));
    for (const Look look : looks())
        draw_look_line(look, state, light);
    ImGui::EndCombo();
}

void draw_mirrors(LightChoice& light) {
    draw_label(tr("mirrors"),
               tr("How often light is mirrored from surface to surface, once the picture rests."));
    draw_integer_slider("##mirrors", light.reflections, 0, max_reflections,
                        light.reflections == 0 ? tr("off") : nullptr);
}

void draw_amount(const char* label, const char* about, double& value, double usual_value, double hi,
                 double most) {
    draw_label(label, about);
    const Slider usual{.value = usual_value, .lo = 0.0, .hi = hi};
    Slider slider = usual;
    set_value(slider, value);
    draw_slider((std::string("##") + label).c_str(), slider, usual, 0.0F);
    value = std::clamp(slider.value, 0.0, most);
}

void draw_tint(LightChoice& light) {
    draw_amount(
        tr("tint"),
        tr("How much solids swallow of what is seen through them, of the colors that they are "
           "not, on a way of length 1. For surfaces that are not opaque."),
        light.absorption, 0.0, 5.0, max_absorption);
}

void draw_tone(LightChoice& light) {
    bool filmic = light.tone == Tone::Filmic;
    if (ImGui::Checkbox(labelled(tr("Filmic"), "###filmic").c_str(), &filmic))
        light.tone = filmic ? Tone::Filmic : Tone::Plain;
    draw_tooltip(tr("Bright light is compressed, so that highlights keep their color."));
    ImGui::SameLine(0.0F, em(1.2F));
    bool own = light.background.has_value();
    if (ImGui::Checkbox(labelled(tr("Background"), "###background").c_str(), &own))
        light.background =
            own ? std::optional(Background{.top = 0xFFFFFF, .bottom = 0xE4E8EC}) : std::nullopt;
    draw_tooltip(tr("Colors behind the surfaces, from top to bottom, in place of the theme's."));
    if (!light.background) return;
    ImGui::SameLine(0.0F, em(0.6F));
    draw_color_field("##top", light.background->top, tr("The background's top"));
    ImGui::SameLine(0.0F, em(0.3F));
    draw_color_field("##bottom", light.background->bottom, tr("The background's bottom"));
}

/// The light's direction as one sees it: to the right, upwards and out of the screen.
glm::dvec3 in_view(const Light& light, const std::optional<Camera>& camera) {
    return light.with_camera || !camera ? light.towards : ViewFrame(*camera).to_view(light.towards);
}

/// Aims the light where one sees it.
void aim(Light& light, const glm::dvec3& seen, const std::optional<Camera>& camera) {
    light.towards = light.with_camera || !camera ? seen : ViewFrame(*camera).from_view(seen);
}

/// Draws the settings of one light; false when the user removes it.
bool draw_light(Light& light, const std::optional<Camera>& camera, const Palette& colors) {
    const float line = ImGui::GetFrameHeightWithSpacing();
    const float size = ball_rows * line - ImGui::GetStyle().ItemSpacing.y;
    glm::dvec3 seen = in_view(light, camera);
    if (draw_light_ball("##ball", seen, size, colors)) aim(light, seen, camera);
    draw_tooltip(tr("Drag to aim the light; a right click takes it to the other side."));
    ImGui::SameLine(0.0F, em(0.8F));
    ImGui::BeginGroup();
    draw_amount(tr("power"), tr("How bright it is."), light.power, Light().power, 2.0, max_power);
    double across = 2.0 * light.radius_deg;
    draw_amount(tr_in("light", "size"),
                tr("How large it is as seen from the surface, in degrees: soft shadows."), across,
                0.0, 45.0, 2.0 * half_sphere_deg);
    light.radius_deg = 0.5 * across;
    std::uint32_t color = color_of_light(light.color);
    if (draw_color_field("##color", color, tr("The light's color")))
        light.color = light_of_color(color);
    ImGui::SameLine(0.0F, em(0.6F));
    if (ImGui::Checkbox(labelled(tr_in("light", "Camera"), "###with").c_str(), &light.with_camera))
        aim(light, seen, camera);
    draw_tooltip(tr("The light turns with the camera; else it stays where it is in the world."));
    const float button = ImGui::GetFrameHeight();
    ImGui::SameLine();
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - button);
    const bool removed = icon_button(
        "##remove", Icon::Cross, {.size = button, .color = colors.quiet}, tr("Remove the light"));
    ImGui::EndGroup();
    return !removed;
}

void draw_lights(UiState& state) {
    Edited& edited = state.edited;
    std::vector<Light>& lights = edited.document.light.lights;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const bool kept = draw_light(lights[i], edited.document.camera, palette(edited.theme));
        ImGui::PopID();
        if (!kept) {
            lights.erase(lights.begin() + static_cast<std::ptrdiff_t>(i));
            break;
        }
    }
    if (lights.size() == max_lights) return;
    if (ImGui::Button(lights.empty() ? tr("Lights of my own") : tr("Add a light"),
                      ImVec2(-FLT_MIN, 0.0F)))
        action_named("Add a light").run(state);
    draw_tooltip(lights.empty() ? tr("Up to four lights, in place of the look's own.")
                                : tr("Up to four lights."));
}

}  // namespace

float light_section_height(const Document& document) {
    const auto lights = static_cast<float>(document.light.lights.size());
    const float add = document.light.lights.size() < max_lights ? 1.0F : 0.0F;
    return (4.0F + add + ball_rows * lights) * ImGui::GetFrameHeightWithSpacing();
}

void draw_light_section(UiState& state) {
    LightChoice& light = state.edited.document.light;
    draw_look(state);
    draw_mirrors(light);
    draw_tint(light);
    draw_tone(light);
    draw_lights(state);
}

}  // namespace zeroset::ui
