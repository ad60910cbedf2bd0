#include "document/import/surf_view.hpp"

#include "engine/base/translation.hpp"
#include "engine/scene/region.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace zeroset {
namespace {

constexpr int clip_ball = 0;
constexpr int clip_cube = 4;

constexpr std::array<std::pair<std::string_view, double>, 24> constants{{
    {"Pi", std::numbers::pi},
    {"parallel", 0},
    {"central", 1},
    {"translate", 0},
    {"rotate", 1},
    {"scale", 2},
    {"ball", clip_ball},
    {"sphere", clip_ball},
    {"cylinder_xaxis", 1},
    {"cylinder_yaxis", 2},
    {"cylinder_zaxis", 3},
    {"cube", clip_cube},
    {"none", 5},
    {"yes", 1},
    {"no", 0},
    {"ambient_light", 1},
    {"diffuse_light", 2},
    {"reflected_light", 4},
    {"transmitted_light", 8},
    {"tetrahedron", 6},
    {"octahedron", 7},
    {"dodecahedron", 8},
    {"icosahedron", 9},
    {"postscript", 0},
}};

constexpr std::array<std::string_view, 22> surf_view_names{
    "origin_x", "origin_y", "origin_z",    "rot_x",      "rot_y",     "rot_z",
    "scale_x",  "scale_y",  "scale_z",     "spec_z",     "first",     "second",
    "third",    "radius",   "clip",        "clip_front", "clip_back", "center_x",
    "center_y", "center_z", "perspective", "scale"};

/// Words that do not change what the picture shows.
constexpr std::array<std::string_view, 12> without_effect{"width",
                                                          "height",
                                                          "filename",
                                                          "root_finder",
                                                          "epsilon",
                                                          "iterations",
                                                          "clear_screen",
                                                          "set_size",
                                                          "antialiasing",
                                                          "antialiasing_threshold",
                                                          "antialiasing_radius",
                                                          "color_file_format"};

/// Numbers that change the picture, and are not taken over.
constexpr std::array<std::string_view, 26> drawn_with{"ambient",
                                                      "diffuse",
                                                      "reflected",
                                                      "transmitted",
                                                      "smoothness",
                                                      "thickness",
                                                      "illumination",
                                                      "depth_cueing",
                                                      "depth_value",
                                                      "depth",
                                                      "stereo_eye",
                                                      "stereo_z",
                                                      "normalize",
                                                      "normalize_factor",
                                                      "normalize_brightness",
                                                      "curve_red",
                                                      "curve_green",
                                                      "curve_blue",
                                                      "curve_width",
                                                      "curve_gamma",
                                                      "dither_colors",
                                                      "dither_steps",
                                                      "optimize_colors",
                                                      "gamma",
                                                      "dither_file_format",
                                                      "surf_nr"};

glm::dvec3 axis_settings(const SurfViewNames::Setting& setting, const std::string& stem,
                         double usual) {
    return {setting(stem + "_x", usual), setting(stem + "_y", usual), setting(stem + "_z", usual)};
}

/// The map that one of the actions makes.
Placement action(int which, const SurfViewNames::Setting& setting) {
    if (which == 0) return Placement::moving(axis_settings(setting, "origin", 0.0));
    if (which == 2) return Placement::scaling(1.0 / axis_settings(setting, "scale", 1.0));
    const glm::dvec3 angles = axis_settings(setting, "rot", 0.0);
    return surf_turning(1, angles.y)
        .then(surf_turning(0, angles.x))
        .then(surf_turning(2, angles.z));
}

/// The half-space dot(normal, p) <= offset of the view, in the document's coordinates.
Section section_in(const Placement& from_view, const glm::dvec3& normal, double offset) {
    const glm::dvec3 turned = glm::normalize(from_view.linear * normal);
    return make_section(turned, glm::dot(turned, from_view.of(offset * normal)), false);
}

}  // namespace

std::optional<double> surf_constant(std::string_view name) {
    const auto* const found =
        std::ranges::find(constants, name, [](const auto& c) { return c.first; });
    if (found == constants.end()) return std::nullopt;
    return found->second;
}

