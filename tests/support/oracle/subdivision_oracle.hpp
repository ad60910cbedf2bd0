#pragma once

#include "tests/support/oracle/mpfi_evaluator.hpp"
#include "tests/support/oracle/ray_question.hpp"

#include <span>
#include <vector>

namespace zeroset::test {

/// Looks for the first root on a ray by dividing it: a piece is proved free of roots by an
/// enclosure in MPFI, by the mean value form, or by a slope that keeps its sign. Works for any
/// formula; answers Unknown where its budget does not suffice.
class SubdivisionOracle {
public:
    struct Budget {
        int evaluations = 600;  ///< limit for one ray
        double finest = 1e-8;   ///< shortest pieces, as a part of the ray's outer range
    };

    /// `uniforms` are w and the parameters.
    SubdivisionOracle(const Expr& expr, std::span<const double> uniforms, Budget budget);
    SubdivisionOracle(const Expr& expr, std::span<const double> uniforms)
        : SubdivisionOracle(expr, uniforms, Budget{}) {}

    RayAnswer answer(const RayQuestion& ray);

private:
    enum class Piece : std::uint8_t { Free, Crossed, Undecided };

    MpfiDual along(double from, double to);
    int sign_at(double t);
    Piece look_at(double from, double to);
    [[nodiscard]] bool crosses(double from, double to);
    RayAnswer narrowed(double from, double to);

    MpfiEvaluator evaluator_;
    std::vector<MpfiDual> variables_;
    Budget budget_;
    RayQuestion ray_{};
    int evaluations_ = 0;
};

}  // namespace zeroset::test
