#pragma once

#include "engine/view/camera.hpp"
#include "tests/support/mpfr_number.hpp"

#include <array>

namespace zeroset::test {

/// The ray of a pixel from ViewFrame's numbers, in 256 bits: t is 1 at a distance of 1 from the eye
/// along the view.
class ExactRay {
public:
    ExactRay(const Camera& camera, int width_px, int height_px, int col, int row);

    [[nodiscard]] std::array<MpfrNumber, 3> at(const MpfrNumber& t) const;
    /// Distance of the point at t = 1 from the eye.
    [[nodiscard]] double length() const;

private:
    std::array<MpfrNumber, 3> eye_, direction_;
};

}  // namespace zeroset::test
