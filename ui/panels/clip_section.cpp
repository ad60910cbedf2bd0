#include "ui/panels/clip_section.hpp"

#include "document/document.hpp"
#include "engine/scene/region.hpp"
#include "engine/view/camera.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/slider_row.hpp"

#include <glm/ext/vector_double3.hpp>
#include <imgui/imgui.h>

#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

namespace zeroset::ui {
namespace {

constexpr double min_half = 1e-14;
constexpr double max_half = 1e6;
constexpr int free_axis = 3;
constexpr std::array<const char*, 4> axis_names{"x", "y", "z", "free"};
constexpr const char* about_free = "free: at first across the view, through the point looked at.";

/// Draws input fields for numbers side by side on the rest of the line; true when a finite one was
/// typed.
template <std::size_t count>
bool draw_numbers(const char* id, const std::array<double*, count>& numbers) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x;
    const float width = (room - gap * static_cast<float>(count - 1)) / static_cast<float>(count);
    bool typed = false;
    ImGui::PushID(id);
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) ImGui::SameLine(0.0F, gap);
        ImGui::SetNextItemWidth(i + 1 == count ? -FLT_MIN : width);
        ImGui::PushID(static_cast<int>(i));
        double number = *numbers[i];
        if (ImGui::InputDouble("##number", &number, 0.0, 0.0, "%.6g") &&
            std::abs(number) <= largest_number && number != *numbers[i]) {
            *numbers[i] = number;
            typed = true;
        }
        ImGui::PopID();
    }
    ImGui::PopID();
    return typed;
}

void draw_edges(Box& clip) {
    for (int i = 0; i < 3; ++i) {
        draw_label(axis_names.at(static_cast<std::size_t>(i)), "The box from here to there.");
        Box typed = clip;
        if (draw_numbers(axis_names.at(static_cast<std::size_t>(i)),
                         std::array{&typed.lo[i], &typed.hi[i]}) &&
            typed.lo[i] < typed.hi[i]) {
            clip = typed;
        }
    }
}

void draw_box(Edited& edited) {
    Box& clip = edited.document.clip;
    draw_label("box \xC2\xB1", "Half the longest edge of the box that the surface is clipped to.");
    const float button = ImGui::GetFrameHeight();
    ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemInnerSpacing.x);
    double half = 0.5 * clip.size();
    if (ImGui::InputDouble("##box", &half, 0.0, 0.0, "%.6g") && half >= min_half &&
        half <= max_half) {
        clip = resized(clip, half);
    }
    ImGui::SameLine(0.0F, ImGui::GetStyle().ItemInnerSpacing.x);
    bool& open = edited.layout.edges_open;
    if (icon_button("##edges", Icon::More, {.size = button, .color = palette(edited.theme).quiet},
                    open ? "Only one number" : "Each edge by itself")) {
        open = !open;
    }
    if (open) draw_edges(clip);
}

void draw_ball(Edited& edited) {
    std::optional<Ball>& ball = edited.document.region.ball;
    bool on = ball.has_value();
    const Box& clip = edited.document.clip;
    if (ImGui::Checkbox("Sphere", &on)) {
        ball = on ? std::optional(Ball{.centre = clip.centre(), .radius = 0.5 * clip.size()})
                  : std::nullopt;
    }
    draw_tooltip("Shows only what is in a sphere.");
    ImGui::SameLine(0.0F, em(1.2F));
    ImGui::Checkbox("Handles", &edited.layout.handles);
    draw_tooltip("Handles in the picture that move the box, the sphere and the sections (H).");
    if (!ball) return;
    draw_label("radius", "The sphere's radius.");
    Ball typed = *ball;
    if (draw_numbers("radius", std::array{&typed.radius}) && typed.radius > 0) ball = typed;
    draw_label("centre", "The sphere's centre: x, y, z.");
    glm::dvec3& centre = ball->centre;
    draw_numbers("centre", std::array{&centre.x, &centre.y, &centre.z});
}

void draw_axis(const Document& document, Section& section) {
    const int axis = axis_of(section);
    ImGui::SetNextItemWidth(em(3.4F));
    if (ImGui::BeginCombo("##axis", axis_names.at(static_cast<std::size_t>(axis)),
                          ImGuiComboFlags_NoArrowButton)) {
        for (int other = 0; other <= free_axis; ++other) {
            if (!ImGui::Selectable(axis_names.at(static_cast<std::size_t>(other)), other == axis))
                continue;
            const bool cap = section.cap;
            section = section_across(other, document);
            section.cap = cap;
        }
        ImGui::EndCombo();
    }
    draw_tooltip(std::string("The direction that the section is across.\n") + about_free);
}

