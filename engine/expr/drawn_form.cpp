#include "engine/expr/drawn_form.hpp"

#include "engine/expr/clear_poles.hpp"
#include "engine/expr/plain_angles.hpp"
#include "engine/expr/tighten.hpp"

namespace zeroset {

Expr drawn_form(const Expr& expr, const SampleRegion& region) {
    return tightened(without_poles(plain_angles(expr), region), region);
}

}  // namespace zeroset
