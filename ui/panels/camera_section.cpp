#include "document/camera_text.hpp"
#include "document/document.hpp"
#include "document/views.hpp"
#include "engine/base/translation.hpp"
#include "engine/view/camera.hpp"
#include "engine/view/navigation.hpp"
#include "ui/actions/actions.hpp"
#include "ui/actions/view_moves.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/panels/sections.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/card_grid.hpp"
#include "ui/widgets/number_field.hpp"
#include "ui/widgets/slider_row.hpp"

#include <glm/glm.hpp>
#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr glm::vec2 picture_em(4.4F, 3.3F);
constexpr float most_cards = 3.5F;  ///< in sight before the list of them scrolls
constexpr float card_gap_em = 0.3F;

float card_height() { return std::ceil(em(picture_em.y + card_gap_em)); }

/// Height of the list of saved views.
float view_list_height(const Document& document) {
    const auto cards = static_cast<float>(document.views.size());
    return cards == 0.0F ? 2.0F * ImGui::GetTextLineHeightWithSpacing()
                         : std::min(cards, most_cards) * card_height();
}

void draw_button(UiState& state, const char* label, const char* name, float width) {
    const Action& action = action_named(name);
    ImGui::BeginDisabled(!is_enabled(action, state));
    if (ImGui::Button((std::string(label) + "###" + name).c_str(), ImVec2(width, 0.0F)))
        action.run(state);
    ImGui::EndDisabled();
    draw_tooltip(described(action) + (*tr(action.about) == '\0' ? "" : "\n") + tr(action.about));
}

void draw_view_buttons(UiState& state) {
    constexpr std::array<std::pair<const char*, const char*>, 3> buttons{
        {{marked("Save view"), "Save view"},
         {marked("Copy"), "Copy the camera"},
         {marked("Paste"), "Paste the camera"}}};
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - 2.0F * gap) / 3.0F;
    for (const auto& [label, name] : buttons) {
        if (label != buttons.front().first) ImGui::SameLine(0.0F, gap);
        draw_button(state, tr(label), name, width);
    }
}

/// Draws a view's picture; a click looks from there.
void draw_picture(UiState& state, const SavedView& view, ViewPictureWish& wish) {
    const ImVec2 size(std::round(em(picture_em.x)), std::round(em(picture_em.y)));
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    const ImVec2 hi(lo.x + size.x, lo.y + size.y);
    if (ImGui::InvisibleButton("##picture", size)) move_view(state, view.camera);
    const Palette& colors = palette(state.edited.theme);
    const bool hovered = ImGui::IsItemHovered();
    const bool is_there = state.edited.document.camera == view.camera;
    draw_tooltip(tr("Look from there"));
    if (!ImGui::IsRectVisible(lo, hi)) return;
    wish.cameras.push_back(view.camera);
    const auto& pictures = state.shown.view_pictures;
    const auto picture = std::ranges::find(pictures, view.camera, &ViewPicture::camera);
    draw_thumbnail(picture == pictures.end() ? 0 : picture->texture, lo, hi, colors);
    if (hovered || is_there)
        ImGui::GetWindowDrawList()->AddRect(lo, hi, hovered ? colors.text : colors.accent, 0.0F, 0,
                                            std::max(em(0.12F), 1.0F));
}

/// The wishes that the icons on the card of a saved view stand for.
enum class CardWish : std::uint8_t { Nothing, MoveUp, Remove };

CardWish draw_card(UiState& state, std::size_t index, ViewPictureWish& wish) {
    std::vector<SavedView>& views = state.edited.document.views;
    const float button = ImGui::GetFrameHeight();
    const float top = ImGui::GetCursorPosY();
    draw_picture(state, views[index], wish);
    ImGui::SameLine(0.0F, em(0.6F));
    const float middle = top + 0.5F * (std::round(em(picture_em.y)) - button);
    // In a group, so that the icons' line is not as high as the picture.
    ImGui::BeginGroup();
    ImGui::SetCursorPosY(middle);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 2.0F * button);
    std::string name = views[index].name;
    // While it is typed into, ImGui keeps the text as typed and only tells of it.
    if (ImGui::InputText("##name", &name, ImGuiInputTextFlags_AutoSelectAll))
        rename_view(views, index, name);
    draw_tooltip(tr("Its name: for films, Ctrl+K and --view. Click to change it."));
    const IconLook look{.size = button, .color = palette(state.edited.theme).quiet};
    ImGui::SameLine(0.0F, 0.0F);
    CardWish wished = CardWish::Nothing;
    if (icon_button("##up", Icon::Up,
                    {.size = look.size, .color = look.color, .enabled = index > 0},
                    tr("Move it up: films go through the views in this order")))
        wished = CardWish::MoveUp;
    ImGui::SameLine(0.0F, 0.0F);
    if (icon_button("##remove", Icon::Cross, look, tr("Delete the view")))
        wished = CardWish::Remove;
    ImGui::EndGroup();
    ImGui::SetCursorPosY(top + card_height());
    return wished;
}

