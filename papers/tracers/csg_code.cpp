#include "papers/tracers/csg_code.hpp"

#include "engine/expr/patch_graph.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/rewrite/choice_tree.hpp"
#include "jit/compile.hpp"
#include "papers/along_rays/csg_parts.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// Parts are searched one by one on each ray, so many of them never pay.
constexpr std::size_t most_parts = 64;

Kernel part_code(const Expr& part, bool has_double, bool by_machine_code) {
    if (by_machine_code) {
        if (auto code = jit::compile(part, {.with_double = has_double})) return std::move(*code);
    }
    Kernel kernel = interpret(part);
    kernel.has_double = has_double;
    return kernel;
}

}  // namespace

void read_csg_parts(const Kernel& kernel, const Expr& surface, bool by_machine_code) {
    if (is_patch(surface)) return;
    const bool has_double = kernel.has_double;
    kernel.memory->of<CsgParts>()->set([surface, has_double, by_machine_code] {
        std::vector<Kernel> kernels;
        const ChoiceTree tree = choice_tree(surface, most_parts);
        if (tree.functions.size() < 2) return kernels;
        for (const Expr& part : tree.functions)
            kernels.push_back(part_code(part, has_double, by_machine_code));
        return kernels;
    });
}

}  // namespace zeroset
