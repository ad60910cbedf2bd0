#pragma once

#include <memory>

namespace zeroset {

/// A pointer that keeps nothing alive, and costs nothing to copy.
template <class Object>
std::shared_ptr<const Object> unowned(const Object& object) {
    return {std::shared_ptr<const Object>(), &object};
}

}  // namespace zeroset
