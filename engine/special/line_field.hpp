#pragma once

#include "engine/real/field.hpp"
#include "engine/special/pieces.hpp"

#include <memory>
#include <string>

namespace zeroset {

/// A function of a real number in pieces. Left of 0, where it is defined there, it is
/// `left_sign` times pieces of -x.
struct PiecedLine {
    std::string name;       ///< how it is typed: besselj
    std::string arguments;  ///< with # for x: "(2, #)"
    std::shared_ptr<const Pieces> right;
    std::shared_ptr<const Pieces> left;  ///< nullptr: only defined right of 0
    double left_sign = 1;

    /// The factor of a derivative left of 0.
    [[nodiscard]] double sign(int order) const { return order % 2 == 0 ? left_sign : -left_sign; }
};

/// The function, or its first or second derivative, of the first operand; the others are 0. Exact
/// in double but for the errors of the pieces, which the answers contain.
class LineField : public Field {
public:
    LineField(std::shared_ptr<const PiecedLine> line, int shift);

    [[nodiscard]] const PiecedLine& line() const { return *line_; }
    /// How often the function is differentiated.
    [[nodiscard]] int shift() const { return shift_; }
    /// The derivative by x as a field with slopes of its own; nullptr for none.
    [[nodiscard]] std::shared_ptr<const LineField> derivative() const;

    [[nodiscard]] std::string text() const override;
    [[nodiscard]] bool is_total() const override { return line_->left != nullptr; }
    [[nodiscard]] bool is_continuous() const override { return true; }

    void values(int derivative, const float* in, float* out, int lanes) const override;
    void values(int derivative, const double* in, double* out, int lanes) const override;
    void ranges(int derivative, const float* in, float* out, int lanes) const override;
    void ranges(int derivative, const double* in, double* out, int lanes) const override;
    void forms(const float* in, float* out, int lanes) const override;
    void forms(const double* in, double* out, int lanes) const override;

private:
    std::shared_ptr<const PiecedLine> line_;
    int shift_;
    std::shared_ptr<const LineField> derivative_;
};

}  // namespace zeroset
