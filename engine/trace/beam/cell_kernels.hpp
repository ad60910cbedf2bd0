#pragma once

#include "engine/kernel/kernel.hpp"

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
    ChoiceRecord record;  ///< of these cells, if the kernel has a specializer
};

/// The runs of a list, in order. Keeps their memory from list to list.
class CellRuns {
public:
    void clear() { count_ = 0; }
    /// Cells from `first` on, the end of the list so far, are of this kernel.
    void begin(const Kernel* kernel, std::size_t first) {
        if (count_ > 0 && runs_[count_ - 1].kernel == kernel) return;
        if (count_ == 0 || runs_[count_ - 1].first < first) ++count_;
        if (count_ > runs_.size()) runs_.emplace_back();
        runs_[count_ - 1].first = first;
        runs_[count_ - 1].kernel = kernel;
    }
    /// The list has this many cells.
    void end(std::size_t size) {
        if (count_ > 0 && runs_[count_ - 1].first == size) --count_;
        for (std::size_t i = 0; i < count_; ++i)
            runs_[i].count = (i + 1 < count_ ? runs_[i + 1].first : size) - runs_[i].first;
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
    const Kernel* specialized(const CellRun& run, std::span<const std::size_t> cells) {
        if (run.kernel->specializer == nullptr) return run.kernel;
        in_run_.assign(cells.begin(), cells.end());
        for (std::size_t& cell : in_run_)
            cell -= run.first;
        auto kernel = run.kernel->specializer->specialized(run.record, in_run_);
        if (!kernel) return run.kernel;
        return kernels_.emplace_back(std::move(kernel)).get();
    }

private:
    std::vector<std::shared_ptr<const Kernel>> kernels_;
    std::vector<std::size_t> in_run_;
};

}  // namespace zeroset
