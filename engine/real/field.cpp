#include "engine/real/field.hpp"

#include <atomic>

namespace zeroset {
namespace {

std::uint64_t next_id() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

}  // namespace

Field::Field() : id_(next_id()) {}

}  // namespace zeroset
