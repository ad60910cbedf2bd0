#pragma once

#include "engine/num/enclosure.hpp"
#include "engine/real/field.hpp"

namespace zeroset {

/// The enclosure that a field's answer over a box tells.
template <class Question, class Answers>
auto field_enclosure(const Field& field, int derivative, const Answers& out) {
    using Real = typename Answers::value_type;
    const Real half = like(out[Question::range], 0.5);
    Enclosure<Real> g{.range = {out[Question::range], out[Question::range + 1]}};
    if (derivative != 0 || !field.is_total()) {
        g.somewhere = out[Question::somewhere] > half;
        g.everywhere = out[Question::everywhere] > half;
    }
    if (derivative != 0 || !field.is_continuous()) g.continuous = out[Question::continuous] > half;
    return g;
}

}  // namespace zeroset
