#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>

// The functions of library.def in plain arithmetic, written out step by step as their documentation
// describes them: polynomials by their terms, cells by their cases, patterns by their waves.

namespace zeroset::test {

/// A point and the parameters that follow it in a call.
struct Arguments {
    double x, y, z;
    std::array<double, 10> p;
};
using FunctionReference = std::function<double(Arguments)>;
using References = std::map<std::string, FunctionReference>;

/// The references by the names of the functions.
References library_references();
/// The references of the functions that are noise.
References noise_references();

}  // namespace zeroset::test
