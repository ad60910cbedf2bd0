#pragma once

#include "engine/draw/space_function.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace zeroset {

/// The functions whose common zeros are a curve.
struct CurveEquations {
    using Functions = std::vector<std::shared_ptr<const SpaceFunction>>;

    Functions zero;  ///< two, or three that are 0 on a curve only together
    /// Vanish on the wanted parts of the curve, too: two functions' curve is followed beyond those,
    /// three functions' zeros of which these are not 0 are none of the curve.
    Functions also = {};
};

/// The equations at a point, reduced to the two that tell most, to first order.
struct Linearized {
    glm::dvec2 value;
    glm::dvec3 gradients[2];
    glm::dvec3 across;  ///< the cross product of the gradients; along the curve
    double rest = 0.0;  ///< the value of the third equation, if there are three

    [[nodiscard]] bool is_usable() const;
    [[nodiscard]] glm::dvec3 tangent() const { return glm::normalize(across); }
    /// The step of Newton's method that stays in the plane across `normal`.
    [[nodiscard]] glm::dvec3 step(const glm::dvec3& normal) const;
};

/// The verdict of enclosures on the curve in a box.
enum class CellState : std::uint8_t {
    Empty,    ///< no point of it is there
    Regular,  ///< on each plane across `tangent` there is at most one point, in the box around, too
    Open,
};
struct JudgedCell {
    CellState state = CellState::Open;
    glm::dvec3 tangent{0.0};  ///< if Regular; of length 1
};

/// A curve given by equations. Any thread.
class CurveSystem {
public:
    explicit CurveSystem(CurveEquations equations) : equations_(std::move(equations)) {}

    [[nodiscard]] Linearized at(const glm::dvec3& point) const;
    /// Judges boxes of one size by enclosures over them and over the boxes `around`, which hold
    /// them.
    void judge(std::span<const Box> boxes, std::span<const Box> around,
               std::span<JudgedCell> out) const;
    /// Whether enclosures of the functions themselves leave a point of the curve possible in each
    /// box; much quicker than `judge`.
    void sift(std::span<const Box> boxes, std::span<bool> may_hold) const;
    /// The point of the curve near `start` on the plane through that across `normal`, if Newton's
    /// method finds it within `reach`; to the digits of double.
    [[nodiscard]] std::optional<glm::dvec3> point_near(const glm::dvec3& start,
                                                       const glm::dvec3& normal,
                                                       double reach) const;
    /// The nearest point of the curve, about.
    [[nodiscard]] std::optional<glm::dvec3> point_near(const glm::dvec3& start, double reach) const;

private:
    /// Which boxes of one size surely hold no point, by linear enclosures.
    [[nodiscard]] std::vector<bool> empty_cells(std::span<const Box> boxes) const;
    /// In which boxes none of the functions jumps.
    [[nodiscard]] std::vector<bool> are_continuous(std::span<const Box> boxes) const;
    /// Judges boxes by enclosures of the derivatives.
    void judge_slopes(std::span<const Box> boxes, std::span<const Box> around,
                      std::span<JudgedCell> out) const;
    /// Whether a common zero of three functions' reduced equations is one of all, up to rounding.
    [[nodiscard]] bool is_zero_of_all(const glm::dvec3& point, const Linearized& there,
                                      double reach) const;
    [[nodiscard]] std::optional<glm::dvec3> solve(const glm::dvec3& start, const glm::dvec3* normal,
                                                  double reach) const;

    CurveEquations equations_;
};

}  // namespace zeroset
