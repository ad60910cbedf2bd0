#include "tests/oracle/form_inclusion.hpp"

#include "engine/real/rounding.hpp"
#include "engine/trace/tile_rays.hpp"
#include "tests/support/oracle/mpfi_evaluator.hpp"
#include "tests/support/random_expression.hpp"

#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace zeroset::test {
namespace {

constexpr mpfr_prec_t wide_bits = 256;

/// The answers of a form kernel for the cells, and values at the near places.
template <class Real>
struct FormAnswers {
    std::array<Real, cells_a_batch> c{}, e{}, r{}, slope_neg_lo{}, slope_hi{};
    std::array<std::array<Real, cells_a_batch>, 3> k{};
    std::array<ContinuityMask<Real>, cells_a_batch> continuous{}, nowhere{};
    std::array<double, cells_a_batch> value{};
};

template <class Batch>
void run(const KernelFunction<Batch>& function, const Batch& batch) {
    // Call it without its check of the mode, which a mutant fails.
    function.call(function.code.get(), &batch);
}

/// Computes values as the tracer does for its certificates.
template <class Real>
void find_values(const Kernel& kernel, const FormCells<Real>& cells,
                 std::array<double, cells_a_batch>& value) {
    std::array<float, cells_a_batch> col{};
    std::array<float, cells_a_batch> row{};
    std::array<float, cells_a_batch> per_slope{};  // no steps are taken
    std::array<double, cells_a_batch> s{};
    for (std::size_t i = 0; i < cells_a_batch; ++i) {
        col[i] = from_middle(cells.near[i].col);
        row[i] = from_middle(cells.near[i].row);
        s[i] = cells.near[i].s;
    }
    const UpwardRounding upward;  // also in a mutant, as interpreters check the mode
    run(kernel.ray_value, RayValueBatch{cells_a_batch, col.data(), row.data(), per_slope.data(), 0,
                                        0.0, 0.0, s.data(), cells.rays.origin,
                                        cells.uniforms.template points<double>(), value.data()});
}

template <class Real>
FormAnswers<Real> answers_of(const Kernel& kernel, const FormCells<Real>& cells) {
    FormAnswers<Real> out;
    const FormBatchOf<Real> batch{cells_a_batch,
                                  cells.u.data(),
                                  cells.v.data(),
                                  cells.s.data(),
                                  cells.s_radius.data(),
                                  cells.frustum.base,
                                  cells.uniforms.template boxes<Real>(),
                                  out.c.data(),
                                  {out.k[0].data(), out.k[1].data(), out.k[2].data()},
                                  out.e.data(),
                                  out.r.data(),
                                  out.slope_neg_lo.data(),
                                  out.slope_hi.data(),
                                  out.continuous.data(),
                                  out.nowhere.data()};
    if constexpr (std::is_same_v<Real, float>) {
        run(kernel.in_float.form, batch);
    } else {
        run(kernel.in_double.form, batch);
    }
    find_values(kernel, cells, out.value);
    return out;
}

/// The formula's value and slope along one ray, by MPFI.
class AlongRay {
public:
    template <class Real>
    AlongRay(MpfiEvaluator& evaluator, const FormCells<Real>& cells, const RayPlace& ray)
        : evaluator_(evaluator) {
        const ViewFrame& view = cells.view;
        for (int k = 0; k < 3; ++k) {
            const MpfiInterval across = MpfiInterval(ray.u) * MpfiInterval(view.right[k]) +
                                        MpfiInterval(ray.v) * MpfiInterval(view.up[k]);
            origin_.push_back(MpfiInterval(cells.base[k]) + MpfiInterval(cells.distance) * across);
            direction_.push_back(MpfiInterval(view.forward[k]) + across);
        }
        variables_.resize(4);
        variables_[3] = dual(MpfiInterval(cells.w), MpfiInterval(0.0));
    }
    MpfiDual at(double s) {
        for (std::size_t k = 0; k < 3; ++k)
            variables_[k] = dual(origin_[k] + MpfiInterval(s) * direction_[k], direction_[k]);
        return evaluator_.along(variables_);
    }

private:
    MpfiEvaluator& evaluator_;
    std::vector<MpfiInterval> origin_, direction_;
    std::vector<MpfiDual> variables_;
};

/// Checks the claims about one cell against the truth at its places.
template <class Real>
class CellCheck {
public:
    /// `turns`: where the formula is not continuous, its form may enclose its negative instead.
    CellCheck(const FormCells<Real>& cells, const FormAnswers<Real>& answers, std::size_t cell,
              bool turns, InclusionTally& tally)
        : cells_(cells), out_(answers), i_(cell), turns_(turns), tally_(tally) {}

