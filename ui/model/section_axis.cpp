#include "ui/model/section_axis.hpp"

#include "document/framing.hpp"

#include <cmath>

namespace zeroset::ui {

int axis_of(const Section& section) {
    for (int i = 0; i < 3; ++i) {
        if (std::abs(section.normal[i]) == 1.0) return i;
    }
    return free_axis;
}

Section section_across(int axis, const Document& document) {
    const Camera camera = camera_of(document);
    const glm::dvec3 to_eye = camera.eye - camera.look_at;
    // Across the view in the drawn world, where the point p is at stretch * p.
    if (axis == free_axis)
        return make_section(camera.stretch * to_eye, glm::dot(to_eye, camera.look_at));
    glm::dvec3 normal(0.0);
    normal[axis] = to_eye[axis] < 0 ? -1.0 : 1.0;
    return make_section(normal, glm::dot(normal, document.clip.centre()));
}

void add_section(Document& document) {
    std::vector<Section>& sections = document.region.sections;
    sections.push_back(section_across(static_cast<int>(sections.size() % 3), document));
}

}  // namespace zeroset::ui
