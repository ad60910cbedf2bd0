#pragma once

#include "engine/interpret/interpret.hpp"
#include "engine/kernel/csg_parts.hpp"
#include "engine/rewrite/choice_tree.hpp"

#include <vector>

namespace zeroset::test {

/// Tells the kernel of an expression of its parts, by interpreters.
inline void set_interpreted_parts(Kernel& kernel, const Expr& expr) {
    constexpr std::size_t most = 64;
    kernel.memory->of<CsgParts>()->set([expr] {
        std::vector<Kernel> kernels;
        const ChoiceTree tree = choice_tree(expr, most);
        for (const Expr& part : tree.functions)
            kernels.push_back(interpret(part));
        if (kernels.size() < 2) kernels.clear();
        return kernels;
    });
}

}  // namespace zeroset::test