    /// The first wrong claim at a place where the formula is `truth`, or an empty text.
    std::string at(const RayPlace& place, const MpfiDual& truth) {
        const MpfiEnclosure& f = truth.value;
        if (!f.somewhere) {
            ++tally_.checks;
            return continuous() ? "undefined there, but claimed continuous" : "";
        }
        if (!f.everywhere) return "";
        tally_.checks += 2;
        if (out_.nowhere[i_] != 0) return "defined there, but claimed undefined";
        const bool negative = turns_ && !continuous() && is_in_form(place, -f.range);
        if (!negative && !is_in_form(place, f.range)) {
            return "not enclosed: " + f.range.text() + " by the form " + text();
        }
        if (!continuous()) return "";
        ++tally_.checks;
        return meets(slope(), truth.slope)
                   ? ""
                   : "slope " + truth.slope.text() + " not enclosed by " + hex(slope());
    }
    /// Checks the slope by the mean value theorem between the depths s and t of one ray.
    std::string between(double s, const MpfiDual& f, double t, const MpfiDual& g) {
        const bool known = f.value.everywhere && g.value.everywhere && s < t;
        if (!continuous() || !known) return "";
        ++tally_.checks;
        const MpfiInterval mean =
            (g.value.range - f.value.range) / (MpfiInterval(t) - MpfiInterval(s));
        return meets(slope(), mean)
                   ? ""
                   : "mean slope " + mean.text() + " not enclosed by " + hex(slope());
    }
    /// Checks the value computed at a place where the formula is `f`.
    std::string of_value(const MpfiEnclosure& f) {
        const auto r = static_cast<double>(out_.r[i_]);
        if (!continuous() || !f.everywhere || !(r < infinity)) return "";
        ++tally_.checks;
        const double error = std::numeric_limits<double>::epsilon() * r;
        const double value = out_.value[i_];
        const std::string off =
            "value " + hex(value) + " of " + f.range.text() + " is off by more than " + hex(error);
        if (!std::isfinite(value)) return off;
        const MpfiInterval difference = f.range - MpfiInterval(value);
        return difference.is_above(error) || difference.is_below(-error) ? off : "";
    }

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    [[nodiscard]] bool continuous() const { return out_.continuous[i_] != 0; }
    [[nodiscard]] Interval<Real> slope() const {
        return {out_.slope_neg_lo[i_], out_.slope_hi[i_]};
    }
    /// A variable as the form takes it: its distance from the middle, in units of the radius.
    static MpfiInterval unit(double at, Real middle, Real radius) {
        if (radius == 0) return MpfiInterval(0.0);
        return (MpfiInterval(at) - MpfiInterval(static_cast<double>(middle))) /
               MpfiInterval(static_cast<double>(radius));
    }
    [[nodiscard]] bool is_in_form(const RayPlace& at, const MpfiInterval& f) const {
        const auto number = [&](const auto& column) {
            return MpfiInterval(static_cast<double>(column[i_]));
        };
        const auto e = static_cast<double>(out_.e[i_]);
        if (e == infinity) return true;
        if (std::isnan(e)) return false;
        const MpfiInterval linear =
            number(out_.c) + number(out_.k[0]) * unit(at.u, cells_.u[i_], cells_.frustum.u_radius) +
            number(out_.k[1]) * unit(at.v, cells_.v[i_], cells_.frustum.v_radius) +
            number(out_.k[2]) * unit(at.s, cells_.s[i_], cells_.s_radius[i_]);
        const MpfiInterval rest = f - linear;
        return !rest.is_above(e) && !rest.is_below(-e);
    }
    [[nodiscard]] std::string text() const {
        const auto number = [&](const auto& column) {
            return hex(static_cast<double>(column[i_]));
        };
        return number(out_.c) + " + " + number(out_.k[0]) + " eu + " + number(out_.k[1]) +
               " ev + " + number(out_.k[2]) + " et +- " + number(out_.e);
    }