/// Slider of the section's offset along its axis or normal.
void draw_place(const Box& clip, Section& section) {
    const int axis = axis_of(section);
    const double sign = axis == free_axis ? 1.0 : section.normal[axis];
    const glm::dvec3 across = glm::abs(section.normal);
    const double middle = sign * glm::dot(section.normal, clip.centre());
    const double reach = 0.5 * glm::dot(across, clip.hi - clip.lo);
    const Slider usual{.value = middle, .lo = middle - reach, .hi = middle + reach};
    Slider slider = usual;
    set_value(slider, sign * section.offset);
    draw_slider("##place", slider, usual, 0.0F);
    section.offset = sign * slider.value;
}

/// Draws the settings of one section; false when the user removes it.
bool draw_section(Edited& edited, Section& section) {
    draw_axis(edited.document, section);
    ImGui::SameLine(0.0F, ImGui::GetStyle().ItemInnerSpacing.x);
    draw_place(edited.document.clip, section);
    if (axis_of(section) == free_axis) {
        draw_label("normal",
                   "The section is across this direction and takes away what lies there.");
        glm::dvec3 normal = section.normal;
        if (draw_numbers("normal", std::array{&normal.x, &normal.y, &normal.z}) &&
            glm::length(normal) > 0) {
            section.normal = glm::normalize(normal);
        }
    }
    const float size = ImGui::GetFrameHeight();
    if (ImGui::Button("Flip"))
        section = {.normal = -section.normal, .offset = -section.offset, .cap = section.cap};
    draw_tooltip("Keeps the other side.");
    ImGui::SameLine();
    ImGui::Checkbox("cap", &section.cap);
    draw_tooltip("Fills the solids that the section cuts open.");
    ImGui::SameLine(ImGui::GetContentRegionMax().x - size);
    return !icon_button("##remove", Icon::Cross,
                        {.size = size, .color = palette(edited.theme).quiet}, "Remove");
}

void draw_sections(Edited& edited) {
    std::vector<Section>& sections = edited.document.region.sections;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const bool keeps = draw_section(edited, sections[i]);
        ImGui::PopID();
        if (keeps) continue;
        sections.erase(sections.begin() + static_cast<std::ptrdiff_t>(i));
        break;
    }
    if (sections.size() == max_sections) return;
    if (ImGui::Button("Add a section", ImVec2(-FLT_MIN, 0.0F))) {
        sections.push_back(section_across(static_cast<int>(sections.size() % 3), edited.document));
    }
    draw_tooltip("Cuts by a plane and shows what is inside.");
}

}  // namespace

Box resized(const Box& box, double half) { return scaled(box, 2.0 * half / box.size()); }

int axis_of(const Section& section) {
    for (int i = 0; i < 3; ++i) {
        if (std::abs(section.normal[i]) == 1.0) return i;
    }
    return free_axis;
}

Section section_across(int axis, const Document& document) {
    const Camera camera = document.camera.value_or(default_camera(document.clip));
    const glm::dvec3 to_eye = camera.eye - camera.look_at;
    if (axis == free_axis) return make_section(to_eye, glm::dot(to_eye, camera.look_at));
    glm::dvec3 normal(0.0);
    normal[axis] = to_eye[axis] < 0 ? -1.0 : 1.0;
    return make_section(normal, glm::dot(normal, document.clip.centre()));
}

float clip_section_height(const Edited& edited) {
    const Region& region = edited.document.region;
    float rows = 2.0F + (edited.layout.edges_open ? 3.0F : 0.0F) + (region.ball ? 2.0F : 0.0F);
    for (const Section& section : region.sections)
        rows += axis_of(section) == free_axis ? 3.0F : 2.0F;
    if (region.sections.size() < max_sections) rows += 1.0F;
    return rows * ImGui::GetFrameHeightWithSpacing();
}

void draw_clip_section(Edited& edited) {
    draw_box(edited);
    draw_ball(edited);
    draw_sections(edited);
}

}  // namespace zeroset::ui
