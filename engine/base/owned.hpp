#pragma once

#include <cstdlib>
#include <memory>

namespace zeroset {

/// Memory that a C library gave and that has to be freed.
template <class Value>
using Owned = std::unique_ptr<Value, decltype(&std::free)>;

template <class Value>
Owned<Value> owned(Value* value) {
    return Owned<Value>(value, &std::free);
}

}  // namespace zeroset