    const FormCells<Real>& cells_;
    const FormAnswers<Real>& out_;
    std::size_t i_;
    bool turns_;
    InclusionTally& tally_;
};

/// Whether a form may enclose the negative of the node instead, as only its zeros count there.
bool turns(const Expr& expr, NodeId id) {
    const Node& node = expr.node(id);
    if (node.op == Op::Where) return turns(expr, node.a);
    if (node.op == Op::Min || node.op == Op::Max) return turns(expr, node.a) || turns(expr, node.b);
    return node.op == Op::Oriented;
}

std::string three(const glm::dvec3& a) {
    return "(" + hex(a.x) + ", " + hex(a.y) + ", " + hex(a.z) + ")";
}

std::string described(const ViewFrame& view, double distance) {
    return "  eye " + three(view.eye) + "\n  right " + three(view.right) + "\n  up " +
           three(view.up) + "\n  forward " + three(view.forward) + ", distance " + hex(distance) +
           "\n";
}

/// The i-th cell as text, after the reason for its failure.
template <class Real>
std::string described(const FormCells<Real>& cells, std::size_t i, const std::string& reason) {
    const auto number = [](Real a) { return hex(static_cast<double>(a)); };
    return reason + "\n" + described(cells.view, cells.distance) + "  base " + three(cells.base) +
           "\n  u " + number(cells.u[i]) + " +- " + number(cells.frustum.u_radius) + ", v " +
           number(cells.v[i]) + " +- " + number(cells.frustum.v_radius) + ", s " +
           number(cells.s[i]) + " +- " + number(cells.s_radius[i]) + "\n  at u " +
           hex(cells.near[i].u) + ", v " + hex(cells.near[i].v) + ", s " + hex(cells.near[i].s) +
           " and " + hex(cells.far[i].s) + ", w " + hex(cells.w) + "\n";
}

template <class Real>
std::string disproved_of_cell(MpfiEvaluator& evaluator, const FormCells<Real>& cells,
                              const FormAnswers<Real>& answers, std::size_t i, bool turns,
                              InclusionTally& tally) {
    AlongRay ray(evaluator, cells, cells.near[i]);
    CellCheck<Real> check(cells, answers, i, turns, tally);
    const MpfiDual near = ray.at(cells.near[i].s);
    const MpfiDual far = ray.at(cells.far[i].s);
    std::string reason = check.at(cells.near[i], near);
    if (reason.empty()) reason = check.at(cells.far[i], far);
    if (reason.empty()) reason = check.between(cells.near[i].s, near, cells.far[i].s, far);
    const bool values_at_w = cells.uniforms.middle_double[0] == cells.w;
    if (reason.empty() && values_at_w) reason = check.of_value(near.value);
    return reason;
}

/// The failure of the simplest formula found that still fails on the cells.
template <class Real>
std::string shrunk_failure(MakeKernel make, Expr expr, const FormCells<Real>& cells) {
    const auto failure = [&](const Expr& formula) {
        InclusionTally tally;
        return disproved(make(formula), formula, cells, tally);
    };
    for (bool simpler = true; simpler;) {
        simpler = false;
        for (const Expr& candidate : simpler_formulas(expr)) {
            if (failure(candidate).empty()) continue;
            expr = candidate;
            simpler = true;
            break;
        }
    }
    return "formula " + expr.canonical() + ": " + failure(expr);
}

}  // namespace

template <class Real>
std::string disproved(const Kernel& kernel, const Expr& expr, const FormCells<Real>& cells,
                      InclusionTally& tally) {
    const FormAnswers<Real> answers = in_tested_mode(answers_of<Real>, kernel, cells);
    const WorkingPrecision precision(wide_bits);
    MpfiEvaluator evaluator(expr);
    const bool may_turn = turns(expr, expr.root());
    for (std::size_t i = 0; i < cells_a_batch; ++i) {
        const std::string reason = disproved_of_cell(evaluator, cells, answers, i, may_turn, tally);
        if (!reason.empty()) return described(cells, i, reason);
    }
    return "";
}

template <class Real>
void check_forms(MakeKernel make, int depth, int batches, RandomNumbers& random,
                 InclusionTally& tally) {
    const Expr expr = random_expression(random, depth);
    tally.note_operators(expr);
    const Kernel kernel = make(expr);
    for (int batch = 0; batch < batches; ++batch) {
        const auto cells = random_cells<Real>(random);
        tally.note(disproved(kernel, expr, cells, tally), [&] {
            return shrunk_failure(make, expr, cells) + "made of " + expr.canonical();
        });
    }
}

template std::string disproved(const Kernel&, const Expr&, const FormCells<float>&,
                               InclusionTally&);
template std::string disproved(const Kernel&, const Expr&, const FormCells<double>&,
                               InclusionTally&);
template void check_forms<float>(MakeKernel, int, int, RandomNumbers&, InclusionTally&);
template void check_forms<double>(MakeKernel, int, int, RandomNumbers&, InclusionTally&);

}  // namespace zeroset::test
