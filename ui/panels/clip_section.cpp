#include "document/document.hpp"
#include "document/framing.hpp"
#include "engine/base/translation.hpp"
#include "engine/scene/region.hpp"
#include "engine/view/camera.hpp"
#include "ui/model/section_axis.hpp"
#include "ui/panels/sections.hpp"
#include "ui/panels/setting_rows.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/number_field.hpp"
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
constexpr std::array<const char*, 4> axis_names{"x", "y", "z", marked("free")};
const char* axis_name(int axis) { return tr(axis_names.at(static_cast<std::size_t>(axis))); }

/// The changes made to fields of numbers.
struct Typed {
    bool changed = false;
    bool finished = false;  ///< the keyboard has left a field that was changed
};

/// Draws input fields for numbers side by side on the rest of the line.
template <std::size_t count>
Typed draw_numbers(const char* id, const std::array<double*, count>& numbers) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float space = ImGui::GetContentRegionAvail().x;
    const float width = (space - gap * static_cast<float>(count - 1)) / static_cast<float>(count);
    Typed typed;
    ImGui::PushID(id);
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) ImGui::SameLine(0.0F, gap);
        ImGui::SetNextItemWidth(i + 1 == count ? -FLT_MIN : width);
        ImGui::PushID(static_cast<int>(i));
        if (draw_number_field("##number", *numbers[i], -largest_number, largest_number))
            typed.changed = true;
        typed.finished = typed.finished || ImGui::IsItemDeactivatedAfterEdit();
        ImGui::PopID();
    }
    ImGui::PopID();
    return typed;
}

/// True for a cube about the origin: one number tells all of it.
bool is_plain(const Box& box) { return box == Box::cube(0.5 * box.size()); }

bool shows_edges(const Edited& edited) {
    return edited.layout.edges_open || !is_plain(edited.document.clip);
}

void draw_edges(Box& clip, Wishes& wishes) {
    for (int i = 0; i < 3; ++i) {
        draw_label(axis_name(i), tr("The box from here to there."));
        Box wished = clip;
        const Typed typed = draw_numbers(axis_name(i), std::array{&wished.lo[i], &wished.hi[i]});
        if (typed.changed && wished.lo[i] < wished.hi[i]) clip = wished;
        wishes.frame_box = wishes.frame_box || typed.finished;
    }
}

bool shows_aspect(const Edited& edited) {
    return shows_edges(edited) && !edited.document.region.ball;
}

/// How long a unit is drawn along each axis, and a button for what the box suggests.
void draw_aspect(Document& document) {
    draw_label(tr("scale"), tr("How long one unit is drawn along x, y and z."));
    glm::dvec3 aspect = stretch_of(document);
    const bool automatic = !document.aspect;
    if (draw_numbers("aspect", std::array{&aspect.x, &aspect.y, &aspect.z}).changed &&
        glm::all(glm::greaterThan(aspect, glm::dvec3(0.0))))
        document.aspect = aspect;
    if (automatic) return;
    if (ImGui::Button(tr("Automatic scale"), ImVec2(-FLT_MIN, 0.0F))) document.aspect.reset();
    draw_tooltip(tr("All axes alike, unless an edge of the box is ten times another."));
}

void draw_box(Edited& edited, Wishes& wishes) {
    Box& clip = edited.document.clip;
    const bool plain = is_plain(clip);
    draw_label(plain ? tr("box \xC2\xB1") : tr("half"),
               plain ? tr("Half the edge of the box that the surface is clipped to.")
                     : tr("Half the longest edge of the box that the surface is clipped to; below "
                          "is where it lies."));
    const float button = ImGui::GetFrameHeight();
    ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemInnerSpacing.x);
    double half = 0.5 * clip.size();
    if (draw_number_field("##box", half, min_half, max_half)) clip = resized(clip, half);
    wishes.frame_box = wishes.frame_box || ImGui::IsItemDeactivatedAfterEdit();
    ImGui::SameLine(0.0F, ImGui::GetStyle().ItemInnerSpacing.x);
    bool& open = edited.layout.edges_open;
    const IconLook look{.size = button, .color = palette(edited.theme).quiet, .enabled = plain};
    if (icon_button("##edges", Icon::More, look,
                    !plain ? tr("Each edge by itself: the box is no cube about 0")
                    : open ? tr("Only one number")
                           : tr("Each edge by itself"))) {
        open = !open;
    }
    if (shows_edges(edited)) draw_edges(clip, wishes);
    if (shows_aspect(edited)) draw_aspect(edited.document);
}

