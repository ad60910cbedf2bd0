#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>

namespace zeroset {

/// A function of three numbers that is no formula, such as a volume of samples: it encloses itself.
/// Owned by shared pointers. Immutable, so any number of threads may ask at once, in any rounding
/// mode, which stays as it is.
///
/// Each question takes and gives columns of `lanes` numbers: number i of a lane stands at
/// [i * lanes + lane]. A derivative says how often by each argument: 0 is the function itself.
class Field : public std::enable_shared_from_this<Field> {
public:
    Field();
    Field(const Field&) = delete;
    Field& operator=(const Field&) = delete;
    virtual ~Field() = default;

    /// Different for all that were ever made in this process.
    [[nodiscard]] std::uint64_t id() const { return id_; }
    /// The text of the field in a printed formula, in front of its operands' parenthesis.
    [[nodiscard]] virtual std::string text() const = 0;
    /// Whether it is defined everywhere, and whether it is continuous wherever it is defined.
    [[nodiscard]] virtual bool is_total() const = 0;
    [[nodiscard]] virtual bool is_continuous() const = 0;

    virtual void values(int derivative, const float* in, float* out, int lanes) const = 0;
    virtual void values(int derivative, const double* in, double* out, int lanes) const = 0;
    virtual void ranges(int derivative, const float* in, float* out, int lanes) const = 0;
    virtual void ranges(int derivative, const double* in, double* out, int lanes) const = 0;
    virtual void forms(const float* in, float* out, int lanes) const = 0;
    virtual void forms(const double* in, double* out, int lanes) const = 0;

private:
    std::uint64_t id_;
};

/// How often it is differentiated by x, y and z, as one number; at most 3 times by each.
constexpr int derivative_by(int x, int y, int z) { return x + 4 * y + 16 * z; }
constexpr std::array<int, 3> times_of(int derivative) {
    return {derivative % 4, derivative / 4 % 4, derivative / 16};
}
constexpr int order_of(int derivative) {
    const auto times = times_of(derivative);
    return times[0] + times[1] + times[2];
}
/// The derivative of a derivative by one more axis.
constexpr int once_more_by(int derivative, std::size_t axis) {
    return derivative + (axis == 0 ? 1 : axis == 1 ? 4 : 16);
}
/// The highest order of which fields know values and ranges.
inline constexpr int highest_order = 2;

// The questions and answers of fields, by place. Masks are numbers: 1 where it holds, else 0.

/// The function or a derivative at points, with its slopes; NaN where it is not defined or not
/// known. Not rounded outward: the error of the value is at most that which `forms` tells.
struct FieldValue {
    static constexpr std::size_t x = 0, questions = 3;
    static constexpr std::size_t value = 0, slope = 1, answers = 4;
};

/// The range over boxes, rounded outward, and masks as in Enclosure.
struct FieldRange {
    static constexpr std::size_t neg_lo = 0, hi = 3, questions = 6;
    static constexpr std::size_t range = 0;  ///< -lo and hi
    static constexpr std::size_t somewhere = 2, everywhere = 3, continuous = 4, answers = 5;
};

/// Over boxes and at points in them: the range and masks as in FieldRange; the slopes of the smooth
/// pieces; what encloses the value at the point, the whole line where a jump or a hole in the box
/// lets the slopes not bound how far it is from others; and the rounding error of `values` anywhere
/// in the box, as in Beam::r.
struct FieldForm {
    static constexpr std::size_t neg_lo = 0, hi = 3, middle = 6, questions = 9;
    static constexpr std::size_t range = 0;
    static constexpr std::size_t somewhere = 2, everywhere = 3, continuous = 4;
    static constexpr std::size_t at_middle = 5;  ///< -lo and hi
    static constexpr std::size_t slopes = 7;     ///< -lo and hi for each axis
    static constexpr std::size_t rounding = 13, answers = 14;
};

/// A question by its type, in the numbers of a kernel.
template <class Question, class Real>
void ask(const Field& field, int derivative, const Real* in, Real* out, int lanes) {
    if constexpr (std::is_same_v<Question, FieldValue>) {
        field.values(derivative, in, out, lanes);
    } else if constexpr (std::is_same_v<Question, FieldRange>) {
        field.ranges(derivative, in, out, lanes);
    } else {
        field.forms(in, out, lanes);
    }
}

/// The answers in a carrier of one number.
template <class Question>
std::array<float, Question::answers> answers(Question /*question*/, const Field& field,
                                             int derivative,
                                             const std::array<float, Question::questions>& in) {
    std::array<float, Question::answers> out;
    ask<Question>(field, derivative, in.data(), out.data(), 1);
    return out;
}
template <class Question>
std::array<double, Question::answers> answers(Question /*question*/, const Field& field,
                                              int derivative,
                                              const std::array<double, Question::questions>& in) {
    std::array<double, Question::answers> out;
    ask<Question>(field, derivative, in.data(), out.data(), 1);
    return out;
}

}  // namespace zeroset
