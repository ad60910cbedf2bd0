#pragma once

#include "engine/tape/parts.hpp"
#include "engine/tape/skeleton.hpp"

#include <cstddef>
#include <list>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace zeroset {

/// The shapes of the graphs seen lately: of each the first graph, and in which constants others
/// differed from it. Thread-safe.
class ShapeMemory {
public:
    /// Takes note of the graphs; of each its shape and its values for that, or nothing where all
    /// graphs of its shape have been equal so far.
    std::vector<std::optional<ShapedGraph>> shape(std::span<const Expr> graphs);

private:
    static constexpr std::size_t most_shapes = 64;

    struct Known {
        std::string key;
        Skeleton first;
        VaryingPlaces varying;
    };
    /// The skeleton's shape, from now on the newest.
    Known& note(const Skeleton& skeleton);

    std::mutex mutex_;
    std::list<Known> known_;  ///< the newest first
};

}  // namespace zeroset
