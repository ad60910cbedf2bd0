#pragma once

#include "engine/expr/expr.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// A function as the greatest and the least of others, which have no kinks where it has them:
/// max(a, b) + c, |a| and so on are taken apart.
struct ChoiceTree {
    enum class Kind : std::uint8_t { Leaf, Max, Min };
    struct Node {
        Kind kind = Kind::Leaf;
        std::uint32_t a = 0, b = 0;  ///< nodes before this one; of a leaf, `a` is its function
    };
    std::vector<Node> nodes;  ///< the last is the root
    std::vector<Expr> functions;
};

/// Takes a function apart into at most `most_functions`; a leaf alone where that is not enough.
ChoiceTree choice_tree(const Expr& expr, std::size_t most_functions);

}  // namespace zeroset
