#pragma once

#include "engine/algebra/facts.hpp"

namespace zeroset {

/// A computed operand with what is known of its node.
template <class Value>
struct Operand {
    const Value& value;
    const Facts& facts;
};

}  // namespace zeroset
