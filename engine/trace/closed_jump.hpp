#pragma once

namespace zeroset {

/// Whether |f| falls towards 0 on the way to a jump: it is `far` at one place and `near` at another
/// that is half as far from the jump or nearer. Where it does so on both sides, from either sign,
/// the jump is closed: f is 0 there as far as numbers tell.
template <class Real>
bool falls_to_zero(Real near, Real far) {
    constexpr Real most = static_cast<Real>(0.75);  // half, if it falls evenly
    return near <= most * far;
}

}  // namespace zeroset
