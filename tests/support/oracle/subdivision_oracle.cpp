#include "tests/support/oracle/subdivision_oracle.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace zeroset::test {
namespace {

constexpr mpfr_prec_t working_bits = 128;

/// Place at which pieces are divided; uneven, so that no end is a root of a formula in round
/// numbers.
constexpr double split = 0.4921875 + 0x1p-30;

}  // namespace

SubdivisionOracle::SubdivisionOracle(const Expr& expr, std::span<const double> uniforms,
                                     Budget budget)
    : evaluator_(expr), variables_(3 + uniforms.size()), budget_(budget) {
    const WorkingPrecision precision(working_bits);
    for (std::size_t i = 0; i < uniforms.size(); ++i)
        variables_[3 + i] = dual(MpfiInterval(uniforms[i]), MpfiInterval(0.0));
}

MpfiDual SubdivisionOracle::along(double from, double to) {
    ++evaluations_;
    const MpfiInterval t(from, to);
    for (std::size_t i = 0; i < 3; ++i) {
        const MpfiInterval step(ray_.direction.at(i));
        variables_[i] = dual(MpfiInterval(ray_.eye.at(i)) + step * t, step);
    }
    return evaluator_.along(variables_);
}

/// The proved sign of f, or 0.
int SubdivisionOracle::sign_at(double t) {
    const MpfiDual f = along(t, t);
    return f.value.everywhere ? f.value.range.sign() : 0;
}

/// Whether f is proved to have opposite signs at two places.
bool SubdivisionOracle::crosses(double from, double to) {
    const int sign = sign_at(from);
    return sign != 0 && sign_at(to) == -sign;
}

SubdivisionOracle::Piece SubdivisionOracle::look_at(double from, double to) {
    const MpfiDual f = along(from, to);
    if (!f.value.somewhere || f.value.range.sign() != 0) return Piece::Free;
    if (!f.value.everywhere || !f.value.continuous) return Piece::Undecided;
    if (f.slope.sign() != 0) {
        const int first = sign_at(from);
        const int last = sign_at(to);
        if (first == 0 || last == 0) return Piece::Undecided;
        return first == last ? Piece::Free : Piece::Crossed;
    }
    if (!f.slope.is_bounded()) return Piece::Undecided;
    const double middle = from + 0.5 * (to - from);
    const MpfiInterval offset = MpfiInterval(from, to) - MpfiInterval(middle);
    const MpfiInterval mean_value = along(middle, middle).value.range + f.slope * offset;
    return mean_value.sign() != 0 ? Piece::Free : Piece::Undecided;
}

/// Narrows a piece on which f is continuous and monotone, with opposite signs at its ends, to the
/// root.
RayAnswer SubdivisionOracle::narrowed(double from, double to) {
    const int first = sign_at(from);
    while (to - from > budget_.finest * (ray_.outer_to - ray_.outer_from)) {
        const double middle = from + split * (to - from);
        const int sign = sign_at(middle);
        if (sign == 0) break;
        (sign == first ? from : to) = middle;
    }
    return hit_between(ray_, from, to, true);
}

RayAnswer SubdivisionOracle::answer(const RayQuestion& ray) {
    const WorkingPrecision precision(working_bits);
    ray_ = ray;
    evaluations_ = 0;
    const double finest = budget_.finest * (ray.outer_to - ray.outer_from);
    std::vector<std::pair<double, double>> pieces{{ray.outer_from, ray.outer_to}};
    while (!pieces.empty()) {
        if (evaluations_ > budget_.evaluations) return {};
        const auto [from, to] = pieces.back();
        pieces.pop_back();
        const Piece piece = look_at(from, to);
        if (piece == Piece::Free) continue;
        if (piece == Piece::Crossed) return narrowed(from, to);
        if (to - from <= finest) {
            // f is not monotone here: a kink, a multiple root, or several roots.
            const double behind = std::min(to + finest, ray.outer_to);
            const MpfiEnclosure f = along(from, behind).value;
            const bool smooth = f.everywhere && f.continuous;
            return smooth && crosses(from, behind) ? hit_between(ray, from, behind, true)
                                                   : RayAnswer{};
        }
        const double middle = from + split * (to - from);
        pieces.emplace_back(middle, to);
        pieces.emplace_back(from, middle);
    }
    return {RayTruth::Empty, 0.0, 0.0, false};
}

}  // namespace zeroset::test
