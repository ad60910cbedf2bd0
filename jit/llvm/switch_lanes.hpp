#pragma once

#include "engine/algebra/switches.hpp"
#include "engine/kernel/kernel.hpp"
#include "jit/llvm/batch_function.hpp"

#include <cstddef>
#include <optional>
#include <vector>

// Switches (engine/algebra/switches.hpp) in machine code. Private to jit/.

namespace zeroset::jit {

/// Emits the code for an algebra's switches: reads the batch's HeldSwitches and makes its
/// BranchBits.
class SwitchLanes final : public SwitchBoard<Lanes> {
public:
    /// Takes the offsets of the batch's members `held.words`, `held.stride` and `branches`; call
    /// before go_to_body.
    SwitchLanes(BatchFunction& function, std::size_t words_offset, std::size_t stride_offset,
                std::size_t branches_offset, std::size_t switches)
        : function_(function),
          words_(function.optional_array(words_offset)),
          stride_(switches > 0 ? function.size_member(stride_offset) : nullptr),
          branches_(function.optional_array(branches_offset)),
          loaded_((switches + per_word() - 1) / per_word(), nullptr) {}
    /// Lets cuts be made, too, for the batch's members at these offsets; call before go_to_body.
    void make_cuts(std::size_t from_offset, std::size_t to_offset) {
        cuts_ = Cuts{.from = function_.optional_array(from_offset),
                     .to = function_.optional_array(to_offset),
                     .cut = {}};
    }

    std::optional<HeldAt<Lanes>> held(SwitchIndex index) override;
    void report(SwitchIndex index, const LaneMask& two, const LaneMask& three) override;
    void report_kink(const LaneMask& may_be) override;
    [[nodiscard]] bool wants_cuts() const override { return cuts_.has_value(); }
    void report_cut(const LaneMask& open, const Lanes& at, const Lanes& aside) override;
    /// Writes the bits and the cuts; call in the body.
    void store();

private:
    [[nodiscard]] std::size_t per_word() const {
        return function_.is_float() ? switches_a_word<float> : switches_a_word<double>;
    }
    llvm::Value* number(std::uint64_t value) { return function_.splat_integer(value); }
    void add(llvm::Value* bits);
    [[nodiscard]] Cut<Lanes> no_cut() const;

    BatchFunction& function_;
    OptionalArray words_;
    llvm::Value* stride_;
    OptionalArray branches_;
    std::vector<llvm::Value*> loaded_;  ///< held words of the body's items, loaded so far
    llvm::Value* bits_ = nullptr;       ///< nullptr: none yet
    bool any_open_ = false;             ///< whether a switch has been reported
    struct Cuts {
        OptionalArray from, to;
        std::optional<Cut<Lanes>> cut;
    };
    std::optional<Cuts> cuts_;
};

}  // namespace zeroset::jit
