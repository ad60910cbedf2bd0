#include "jit/llvm/switch_lanes.hpp"

#include <limits>

namespace zeroset::jit {

std::optional<HeldAt<Lanes>> SwitchLanes::held(SwitchIndex index) {
    llvm::IRBuilder<>& builder = function_.builder();
    // Load the word that holds the switch, once for each word.
    llvm::Value*& word = loaded_[index / per_word()];
    if (word == nullptr) {
        llvm::Value* const column =
            builder.CreateMul(stride_, builder.getInt64(index / per_word()));
        word = function_.load_integers(words_, column);
    }
    // Take the switch's code from it, and tell the outcome that is held.
    llvm::Value* const shifted = builder.CreateLShr(word, number(held_bits * (index % per_word())));
    llvm::Value* const code = builder.CreateAnd(shifted, number((1U << held_bits) - 1));
    const auto is = [&](unsigned outcome, unsigned outcomes) {
        return builder.CreateICmpEQ(code, number(held_code(outcome, outcomes)));
    };
    llvm::Value* const second_of_two = is(1, 2);
    llvm::Value* const second_of_three = is(1, 3);
    llvm::Value* const third = is(2, 3);
    const auto mask = [&](llvm::Value* value) { return function_.mask(value); };
    const auto either_of = [&](llvm::Value* a, llvm::Value* b) { return builder.CreateOr(a, b); };
    const Lanes above = select(mask(either_of(second_of_two, second_of_three)),
                               function_.splat(1.0), function_.splat(0.0));
    return HeldAt<Lanes>{.of_two = mask(either_of(is(0, 2), second_of_two)),
                         .of_three = mask(either_of(either_of(is(0, 3), second_of_three), third)),
                         .outcome = select(mask(third), function_.splat(2.0), above)};
}

void SwitchLanes::add(llvm::Value* bits) {
    bits_ = bits_ == nullptr ? bits : function_.builder().CreateOr(bits_, bits);
}

void SwitchLanes::report(SwitchIndex index, const LaneMask& two, const LaneMask& three) {
    llvm::IRBuilder<>& builder = function_.builder();
    const auto code = [&](unsigned more) {
        return number(std::uint64_t{more} << BranchBits::more_outcomes_shift |
                      std::uint64_t{index} << BranchBits::switch_shift);
    };
    llvm::Value* open = builder.CreateSelect(two.value, code(1),
                                             builder.CreateSelect(three.value, code(2), number(0)));
    // Report the first open switch only.
    if (any_open_) {
        constexpr std::uint64_t outcomes = 3U << BranchBits::more_outcomes_shift;
        llvm::Value* const first =
            builder.CreateICmpEQ(builder.CreateAnd(bits_, number(outcomes)), number(0));
        open = builder.CreateSelect(first, open, number(0));
    }
    any_open_ = true;
    add(open);
}

void SwitchLanes::report_kink(const LaneMask& may_be) {
    add(function_.builder().CreateSelect(may_be.value, number(BranchBits::kink), number(0)));
}

void SwitchLanes::report_cut(const LaneMask& open, const Lanes& at, const Lanes& aside) {
    cuts_->cut = first_cut(cuts_->cut.value_or(no_cut()), open, at, aside);
}

Cut<Lanes> SwitchLanes::no_cut() const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {.from = function_.splat(infinity), .to = function_.splat(-infinity)};
}

void SwitchLanes::store() {
    function_.store_integers(branches_, bits_ == nullptr ? number(0) : bits_);
    if (!cuts_) return;
    const Cut<Lanes> cut = cuts_->cut.value_or(no_cut());
    function_.store(cuts_->from, cut.from);
    function_.store(cuts_->to, cut.to);
}

}  // namespace zeroset::jit
