#include "tests/support/exact_ray.hpp"

#include <cmath>
#include <cstddef>

namespace zeroset::test {

ExactRay::ExactRay(const Camera& camera, int width_px, int height_px, int col, int row) {
    const ViewFrame view(camera);
    const MpfrNumber pixel =
        MpfrNumber(2.0 * view.half_height) / MpfrNumber(static_cast<double>(height_px));
    const MpfrNumber u = MpfrNumber(col + 0.5 - 0.5 * width_px) * pixel;
    const MpfrNumber v = MpfrNumber(0.5 * height_px - row - 0.5) * pixel;
    for (std::size_t i = 0; i < 3; ++i) {
        const int axis = static_cast<int>(i);
        eye_[i] = MpfrNumber(view.eye[axis]);
        direction_[i] = MpfrNumber(view.forward[axis]) + u * MpfrNumber(view.right[axis]) +
                        v * MpfrNumber(view.up[axis]);
    }
}

std::array<MpfrNumber, 3> ExactRay::at(const MpfrNumber& t) const {
    return {eye_[0] + t * direction_[0], eye_[1] + t * direction_[1], eye_[2] + t * direction_[2]};
}

double ExactRay::length() const {
    return std::hypot(direction_[0].nearest(), direction_[1].nearest(), direction_[2].nearest());
}

}  // namespace zeroset::test
