#pragma once

#include "engine/tape/tape.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace zeroset {

/// The steps that a tape comes to where its choices fall in a known way. One at a time lives on
/// each thread.
class TapeReduction {
public:
    using Index = Tape::Index;
    using Step = Tape::Step;

    TapeReduction(const Tape& tape, const ChoiceRecord& record, std::span<const std::size_t> cells);

    /// For each step, the one whose value may be taken instead.
    [[nodiscard]] std::span<const Index> stands_for() const { return stands_for_; }
    /// For each step, its place among the graph's switches, with that of a condition whose place it
    /// takes.
    [[nodiscard]] std::span<const SwitchIndex> switches() const { return switches_; }
    [[nodiscard]] bool any() const { return any_; }

private:
    void reduce(Index i, const ChoiceRecord& record, std::span<const std::size_t> cells);
    /// The operand that the step's value is.
    [[nodiscard]] std::optional<Index> same_as(const Step& step, const ChoiceRecord& record,
                                               std::span<const std::size_t> cells) const;
    /// The other operand of a sum with 0.
    [[nodiscard]] std::optional<Index> summand(const Step& step) const;
    [[nodiscard]] bool is_zero(const Step& step) const;

    const Tape& tape_;
    std::vector<Index>& stands_for_;
    std::vector<SwitchIndex>& switches_;
    std::vector<std::uint8_t>& zero_;   ///< whether the value is the number 0
    std::optional<Index> number_zero_;  ///< a constant
    bool any_ = false;
};

}  // namespace zeroset
