#include "engine/kernel/surface_facts.hpp"

namespace zeroset {

const SurfaceFacts& surface_facts(const Kernel& kernel) {
    static const SurfaceFacts nothing;
    return kernel.facts == nullptr ? nothing : *kernel.facts;
}

}  // namespace zeroset
