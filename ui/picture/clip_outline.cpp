#include "ui/picture/clip_outline.hpp"

#include "document/look.hpp"
#include "engine/base/translation.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace zeroset::ui {
namespace {

std::vector<glm::dvec3> face_outline(const Box& box, std::size_t face) {
    const int axis = static_cast<int>(face / 2);
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    std::vector<glm::dvec3> corners(4, face % 2 == 1 ? box.hi : box.lo);
    for (std::size_t i = 0; i < 4; ++i) {
        corners[i][u] = i == 1 || i == 2 ? box.hi[u] : box.lo[u];
        corners[i][v] = i >= 2 ? box.hi[v] : box.lo[v];
    }
    return corners;
}

std::vector<glm::dvec3> ball_outline(const Ball& ball, const ViewFrame& view) {
    constexpr int corners = 96;
    std::vector<glm::dvec3> rim;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        rim.push_back(ball.centre +
                      ball.radius * (std::cos(angle) * view.right + std::sin(angle) * view.up));
    }
    return rim;
}

glm::dvec3 corner_of(const Box& box, unsigned bits) {
    return {(bits & 1U) != 0 ? box.hi.x : box.lo.x, (bits & 2U) != 0 ? box.hi.y : box.lo.y,
            (bits & 4U) != 0 ? box.hi.z : box.lo.z};
}

/// Where the plane crosses the box's edges, in order around; empty where it passes the box.
std::vector<glm::dvec3> section_outline(const Section& section, const Box& box) {
    std::vector<glm::dvec3> crossings;
    for (unsigned edge = 0; edge < 24; ++edge) {
        const unsigned corner = edge % 8;
        const unsigned axis = 1U << edge / 8;
        if ((corner & axis) != 0) continue;
        const glm::dvec3 from = corner_of(box, corner);
        const glm::dvec3 to = corner_of(box, corner | axis);
        const double before = glm::dot(section.normal, from) - section.offset;
        const double after = glm::dot(section.normal, to) - section.offset;
        if ((before <= 0) == (after <= 0)) continue;
        crossings.push_back(glm::mix(from, to, before / (before - after)));
    }
    if (crossings.empty()) return crossings;
    glm::dvec3 middle(0.0);
    for (const glm::dvec3& point : crossings)
        middle += point / static_cast<double>(crossings.size());
    const glm::dvec3 u = glm::normalize(crossings[0] - middle);
    const glm::dvec3 v = glm::cross(section.normal, u);
    std::ranges::sort(crossings, {}, [&](const glm::dvec3& point) {
        return std::atan2(glm::dot(point - middle, v), glm::dot(point - middle, u));
    });
    return crossings;
}

std::string section_text(const Section& section, double resolution) {
    for (int axis = 0; axis < 3; ++axis) {
        const double side = section.normal[axis];
        if (std::abs(side) != 1.0) continue;
        return std::string(1, static_cast<char>('x' + axis)) + (side > 0 ? " < " : " > ") +
               number_text(side * section.offset, resolution);
    }
    return filled(tr("distance {0}"), {localized(number_text(section.offset, resolution))});
}

}  // namespace

std::vector<glm::dvec3> outline_of(const HandleId& id, const Clipping& clipping,
                                   const ViewFrame& view) {
    switch (id.part) {
        case HandlePart::BoxFace: return face_outline(clipping.clip, id.index);
        case HandlePart::BallCentre:
        case HandlePart::BallRadius: return ball_outline(*clipping.region.ball, view);
        case HandlePart::SectionPlace:
        case HandlePart::SectionTilt:
            return section_outline(clipping.region.sections[id.index], clipping.clip);
    }
    return {};
}

std::string handle_text(const Handle& handle, const Clipping& clipping, const ViewFrame& view,
                        int height_px) {
    const double drawn =
        handle.along == glm::dvec3(0.0) ? 1.0 : glm::length(view.stretch * handle.along);
    const double pixel = 2.0 * view.homogeneous(handle.at).z / height_px / drawn;
    const Region& region = clipping.region;
    switch (handle.id.part) {
        case HandlePart::BoxFace: {
            const int axis = static_cast<int>(handle.id.index / 2);
            return std::string(1, static_cast<char>('x' + axis)) + " = " +
                   number_text(handle.at[axis], pixel);
        }
        case HandlePart::BallCentre: return coordinates_text(region.ball->centre, pixel);
        case HandlePart::BallRadius:
            return filled(tr("radius {0}"), {number_text(region.ball->radius, pixel)});
        case HandlePart::SectionPlace: return section_text(region.sections[handle.id.index], pixel);
        case HandlePart::SectionTilt:
            return filled(tr("normal {0}"),
                          {coordinates_text(region.sections[handle.id.index].normal, 1e-3)});
    }
    return {};
}

}  // namespace zeroset::ui
