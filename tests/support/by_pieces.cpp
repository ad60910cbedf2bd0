#include "tests/support/by_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace zeroset::test {
namespace {

constexpr std::size_t lanes = batch_multiple;
constexpr int most_switches = 4;

template <class Real>
using Column = std::array<Real, lanes>;
template <class Real>
using Words = std::vector<ContinuityMask<Real>>;

/// Fills all lanes of a column with one item: each box or cell is evaluated alone.
template <class Number>
void fill(const Number* from, std::size_t item, Column<Number>& column) {
    column.fill(from[item]);
}

/// The held words of one item, for all lanes of a batch.
template <class Real>
struct HeldColumns {
    std::vector<ContinuityMask<Real>> words;

    explicit HeldColumns(const Words<Real>& of_item) : words(of_item.size() * lanes) {
        for (std::size_t w = 0; w < of_item.size(); ++w)
            std::fill_n(words.begin() + static_cast<std::ptrdiff_t>(w * lanes), lanes, of_item[w]);
    }
    [[nodiscard]] HeldSwitches<Real> held() const { return {words.data(), lanes}; }
};

/// Calls `leaf()` for each piece; `ask(held)` evaluates one and returns its open switches.
template <class Real>
void visit(Words<Real> words, int depth, const auto& ask, const auto& leaf) {
    using Word = ContinuityMask<Real>;
    const HeldColumns<Real> columns(words);
    const BranchBits open = ask(columns.held());
    const std::size_t word = open.open_switch() / switches_a_word<Real>;
    const std::size_t shift = held_bits * (open.open_switch() % switches_a_word<Real>);
    constexpr Word codes = (Word{1} << held_bits) - 1;
    const bool divides =
        open.outcomes() > 0 && depth < most_switches && (words[word] >> shift & codes) == 0;
    if (!divides) return leaf();
    for (unsigned outcome = 0; outcome < open.outcomes(); ++outcome) {
        Words<Real> piece = words;
        piece[word] |= static_cast<Word>(held_code(outcome, open.outcomes())) << shift;
        visit<Real>(piece, depth + 1, ask, leaf);
    }
}

template <class Real>
Words<Real> nothing_held(const Kernel& kernel) {
    return Words<Real>(kernel.switches / switches_a_word<Real> + 1, 0);
}

template <class Real>
void range_by_pieces(const void* code, const RangeBatchOf<Real>* batch) {
    const auto& kernel = *static_cast<const Kernel*>(code);
    for (std::size_t i = 0; i < batch->size; ++i) {
        std::array<Column<Real>, 3> neg_lo;
        std::array<Column<Real>, 3> hi;
        for (std::size_t k = 0; k < 3; ++k) {
            fill(batch->neg_lo[k], i, neg_lo[k]);
            fill(batch->hi[k], i, hi[k]);
        }
        Column<Real> f_neg_lo;
        Column<Real> f_hi;
        Column<ContinuityMask<Real>> continuous;
        Column<ContinuityMask<Real>> branches{};  // not written by a kernel without branches
        RangeBatchOf<Real> one{.size = lanes,
                               .neg_lo = {neg_lo[0].data(), neg_lo[1].data(), neg_lo[2].data()},
                               .hi = {hi[0].data(), hi[1].data(), hi[2].data()},
                               .uniforms = batch->uniforms,
                               .f_neg_lo = f_neg_lo.data(),
                               .f_hi = f_hi.data(),
                               .continuous = continuous.data(),
                               .held = {},
                               .branches = branches.data()};
        const auto ask = [&](const HeldSwitches<Real>& held) {
            one.held = held;
            kernel.range(one);
            return BranchBits{static_cast<std::uint32_t>(branches[0])};
        };
        ask({});
        batch->continuous[i] = continuous[0];
        constexpr Real none = -std::numeric_limits<Real>::infinity();
        batch->f_neg_lo[i] = batch->f_hi[i] = none;
        const auto leaf = [&] {
            const bool two_parts = f_neg_lo[0] < 0 && f_hi[0] < 0 && f_hi[0] != none;
            const bool unknown = two_parts || std::isnan(f_neg_lo[0]) || std::isnan(f_hi[0]);
            const Real all = std::numeric_limits<Real>::infinity();
            batch->f_neg_lo[i] = std::max(batch->f_neg_lo[i], unknown ? all : f_neg_lo[0]);
            batch->f_hi[i] = std::max(batch->f_hi[i], unknown ? all : f_hi[0]);
        };
        visit<Real>(nothing_held<Real>(kernel), 0, ask, leaf);
    }
}

/// The answer of a form kernel for one cell.
template <class Real>
struct OneForm {
    Column<Real> c, e, r, slope_neg_lo, slope_hi;
    std::array<Column<Real>, 3> k;
    Column<ContinuityMask<Real>> continuous, nowhere;
    Column<ContinuityMask<Real>> branches{};  ///< not written by a kernel without branches

