// Linked into tests of all tracers, those of papers among them.

#include "papers/tracers/paper_tracers.hpp"

namespace zeroset::test {
namespace {

[[maybe_unused]] const bool are_added = (add_paper_tracers(), true);

}  // namespace
}  // namespace zeroset::test
