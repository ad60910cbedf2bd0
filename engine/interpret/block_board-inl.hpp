// The lanes of a batch, as blocks, and what the algebra of a block asks and tells about switches.
// Included by the interpreter's loops.

#pragma once

#include "engine/algebra/switches.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/real/block.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <optional>

namespace zeroset {
namespace {

template <class Lanes, class Real>
Lanes load(const Real* lanes) {
    Lanes block;
    std::memcpy(&block, lanes, sizeof block);
    return block;
}
template <class Real, std::size_t bytes>
void store(Real* lanes, const Block<Real, bytes>& block) {
    std::memcpy(lanes, &block, sizeof block);
}

/// All ones where the mask holds.
template <class Real>
void store(ContinuityMask<Real>* items, const std::optional<BlockMask>& mask, bool if_absent) {
    const unsigned bits = mask ? mask->bits : (if_absent ? ~0U : 0U);
    const auto all_ones = static_cast<ContinuityMask<Real>>(-1);
    for (std::size_t lane = 0; lane < Block<Real>::lanes; ++lane)
        items[lane] = (bits >> lane & 1U) != 0 ? all_ones : 0U;
}

/// Answers what the algebra of a block asks about switches, and notes what it tells: from and to
/// the batch's arrays.
template <class Real, std::size_t bytes>
class BlockBoard final : public SwitchBoard<Block<Real, bytes>> {
public:
    using Word = ContinuityMask<Real>;
    using Lanes = Block<Real, bytes>;

    BlockBoard(const HeldSwitches<Real>& held, Word* branches, Real* cut_from = nullptr,
               Real* cut_to = nullptr)
        : held_(held), branches_(branches), cut_from_(cut_from), cut_to_(cut_to) {}

    /// The block that begins with this item.
    void begin(std::size_t item) {
        item_ = item;
        bits_.fill(0);
        cut_ = {Lanes::splat(std::numeric_limits<Real>::infinity()),
                Lanes::splat(-std::numeric_limits<Real>::infinity())};
    }
    void end() const {
        if (branches_ != nullptr) std::ranges::copy(bits_, branches_ + item_);
        if (cut_from_ == nullptr) return;
        store(cut_from_ + item_, cut_.from);
        store(cut_to_ + item_, cut_.to);
    }
    std::optional<HeldAt<Block<Real, bytes>>> held(SwitchIndex index) override;
    void report(SwitchIndex index, const BlockMask& two, const BlockMask& three) override;
    void report_kink(const BlockMask& may_be) override {
        for (std::size_t lane = 0; lane < lanes; ++lane)
            bits_[lane] |= may_be.bits >> lane & BranchBits::kink;
    }
    [[nodiscard]] bool wants_cuts() const override { return cut_from_ != nullptr; }
    void report_cut(const BlockMask& open, const Lanes& at, const Lanes& aside) override {
        cut_ = first_cut(cut_, open, at, aside);
    }

private:
    static constexpr std::size_t lanes = Block<Real>::lanes;

    HeldSwitches<Real> held_;
    Word* branches_;
    Real* cut_from_;
    Real* cut_to_;
    Cut<Lanes> cut_;
    std::size_t item_ = 0;
    std::array<Word, lanes> bits_{};
};

template <class Real, std::size_t bytes>
std::optional<HeldAt<Block<Real, bytes>>> BlockBoard<Real, bytes>::held(SwitchIndex index) {
    if (held_.words == nullptr) return std::nullopt;
    const Word* const words = held_.words + index / switches_a_word<Real> * held_.stride + item_;
    const std::size_t shift = held_bits * (index % switches_a_word<Real>);
    std::array<unsigned, 1U << held_bits> at{};
    for (std::size_t lane = 0; lane < lanes; ++lane)
        at[words[lane] >> shift & (at.size() - 1)] |= 1U << lane;
    const auto mask = [&](unsigned lanes_of_code) {
        return BlockMask{static_cast<std::uint16_t>(lanes_of_code)};
    };
    const auto number = [](double value) { return like(Block<Real, bytes>(), value); };
    const unsigned second = at[held_code(1, 2)] | at[held_code(1, 3)];
    const unsigned third = at[held_code(2, 3)];
    return HeldAt<Block<Real, bytes>>{
        mask(at[held_code(0, 2)] | at[held_code(1, 2)]),
        mask(at[held_code(0, 3)] | at[held_code(1, 3)] | third),
        select(mask(third), number(2), select(mask(second), number(1), number(0)))};
}

template <class Real, std::size_t bytes>
void BlockBoard<Real, bytes>::report(SwitchIndex index, const BlockMask& two,
                                     const BlockMask& three) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const unsigned more = (two.bits >> lane & 1U) + 2 * (three.bits >> lane & 1U);
        const bool first = BranchBits{static_cast<std::uint32_t>(bits_[lane])}.outcomes() == 0;
        if (more == 0 || !first) continue;
        bits_[lane] |= static_cast<Word>(more) << BranchBits::more_outcomes_shift |
                       static_cast<Word>(index) << BranchBits::switch_shift;
    }
}

}  // namespace
}  // namespace zeroset