    /// Writes the answer as cell i of a batch.
    void store(const FormBatchOf<Real>& batch, std::size_t i) const {
        batch.c[i] = c[0];
        batch.e[i] = e[0];
        batch.r[i] = r[0];
        batch.slope_neg_lo[i] = slope_neg_lo[0];
        batch.slope_hi[i] = slope_hi[0];
        for (std::size_t axis = 0; axis < 3; ++axis)
            batch.k[axis][i] = k[axis][0];
        batch.continuous[i] = continuous[0];
        batch.nowhere[i] = nowhere[0];
    }
    [[nodiscard]] Real spread() const {
        return std::abs(k[0][0]) + std::abs(k[1][0]) + std::abs(k[2][0]) + e[0];
    }
};

template <class Real>
void form_by_pieces(const void* code, const FormBatchOf<Real>* batch) {
    const auto& kernel = *static_cast<const Kernel*>(code);
    for (std::size_t i = 0; i < batch->size; ++i) {
        Column<Real> u;
        Column<Real> v;
        Column<Real> s;
        Column<Real> s_radius;
        fill(batch->u, i, u);
        fill(batch->v, i, v);
        fill(batch->s, i, s);
        fill(batch->s_radius, i, s_radius);
        OneForm<Real> form;
        FormBatchOf<Real> one{.size = lanes,
                              .u = u.data(),
                              .v = v.data(),
                              .s = s.data(),
                              .s_radius = s_radius.data(),
                              .frustum = batch->frustum,
                              .uniforms = batch->uniforms,
                              .c = form.c.data(),
                              .k = {form.k[0].data(), form.k[1].data(), form.k[2].data()},
                              .e = form.e.data(),
                              .r = form.r.data(),
                              .slope_neg_lo = form.slope_neg_lo.data(),
                              .slope_hi = form.slope_hi.data(),
                              .continuous = form.continuous.data(),
                              .nowhere = form.nowhere.data(),
                              .held = {},
                              .branches = form.branches.data()};
        const auto ask = [&](const HeldSwitches<Real>& held) {
            one.held = held;
            kernel.form(one);
            return BranchBits{static_cast<std::uint32_t>(form.branches[0])};
        };
        const bool open = ask({}).outcomes() > 0;
        form.store(*batch, i);
        if (!open) continue;
        Real neg_lo = -std::numeric_limits<Real>::infinity();
        Real hi = neg_lo;
        const auto leaf = [&] {
            if (form.nowhere[0] != 0) return;
            neg_lo = std::max(neg_lo, form.spread() - form.c[0]);
            hi = std::max(hi, form.spread() + form.c[0]);
        };
        visit<Real>(nothing_held<Real>(kernel), 0, ask, leaf);
        const bool any = hi > -std::numeric_limits<Real>::infinity();
        batch->nowhere[i] = any ? 0 : static_cast<ContinuityMask<Real>>(-1);
        batch->c[i] = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            batch->k[axis][i] = 0;
        batch->e[i] = any ? std::max(neg_lo, hi) : 0;
    }
}

}  // namespace

Kernel by_pieces(const Kernel& kernel) {
    const auto whole = std::make_shared<const Kernel>(kernel);
    Kernel result = kernel;
    result.in_float.range = {range_by_pieces<float>, whole};
    result.in_double.range = {range_by_pieces<double>, whole};
    result.in_float.form = {form_by_pieces<float>, whole};
    result.in_double.form = {form_by_pieces<double>, whole};
    return result;
}

}  // namespace zeroset::test