void draw_ball(Edited& edited) {
    std::optional<Ball>& ball = edited.document.region.ball;
    bool on = ball.has_value();
    const Box& clip = edited.document.clip;
    if (ImGui::Checkbox(tr("Sphere"), &on)) {
        ball = on ? std::optional(Ball{.centre = clip.centre(), .radius = 0.5 * clip.size()})
                  : std::nullopt;
    }
    draw_tooltip(tr("Shows only what is in a sphere."));
    ImGui::SameLine(0.0F, em(1.2F));
    ImGui::Checkbox(tr("Handles"), &edited.layout.handles);
    draw_tooltip(tr("Handles in the picture that move the box, the sphere and the sections (H)."));
    if (!ball) return;
    draw_label(tr("radius"), tr("The sphere's radius."));
    Ball typed = *ball;
    if (draw_numbers("radius", std::array{&typed.radius}).changed && typed.radius > 0) ball = typed;
    draw_label(tr("centre"), tr("The sphere's centre: x, y, z."));
    glm::dvec3& centre = ball->centre;
    draw_numbers("centre", std::array{&centre.x, &centre.y, &centre.z});
}

void draw_axis(const Document& document, Section& section) {
    const int axis = axis_of(section);
    ImGui::SetNextItemWidth(em(3.4F));
    if (ImGui::BeginCombo("##axis", axis_name(axis), ImGuiComboFlags_NoArrowButton)) {
        for (int other = 0; other <= free_axis; ++other) {
            if (!ImGui::Selectable(axis_name(other), other == axis)) continue;
            const Section across = section_across(other, document);
            section.normal = across.normal;
            section.offset = across.offset;
        }
        ImGui::EndCombo();
    }
    draw_tooltip(
        tr("The direction that the section is across.\nfree: at first across the view, "
           "through the point looked at."));
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
        draw_label(
            tr_in("section", "normal"),
            tr("The section is across this direction, and cuts away the side to which it points."));
        glm::dvec3 normal = section.normal;
        if (draw_numbers("normal", std::array{&normal.x, &normal.y, &normal.z}).changed &&
            glm::length(normal) > 0) {
            section.normal = glm::normalize(normal);
        }
    }
    const float size = ImGui::GetFrameHeight();
    if (ImGui::Button(tr("Flip"))) {
        section.normal = -section.normal;
        section.offset = -section.offset;
    }
    draw_tooltip(tr("Keeps the other side."));
    ImGui::SameLine();
    ImGui::Checkbox(tr("cap"), &section.cap);
    draw_tooltip(tr("Fills the solids that the section cuts open."));
    ImGui::SameLine();
    ImGui::Checkbox(labelled(tr("values"), "###values").c_str(), &section.values);
    draw_tooltip(
        tr("Shows the numbers behind the surface on the section, such as those of a scan: in caps, "
           "or without caps wherever they are defined."));
    ImGui::SameLine(ImGui::GetContentRegionMax().x - size);
    return !icon_button("##remove", Icon::Cross,
                        {.size = size, .color = palette(edited.theme).quiet}, tr("Remove"));
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
    if (ImGui::Button(tr("Add a section"), ImVec2(-FLT_MIN, 0.0F))) {
        add_section(edited.document);
    }
    draw_tooltip(tr("Cuts the surfaces by a plane, to look inside."));
}

}  // namespace

Box resized(const Box& box, double half) { return scaled(box, 2.0 * half / box.size()); }

float clip_section_height(const Edited& edited) {
    const Region& region = edited.document.region;
    float rows = 2.0F + (shows_edges(edited) ? 3.0F : 0.0F) + (region.ball ? 2.0F : 0.0F);
    if (shows_aspect(edited)) rows += edited.document.aspect ? 2.0F : 1.0F;
    for (const Section& section : region.sections)
        rows += axis_of(section) == free_axis ? 3.0F : 2.0F;
    if (region.sections.size() < max_sections) rows += 1.0F;
    rows += section_values_rows(edited.document);
    return rows * ImGui::GetFrameHeightWithSpacing();
}

void draw_clip_section(Edited& edited, const Shown& shown, Wishes& wishes) {
    draw_box(edited, wishes);
    draw_ball(edited);
    draw_sections(edited);
    draw_section_values(edited.document, shown.picture);
}

}  // namespace zeroset::ui
