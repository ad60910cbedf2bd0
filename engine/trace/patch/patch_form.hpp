#pragma once

#include "engine/kernel/patch_code.hpp"
#include "engine/real/unbounded.hpp"
#include "engine/view/box.hpp"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace zeroset {

/// A linear form that encloses a patch S over a box:
///   S is in c + ku eu + kv ev + [-e, e]  for eu, ev in [-1, 1], which run over the box,
/// and the derivatives by eu and ev of what is evaluated in place of S, from which S differs by
/// value_error at most, are within their radii of du and dv. Where nothing is known radii and e are
/// +inf.
struct PatchForm {
    glm::dvec3 c, ku, kv, e;
    glm::dvec3 du, dv, du_radius, dv_radius;
    glm::dvec3 value_error;  ///< of an evaluation at a point of the box
    /// Bounds of a coordinate whose e is +inf: it is in [lo, hi] or, where lo > hi, it is <= hi or
    /// >= lo.
    glm::dvec3 lo, hi;
    bool continuous = false;
    bool nowhere = false;  ///< S is not defined anywhere in the box

    /// Whether S is not continuous, as far as is known, but in a place that is known.
    [[nodiscard]] bool is_bounded_jump() const { return !continuous && known(); }
    /// The most by which S differs from c.
    [[nodiscard]] glm::dvec3 spread() const { return glm::abs(ku) + glm::abs(kv) + e; }
    /// Whether something is known of each coordinate.
    [[nodiscard]] bool known() const {
        return e.x < unbounded && e.y < unbounded && e.z < unbounded;
    }
};

/// The form of those places of a box that are in a clip box: where nothing is known of a
/// coordinate, it is known to be there. Nothing where no place of the box is. In upward rounding.
std::optional<PatchForm> form_within(const PatchForm& form, const Box& clip);

/// The result of form_within, which does not copy a form that is known.
class FormWithin {
public:
    FormWithin(const PatchForm& form, const Box& clip);
    FormWithin(const FormWithin&) = delete;
    FormWithin& operator=(const FormWithin&) = delete;
    ~FormWithin() = default;

    explicit operator bool() const { return form_ != nullptr; }
    const PatchForm& operator*() const { return *form_; }

private:
    const PatchForm* form_ = nullptr;
    std::optional<PatchForm> changed_;
};

/// The form by a model that knows all coordinates; its polynomials are evaluated in place of S. In
/// upward rounding.
PatchForm form_of(const PatchModel& model);

/// S and its derivatives by u and v, as they are computed.
struct PatchPoint {
    glm::dvec3 s, su, sv;
};

/// The polynomials of a model and their derivatives by p and q, at a place in [-1, 1]^2.
PatchPoint value_of(const PatchModel& model, double p, double q);

/// Evaluates the code of a patch for some values of the uniforms. Read-only; any thread. All in
/// upward rounding.
class PatchForms {
public:
    static constexpr std::size_t at_once = batch_multiple;
    using Boxes = std::array<UvBox, at_once>;
    using Forms = std::array<PatchForm, at_once>;

    PatchForms(std::shared_ptr<const PatchCode> code, Uniforms uniforms)
        : code_(std::move(code)), uniforms_(std::move(uniforms)) {}

    /// The forms over boxes that all have the radii of the first; S itself is evaluated.
    void evaluate(const Boxes& boxes, Forms& forms) const;
    /// The model of each box; false: there are none.
    [[nodiscard]] bool make_models(std::span<const UvBox> boxes,
                                   std::span<PatchModel> models) const;
    /// S at (u, v) of each pair.
    void evaluate(std::span<const glm::dvec2> places, std::span<PatchPoint> points) const;

private:
    std::shared_ptr<const PatchCode> code_;
    Uniforms uniforms_;
};

}  // namespace zeroset
