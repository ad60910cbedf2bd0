#include "engine/trace/field_gradients.hpp"

#include "engine/kernel/point_batch.hpp"
#include "engine/trace/tile_costs.hpp"

#include <glm/glm.hpp>

#include <cstddef>

namespace zeroset {

bool FieldGradients::put(std::uint32_t pixel, const std::array<double, 3>& position,
                         const glm::dvec3& of_field) {
    if (sign_ == 0) find_sign(pixel, position, of_field);
    if (sign_ == 0 || of_field == glm::dvec3(0.0)) return false;
    const auto rounded =
        float_gradient({sign_ * of_field.x, sign_ * of_field.y, sign_ * of_field.z});
    for (std::size_t c = 0; c < 3; ++c)
        hits_.gradient[c][pixel] = rounded[c];
    return true;
}

void FieldGradients::find_sign(std::uint32_t pixel, const std::array<double, 3>& position,
                               const glm::dvec3& of_field) {
    PointBatch<double> point(1);
    point.set(0, position[0], position[1], position[2]);
    point.pad();
    ++counters_.value;
    if (counters_.costs != nullptr) counters_.costs->add(pixel);
    frame_.kernel.in_double.value(point.batch(frame_.scene.uniforms.points<double>()));
    const glm::dvec3 of_f(point.gradient(0, 0), point.gradient(1, 0), point.gradient(2, 0));
    const double along = glm::dot(of_f, of_field);
    sign_ = along > 0 ? 1 : along < 0 ? -1 : 0;
}

}  // namespace zeroset
