#pragma once

#include "engine/antialias/edge_fit.hpp"
#include "engine/antialias/sample_drafts.hpp"
#include "engine/antialias/square_field.hpp"

#include <cstddef>
#include <vector>

namespace zeroset {

/// Squares all of whose rays have a root, to be shown by the sheets that these make up.
class SquareCreases {
public:
    SquareCreases(const TraceFrame& frame, SquareField& field, SampleDrafts& drafts,
                  Counters& counters)
        : frame_(frame), field_(field), drafts_(drafts), counters_(counters) {}

    /// A square that is covered between the ends of the front.
    void add(std::size_t square, const Front& front);
    /// A square of which this is known of its rays.
    void add(std::size_t square, SquareStretches stretches, const EdgeSamples& samples);
    /// Decides the squares that were added, or divides them.
    void decide();

private:
    struct Task {
        std::size_t square;
        bool is_covered;  ///< not only the rays: all of it
    };
    /// Whether the sheets through the roots are clear.
    bool show(const Task& task, SquareRoots roots);

    const TraceFrame& frame_;
    SquareField& field_;
    SampleDrafts& drafts_;
    Counters& counters_;
    std::vector<Task> tasks_;
    std::vector<RayRoot> roots_;  ///< of each task those of its square's rays
};

}  // namespace zeroset
