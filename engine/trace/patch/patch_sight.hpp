#pragma once

#include "engine/trace/patch/matrix2.hpp"
#include "engine/trace/patch/patch_form.hpp"

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

// A patch as rays see it [Toth85]. In the axes of a view a point is (a, b, s): to the right,
// upwards, and forward of `base`. The ray of (u, v) of the image plane holds the points with
//   a = u (distance + s),  b = v (distance + s),
// so that the places of the patch on it are the zeros of
//   g = (a - u (distance + s), b - v (distance + s)),
// two functions of two unknowns. Here these are (p, q) in [-1, 1]^2, which run over a box.

namespace zeroset {

/// The sum of the lengths of a model's terms of each degree, or more.
using ModelSizes = std::array<float, std::size_t{patch_degree} + 1>;

/// More than is lost by the rounding of some tens of operations, relative to the sizes that go in.
inline constexpr double sight_rounding = 0x1p-46;

/// The axes of a view, or of a single ray.
struct SightAxes {
    glm::dvec3 right, up, forward, base;
    double distance;  ///< a large one for parallel rays, as of TileRays
    double error;     ///< of places, in world units

    /// (a, b, s) of a point.
    [[nodiscard]] glm::dvec3 place(const glm::dvec3& point) const { return turned(point - base); }
    [[nodiscard]] glm::dvec3 turned(const glm::dvec3& way) const {
        return {glm::dot(right, way), glm::dot(up, way), glm::dot(forward, way)};
    }
    /// A bound of the turned vector's size in each axis, where only sizes are known.
    [[nodiscard]] glm::dvec3 turned_size(const glm::dvec3& size) const {
        return {glm::dot(glm::abs(right), size), glm::dot(glm::abs(up), size),
                glm::dot(glm::abs(forward), size)};
    }
};

/// A ray of a view, in its image plane.
struct SightRay {
    double u, v;
};

/// Rays whose u and v are so far from those of `middle` at most.
struct SightRays {
    SightRay middle;
    double u_radius = 0.0, v_radius = 0.0;
};

/// A range of depths.
struct SightDepths {
    double near, far;
};

/// A form in the axes of a view: as PatchForm, of (a, b, s).
struct PatchSight {
    glm::dvec3 c, kp, kq, e;
    glm::dvec3 dp, dq, dp_radius, dq_radius;
    double value_error = 0.0;  ///< of (a, b, s) of an evaluation

    [[nodiscard]] glm::dvec3 spread() const { return glm::abs(kp) + glm::abs(kq) + e; }
    /// Depths between which the part is.
    [[nodiscard]] SightDepths depths() const {
        const double radius = spread().z;
        return {.near = c.z - radius, .far = c.z + radius};
    }
};

/// A form in the axes of a view.
PatchSight sight_of(const PatchForm& form, const SightAxes& axes);
/// A form in the axes of a view without the derivatives; value_error is of the axes alone.
PatchSight place_of(const PatchForm& form, const SightAxes& axes);
/// Add the derivatives, and what value_error lacks, to `place_of`.
void add_slopes(PatchSight& sight, const PatchForm& form, const SightAxes& axes);
void add_value_error(PatchSight& sight, const PatchForm& form);

/// Where in a box the zeros of g are: p within p_radius of `p`, and q likewise.
struct LinearZeros {
    bool any;    ///< else there are none
    bool known;  ///< else they may be anywhere
    double p, q, p_radius, q_radius;

    /// Whether they are all outside of |p|, |q| <= bound.
    [[nodiscard]] bool beyond(double bound) const {
        return known && (std::abs(p) - p_radius > bound || std::abs(q) - q_radius > bound);
    }
};

/// The zeros of g by the linear form alone.
LinearZeros linear_zeros(const PatchSight& sight, const SightAxes& axes, const SightRay& ray);

/// Krawczyk's test of a box for some rays [Krawczyk69]: with Y near the inverse of g' in the
/// middle, |I - Y g'| over the box and all rays has norm `norm` at most. If that is below 1, there
/// is at most one zero for each.
struct Contraction {
    Matrix2<double> inverse;  ///< Y
    double norm;
};

Contraction contraction_of(const PatchSight& sight, const SightRays& rays);

/// The result of Krawczyk's test of a box by an evaluation at a place (p, q) of it.
struct ZeroTest {
    enum class Found : std::uint8_t {
        None,     ///< the box holds no zero within `bound` of its middle
        One,      ///< it holds exactly one, within `radius` of (p, q)
        Unknown,  ///< one at most
    };
    Found found;
    double p, q, radius;  ///< a better place, and how far any zero of the box is from it at most
    double s, s_radius;   ///< where on the ray that zero is
};

/// A place in a box.
struct BoxPlace {
    double p, q;
};

/// Where Newton's method goes from a place of a box at which S and its derivatives were computed,
/// within the box; `by_p` and `by_q`: the derivatives in the axes. Without them where `test` is.
BoxPlace newton_place(const ZeroTest& test, const SightAxes& axes, const SightRay& ray,
                      const glm::dvec3& at, const glm::dvec3& by_p, const glm::dvec3& by_q,
                      const BoxPlace& from);

/// Tests a box by S at (p, q) in [-1, 1]^2; `at`: S in the axes; `contraction.norm`: below 1.
ZeroTest zero_test(const PatchSight& sight, const SightAxes& axes, const SightRay& ray,
                   const Contraction& contraction, const glm::dvec3& at, double p, double q,
                   double bound);

}  // namespace zeroset
