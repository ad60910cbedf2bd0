#pragma once

#include "engine/kernel/patch_code.hpp"
#include "engine/view/box.hpp"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace zeroset {

/// The (u, v) with |u - u_i| <= u_radius and |v - v_i| <= v_radius.
struct UvBox {
    double u, v, u_radius, v_radius;

    /// The box with radii times `factor`.
    [[nodiscard]] UvBox grown(double factor) const {
        return {.u = u, .v = v, .u_radius = factor * u_radius, .v_radius = factor * v_radius};
    }
};

/// What is known of a patch over a box:
///   S is in c + ku eu + kv ev + [-e, e]  for eu, ev in [-1, 1], which run over the box,
/// and the derivatives of S by eu and ev are within their radii of du and dv. Where nothing is
/// known radii and e are +inf.
struct PatchForm {
    glm::dvec3 c, ku, kv, e;
    glm::dvec3 du, dv, du_radius, dv_radius;
    glm::dvec3 value_error;  ///< of an evaluation of S at a point of the box
    /// Of coordinates whose e is +inf: they are at least lo and at most hi; or one of both where lo
    /// is above hi.
    glm::dvec3 lo, hi;
    bool continuous = false;
    bool nowhere = false;  ///< S is not defined anywhere in the box

    /// The most by which S differs from c.
    [[nodiscard]] glm::dvec3 spread() const { return glm::abs(ku) + glm::abs(kv) + e; }
};

/// The form of those places of a box that are in a clip box: where nothing is known of a
/// coordinate, it is known to be there. Nothing where no place of the box is. In upward rounding.
std::optional<PatchForm> form_within(const PatchForm& form, const Box& clip);

/// S and its derivatives by u and v, as they are computed.
struct PatchPoint {
    glm::dvec3 s, su, sv;
};

/// Asks the code of a patch, for some values of the uniforms. Read-only; any thread. All in upward
/// rounding.
class PatchForms {
public:
    static constexpr std::size_t at_once = batch_multiple;
    using Boxes = std::array<UvBox, at_once>;
    using Forms = std::array<PatchForm, at_once>;

    PatchForms(std::shared_ptr<const PatchCode> code, Uniforms uniforms)
        : code_(std::move(code)), uniforms_(std::move(uniforms)) {}

    /// The forms over boxes that all have the radii of the first.
    void evaluate(const Boxes& boxes, Forms& forms) const;
    /// S at (u, v) of each pair.
    void evaluate(std::span<const glm::dvec2> places, std::span<PatchPoint> points) const;

private:
    std::shared_ptr<const PatchCode> code_;
    Uniforms uniforms_;
};

}  // namespace zeroset