bool surf_only_sets(std::string_view command) {
    return std::ranges::find(without_effect, command) != without_effect.end();
}

bool surf_draws_with(std::string_view number) {
    while (!number.empty() && number.back() >= '0' && number.back() <= '9')
        number.remove_suffix(1);
    return std::ranges::find(drawn_with, number) != drawn_with.end();
}

Placement surf_turning(int axis, double angle_rad) {
    return Placement::turning(axis, axis == 1 ? -angle_rad : angle_rad);
}

bool SurfViewNames::knows(std::string_view name) const {
    return std::ranges::find(surf_view_names, name) != surf_view_names.end();
}

SurfView SurfViewNames::of(const Setting& setting) const {
    SurfView view;
    for (const auto& [name, usual] : {std::pair("first", 0), {"second", 1}, {"third", 2}})
        view.to_view = view.to_view.then(
            action(static_cast<int>(std::clamp(setting(name, usual), -1.0, 3.0)), setting));
    const auto back = view.to_view.inverse();
    if (!back || !back->scale()) view.substituted = back.value_or(Placement{});
    view.radius = std::max(1e-6, std::abs(setting("radius", 10.0)));
    view.centre = axis_settings(setting, "center", 0.0);
    view.clip_front = setting("clip_front", 10.0);
    view.clip_back = setting("clip_back", -10.0);
    view.clip = static_cast<int>(std::clamp(setting("clip", 0.0), 0.0, 99.0));
    const double width = setting("width", 200.0);
    const double height = setting("height", 200.0);
    if (width > 0.0 && height > 0.0) view.half_height = 10.0 * height / std::min(width, height);
    if (setting("perspective", 0.0) == 1.0)
        view.distance = std::max(1e-3, setting("spec_z", 100.0));
    return view;
}

void apply(const SurfView& view, ImportedDocument& drawn,
           const std::map<std::string, std::size_t>& lines) {
    const auto line = [&lines](const char* name) {
        const auto found = lines.find(name);
        return found == lines.end() ? std::size_t{0} : found->second;
    };
    const auto back = view.to_view.inverse();
    if (!back) drawn.note(line("scale_x"), "scale", tr("a scale of 0; the surface is not moved"));
    const Placement from_view = view.substituted || !back ? Placement{} : *back;
    const double factor = from_view.scale().value_or(1.0);
    const glm::dvec3 centre = from_view.of(view.centre);
    const bool cube = view.clip == clip_cube;
    double reach = factor * view.radius;
    Document& document = drawn.document;
    if (view.clip == clip_ball) {
        document.region.ball = Ball{.centre = centre, .radius = reach};
    } else if (!cube) {
        drawn.note(line("clip"), "clip", tr("a cube of this radius is shown"));
    }
    std::vector<Section>& sections = document.region.sections;
    for (int axis = 0; axis < 3 && view.clip != clip_ball; ++axis) {
        glm::dvec3 normal(0.0);
        normal[axis] = 1.0;
        sections.push_back(section_in(from_view, normal, view.centre[axis] + view.radius));
        sections.push_back(section_in(from_view, -normal, view.radius - view.centre[axis]));
    }
    const glm::dvec3 forward(0.0, 0.0, 1.0);
    if (view.clip_front < view.centre.z + view.radius && sections.size() < max_sections)
        sections.push_back(section_in(from_view, forward, view.clip_front));
    if (view.clip_back > view.centre.z - view.radius && sections.size() < max_sections)
        sections.push_back(section_in(from_view, -forward, -view.clip_back));
    if (view.clip != clip_ball) reach *= std::sqrt(3.0);
    document.clip = {.lo = centre - reach, .hi = centre + reach};
    document.up = glm::dvec3(0.0, 1.0, 0.0);
    const Camera camera = camera_of_view(from_view, view.half_height, view.distance);
    if (camera_defect(camera) == nullptr) {
        document.camera = document.home = camera;
        document.up = camera.up;
    }
}

}  // namespace zeroset
