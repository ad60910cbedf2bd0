// Linked into tests of papers' tracers: the program's own have been tested by the engine's.

#include "engine/render/tracers.hpp"
#include "papers/tracers/paper_tracers.hpp"
#include "tests/support/rays.hpp"

namespace zeroset::test {
namespace {

[[maybe_unused]] const bool are_added = [] {
    first_tested_tracer() = tracers().size();
    add_paper_tracers();
    return true;
}();

}  // namespace
}  // namespace zeroset::test
