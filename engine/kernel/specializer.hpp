#pragma once

#include "engine/kernel/batches.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace zeroset {

/// A choice (min, max, if, where) in a block of cells, a bit for each cell: the first alternative
/// surely may stand for the choice, or the second, in the whole cell: it is its value,
/// or does the same to signs and zeros of f; and the choice is defined wherever it is.
struct ChoiceBits {
    std::uint16_t first = 0;
    std::uint16_t second = 0;
};

/// The choices of a formula as they fall in the cells of a batch.
struct ChoiceRecord {
    std::size_t lanes = 1;         ///< cells a block
    std::size_t choices = 0;       ///< of the formula
    std::vector<ChoiceBits> bits;  ///< of each block, of each choice
};

struct Kernel;
class UnionParts;

/// Makes kernels that leave out what does not matter in a part of space, as other parts of a union
/// [Keeter20]. Thread-safe; called in upward rounding.
class Specializer {
public:
    virtual ~Specializer() = default;

    /// Does the work of Kernel::form, of a function with f's signs and zeros, and records how the
    /// choices fall.
    virtual void form(const FormBatchOf<float>& batch, ChoiceRecord& record) const = 0;
    virtual void form(const FormBatchOf<double>& batch, ChoiceRecord& record) const = 0;
    /// A kernel for the points of these cells of the recorded batch: there its function is defined
    /// where the whole one is, with the same signs and zeros, and beside the zeros the same one.
    /// nullptr where it would not be shorter. Without the names of parameters. Copies must not
    /// outlive the shared_ptr.
    [[nodiscard]] virtual std::shared_ptr<const Kernel> specialized(
        const ChoiceRecord& record, std::span<const std::size_t> cells) const = 0;
    /// The functions of which the whole one is the least; nullptr where it is not known as that.
    [[nodiscard]] virtual const UnionParts* union_parts() const { return nullptr; }
};

}  // namespace zeroset
