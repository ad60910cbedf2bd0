#pragma once

// Vectors and matrices of two rows, and balls of real numbers, over a carrier; what is computed
// with them stands in balls-inl.hpp.

namespace zeroset {

template <class Real>
struct Vector2 {
    Real p, q;
};

/// Row p: (pp, pq); row q: (qp, qq).
template <class Real>
struct Matrix2 {
    Real pp, pq, qp, qq;
};

/// All real numbers within `radius` of `middle`.
template <class Real>
struct RealBall {
    Real middle, radius;
};

}  // namespace zeroset
