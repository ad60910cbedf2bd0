#pragma once

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

// Types for suites that run over both number types of kernels.

namespace zeroset::test {

using RealTypes = ::testing::Types<float, double>;

struct RealTypeNames {
    template <class Real>
    static std::string GetName(int /*index*/) {
        return std::is_same_v<Real, float> ? "Float" : "Double";
    }
};

}  // namespace zeroset::test