void draw_cards(UiState& state) {
    std::vector<SavedView>& views = state.edited.document.views;
    if (views.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette(state.edited.theme).quiet);
        ImGui::TextWrapped("%s", tr("Save view (V) keeps where you look from under a name."));
        ImGui::PopStyleColor();
        return;
    }
    const float scale = ImGui::GetIO().DisplayFramebufferScale.x;
    ViewPictureWish wish{.cameras = {},
                         .size_px = glm::ivec2(glm::round(em(1.0F) * scale * picture_em))};
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
    CardWish wished = CardWish::Nothing;
    std::size_t of = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const CardWish asked = draw_card(state, i, wish);
        ImGui::PopID();
        if (asked == CardWish::Nothing) continue;
        wished = asked;
        of = i;
    }
    ImGui::PopStyleVar();
    if (!wish.cameras.empty()) state.wishes.view_pictures = std::move(wish);
    if (wished == CardWish::MoveUp) std::swap(views[of], views[of - 1]);
    if (wished == CardWish::Remove) views.erase(views.begin() + static_cast<std::ptrdiff_t>(of));
}

/// Draws a point or a direction; true when a number was typed.
bool draw_vector(const char* label, const char* about, glm::dvec3& vector) {
    draw_label(label, about);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - 2.0F * gap) / 3.0F;
    bool typed = false;
    ImGui::PushID(label);
    for (int axis = 0; axis < 3; ++axis) {
        constexpr std::array<const char*, 3> ids{"##x", "##y", "##z"};
        if (axis > 0) ImGui::SameLine(0.0F, gap);
        ImGui::SetNextItemWidth(axis < 2 ? width : -FLT_MIN);
        typed = draw_number_field(ids.at(static_cast<std::size_t>(axis)), vector[axis],
                                  -largest_number, largest_number) ||
                typed;
    }
    ImGui::PopID();
    return typed;
}

/// Draws the angle, or of parallel rays the height that they show; true when one was typed.
bool draw_opening(Camera& camera) {
    if (camera.projection == Projection::Perspective) {
        draw_label(tr("angle"), tr("Field of view: degrees from the picture's top to its bottom."));
        double degrees = glm::degrees(camera.fov_rad);
        if (!draw_number_field("##fov", degrees, least_fov_deg, most_fov_deg)) return false;
        camera.fov_rad = glm::radians(degrees);
        return true;
    }
    draw_label(tr("height"), tr("The height of what parallel rays show, in world units."));
    double height = shown_height(camera);
    if (!draw_number_field("##height", height, 1e-12, largest_number)) return false;
    camera = with_shown_height(camera, height);
    return true;
}

/// Draws the camera's numbers; what is typed counts at once, unless such a camera sees nothing.
void draw_numbers(UiState& state) {
    std::optional<Camera>& camera = state.edited.document.camera;
    if (!camera) return;
    Camera typed = *camera;
    const bool eye = draw_vector(tr("eye"), tr("Where one looks from."), typed.eye);
    const bool target = draw_vector(
        tr("target"), tr("What one looks at, in the middle of the picture."), typed.look_at);
    const bool up = draw_vector(tr("up"), tr("The direction that is up in the picture."), typed.up);
    // Parallel rays go on to show as much.
    if ((eye || target) && typed.projection == Projection::Orthographic &&
        typed.eye != typed.look_at)
        typed = with_shown_height(typed, shown_height(*camera));
    const bool opening = draw_opening(typed);
    if (!eye && !target && !up && !opening) return;
    const char* const defect = camera_defect(typed);
    state.input.camera_error = defect == nullptr ? "" : defect;
    if (defect == nullptr) camera = typed;
}

void draw_error(UiState& state) {
    std::string& error = state.input.camera_error;
    if (error.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, palette(state.edited.theme).error);
    if (draw_elided(error, ImGui::GetContentRegionAvail().x)) draw_tooltip(error);
    ImGui::PopStyleColor();
    if (!ImGui::IsAnyItemActive()) error.clear();
}

}  // namespace

float camera_section_height(const UiState& state) {
    const float rows = state.input.camera_error.empty() ? 5.0F : 6.0F;
    return view_list_height(state.edited.document) + ImGui::GetStyle().ItemSpacing.y +
           rows * ImGui::GetFrameHeightWithSpacing();
}

void draw_camera_section(UiState& state) {
    draw_view_buttons(state);
    ImGui::BeginChild("##views", ImVec2(0.0F, view_list_height(state.edited.document)));
    draw_cards(state);
    ImGui::EndChild();
    draw_numbers(state);
    draw_error(state);
}

}  // namespace zeroset::ui
