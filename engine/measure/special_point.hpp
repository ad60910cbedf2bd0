#pragma once

#include "engine/kernel/kernel.hpp"
#include "engine/scene/region.hpp"
#include "engine/view/box.hpp"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>

// Points where a surface f = 0 is special, found by Newton's method on f and its gradient in
// double: numerical, without a proof that there is such a point, nor that no other one is nearer.

namespace zeroset {

/// f and its derivatives by x, y and z, each as a formula of its own.
struct DerivedFormula {
    Kernel f;
    std::array<Kernel, 3> slopes;
};

enum class SpecialKind : std::uint8_t {
    Singular,  ///< f's gradient vanishes, too
    Top,       ///< no point of the surface nearby is higher
    Bottom,    ///< no point of the surface nearby is lower
};

struct SpecialPoint {
    glm::dvec3 at{0.0};
    SpecialKind kind = SpecialKind::Singular;
    double f = 0.0;      ///< there, in double
    double slope = 0.0;  ///< the length of f's gradient there
};

struct SpecialSearch {
    glm::dvec3 from{0.0};
    glm::dvec3 up{0.0, 0.0, 1.0};  ///< not 0
    Box clip;                      ///< only points in the clip box and the region are of interest
    Region region;
};

/// The special point that is nearest to `from`, of all that Newton's method finds from there and
/// from places about it; nothing where it finds none. Flat surfaces across `up` have no top.
std::optional<SpecialPoint> nearest_special_point(const DerivedFormula& formula,
                                                  const Uniforms& uniforms,
                                                  const SpecialSearch& search);

}  // namespace zeroset
