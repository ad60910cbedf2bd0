#include "engine/expr/drawn_form.hpp"

#include "engine/expr/clear_poles.hpp"
#include "engine/expr/polar_form.hpp"
#include "engine/expr/tighten.hpp"

namespace zeroset {

Expr drawn_form(const Expr& expr, const SampleRegion& region) {
    return polar_form(tightened(without_poles(plain_angles(expr), region), region));
}

}  // namespace zeroset
