// Sums, products and functions of models of several boxes, a box in each lane. In upward rounding.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_MODEL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_MODEL_INL
#undef ZEROSET_MODEL_INL
#else
#define ZEROSET_MODEL_INL
#endif

#include "engine/kernel/patch_model.hpp"
#include "engine/real/lanes-inl.hpp"
#include "engine/taylor/series.hpp"

#include <hwy/highway.h>

#include <array>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// More than what rounding may take from the terms of a sum or a product, relative to the sums of
/// their sizes: no term is a sum of more than 20 products.
constexpr double sum_rounding = 0x1p-51;
constexpr double product_rounding = 0x1p-46;
/// More than what is lost below the smallest numbers.
constexpr double underflow = 0x1p-1000;

/// A function of (p, q): within `error` of the polynomial; NaN or +inf: not known.
struct Model {
    V<double> terms[patch_terms];
    V<double> error;
};

/// Sums of the sizes of the terms of each degree.
struct Sizes {
    V<double> of[patch_degree + 1];

    [[nodiscard]] HWY_INLINE V<double> sum(int from) const {
        V<double> sum = number(0.0);
        for (int k = from; k <= patch_degree; ++k)
            sum = hn::Add(sum, of[k]);
        return sum;
    }
};

HWY_INLINE Sizes sizes_of(const Model& a) {
    Sizes sizes;
    for (int k = 0; k <= patch_degree; ++k) {
        sizes.of[k] = number(0.0);
        for (int j = 0; j <= k; ++j)
            sizes.of[k] = hn::Add(sizes.of[k], hn::Abs(a.terms[patch_term(k - j, j)]));
    }
    return sizes;
}

/// The number `middle`, give or take `radius`.
inline Model constant_model(V<double> middle, V<double> radius) {
    Model model;
    for (V<double>& term : model.terms)
        term = number(0.0);
    model.terms[0] = middle;
    model.error = radius;
    return model;
}

inline Model unknown_model() {
    return constant_model(number(0.0), number(std::numeric_limits<double>::infinity()));
}

inline Model negated(const Model& a) {
    Model model;
    for (std::size_t i = 0; i < patch_terms; ++i)
        model.terms[i] = hn::Neg(a.terms[i]);
    model.error = a.error;
    return model;
}

inline Model sum_of(const Model& a, const Model& b) {
    Model model;
    V<double> size = number(0.0);
    for (std::size_t i = 0; i < patch_terms; ++i) {
        model.terms[i] = hn::Add(a.terms[i], b.terms[i]);
        size = hn::Add(size, hn::Abs(model.terms[i]));
    }
    model.error = hn::MulAdd(size, number(sum_rounding),
                             hn::Add(a.error, hn::Add(b.error, number(underflow))));
    return model;
}

/// a times the number `middle`, give or take `radius`.
inline Model scaled(const Model& a, V<double> middle, V<double> radius) {
    Model model;
    for (std::size_t i = 0; i < patch_terms; ++i)
        model.terms[i] = hn::Mul(a.terms[i], middle);
    const V<double> size = sizes_of(a).sum(0);
    const V<double> most = hn::Add(hn::Abs(middle), radius);
    V<double> error = hn::MulAdd(most, a.error, number(underflow));
    error = hn::MulAdd(size, radius, error);
    model.error = hn::MulAdd(hn::Mul(size, hn::Abs(middle)), number(sum_rounding), error);
    return model;
}

inline Model product_of(const Model& a, const Model& b) {
    Model model;
    for (V<double>& term : model.terms)
        term = number(0.0);
    for (int m = 0; m <= patch_degree; ++m) {
        for (int n = 0; m + n <= patch_degree; ++n) {
            for (int i = 0; i <= m; ++i) {
                for (int j = 0; j <= n; ++j) {
                    V<double>& term = model.terms[patch_term(m - i + n - j, i + j)];
                    term = hn::MulAdd(a.terms[patch_term(m - i, i)], b.terms[patch_term(n - j, j)],
                                      term);
                }
            }
        }
    }
    // The product's error: terms beyond the degree, the errors of the factors, and rounding.
    const Sizes a_sizes = sizes_of(a);
    const Sizes b_sizes = sizes_of(b);
    V<double> error = number(underflow);
    for (int m = 1; m <= patch_degree; ++m)
        error = hn::MulAdd(a_sizes.of[m], b_sizes.sum(patch_degree + 1 - m), error);
    const V<double> a_size = a_sizes.sum(0);
    const V<double> b_size = b_sizes.sum(0);
    error = hn::MulAdd(a_size, b.error, error);
    error = hn::MulAdd(b_size, a.error, error);
    error = hn::MulAdd(a.error, b.error, error);
    model.error = hn::MulAdd(hn::Mul(a_size, b_size), number(product_rounding), error);
    return model;
}

/// The function with this series in each lane, of a; `series(lane, c, reach)` makes it.
template <class MakeSeries>
Model composed(const Model& a, MakeSeries make_series) {
    const V<double> reach = hn::Add(sizes_of(a).sum(1), a.error);
    HWY_ALIGN double c[lanes<double>];
    HWY_ALIGN double reaches[lanes<double>];
    HWY_ALIGN double terms[patch_degree + 1][lanes<double>];
    HWY_ALIGN double errors[lanes<double>];
    hn::Store(a.terms[0], d<double>, c);
    hn::Store(reach, d<double>, reaches);
    for (std::size_t lane = 0; lane < lanes<double>; ++lane) {
        const Series series = make_series(c[lane], reaches[lane]);
        for (std::size_t k = 0; k <= patch_degree; ++k)
            terms[k][lane] = series.term[k];
        errors[lane] = series.error;
    }
    Model offset = a;
    offset.terms[0] = number(0.0);
    Model model = constant_model(hn::Load(d<double>, terms[patch_degree]), number(0.0));
    for (int k = patch_degree - 1; k >= 0; --k) {
        model = product_of(model, offset);
        const V<double> sum = hn::Add(model.terms[0], hn::Load(d<double>, terms[k]));
        model.terms[0] = sum;
        model.error = hn::MulAdd(hn::Abs(sum), number(sum_rounding), model.error);
    }
    model.error = hn::Add(model.error, hn::Load(d<double>, errors));
    return model;
}

/// The lanes' numbers where `condition` holds, else those of b.
inline Model chosen(M<double> condition, const Model& a, const Model& b) {
    Model model;
    for (std::size_t i = 0; i < patch_terms; ++i)
        model.terms[i] = hn::IfThenElse(condition, a.terms[i], b.terms[i]);
    model.error = hn::IfThenElse(condition, a.error, b.error);
    return model;
}

/// Where a is surely above 0.
HWY_INLINE M<double> is_positive(const Model& a) {
    return hn::Gt(a.terms[0], hn::Add(sizes_of(a).sum(1), a.error));
}

/// |a| where its sign is known.
inline Model size_of(const Model& a) {
    const Model opposite = negated(a);
    return chosen(is_positive(a), a, chosen(is_positive(opposite), opposite, unknown_model()));
}

/// The larger one of a and b where one of them surely is.
inline Model larger_of(const Model& a, const Model& b) {
    const Model difference = sum_of(a, negated(b));
    return chosen(is_positive(difference), a,
                  chosen(is_positive(negated(difference)), b, unknown_model()));
}

inline Model power_of(const Model& a, int n) {
    if (n == 1) return a;
    const Model half = power_of(product_of(a, a), n / 2);
    return n % 2 == 0 ? half : product_of(half, a);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
