#pragma once

#include "engine/expr/kernel.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace zeroset {

/// Cells of a list, one behind the other, that the same kernel evaluates.
struct CellRun {
    std::size_t first = 0;
    std::size_t count = 0;
    const Kernel* kernel = nullptr;
    ChoiceRecord record;  ///< of these cells, if the kernel has a shortener
};

/// What is kept of runs from list to list.
class CellRuns {
public:
    /// Divides a list of cells by their kernels.
    void divide(std::span<const Kernel* const> kernels) {
        count_ = 0;
        for (std::size_t first = 0; first < kernels.size();) {
            std::size_t last = first + 1;
            while (last < kernels.size() && kernels[last] == kernels[first])
                ++last;
            if (count_ == runs_.size()) runs_.emplace_back();
            CellRun& run = runs_[count_++];
            run.first = first;
            run.count = last - first;
            run.kernel = kernels[first];
            first = last;
        }
    }
    [[nodiscard]] std::span<CellRun> all() { return std::span(runs_).first(count_); }

private:
    std::vector<CellRun> runs_;
    std::size_t count_ = 0;
};

/// Kernels made for parts of a tile, kept while it is traced.
class CellKernels {
public:
    void clear() { kernels_.clear(); }

    /// The kernel for these cells of the run's list; the run's own where none is shorter.
    const Kernel* shortened(const CellRun& run, std::span<const std::size_t> cells) {
        if (run.kernel->shortener == nullptr) return run.kernel;
        in_run_.assign(cells.begin(), cells.end());
        for (std::size_t& cell : in_run_)
            cell -= run.first;
        auto kernel = run.kernel->shortener->shortened(run.record, in_run_);
        if (!kernel) return run.kernel;
        return kernels_.emplace_back(std::move(kernel)).get();
    }

private:
    std::vector<std::shared_ptr<const Kernel>> kernels_;
    std::vector<std::size_t> in_run_;
};

}  // namespace zeroset
