// Cells in which switches of f are open, piece by piece (engine/algebra/switches.hpp).
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_PIECES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_PIECES_INL
#undef ZEROSET_BEAM_PIECES_INL
#else
#define ZEROSET_BEAM_PIECES_INL
#endif

#include "engine/trace/beam/beam_cells-inl.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Pieces of some cells: which cell each is of, and the switches that are held in it.
template <class Real>
class PieceList {
public:
    using Word = ContinuityMask<Real>;

    /// For a kernel with so many switches.
    void begin(std::size_t switches) {
        words_a_piece_ = switches / switches_a_word<Real> + 1;
        cells_.clear();
        words_.clear();
    }
    [[nodiscard]] std::size_t size() const { return cells_.size(); }
    [[nodiscard]] std::size_t cell(std::size_t piece) const { return cells_[piece]; }

    /// The pieces of a cell, or of piece `parent` of it, by the switch that is open there; false
    /// where that is held already.
    bool push(std::size_t cell, const BranchBits& open) { return push(cell, open, nullptr); }
    bool push(std::size_t cell, const BranchBits& open, const PieceList& from, std::size_t parent) {
        return push(cell, open, from.words_.data() + parent * words_a_piece_);
    }

    /// The held switches as kernels take them; of up to a whole batch more pieces, which repeat the
    /// last one. Valid until the list changes.
    HeldSwitches<Real> held() {
        const std::size_t stride = padded(size());
        columns_.resize(stride * words_a_piece_);
        for (std::size_t piece = 0; piece < stride; ++piece) {
            const std::size_t from = std::min(piece, size() - 1) * words_a_piece_;
            for (std::size_t word = 0; word < words_a_piece_; ++word)
                columns_[word * stride + piece] = words_[from + word];
        }
        return {columns_.data(), stride};
    }

private:
    bool push(std::size_t cell, const BranchBits& open, const Word* parent);

    std::size_t words_a_piece_ = 0;
    std::vector<std::size_t> cells_;
    std::vector<Word> words_;    ///< piece by piece
    std::vector<Word> columns_;  ///< word by word
};

template <class Real>
bool PieceList<Real>::push(std::size_t cell, const BranchBits& open, const Word* parent) {
    const std::size_t word = open.open_switch() / switches_a_word<Real>;
    const std::size_t shift = held_bits * (open.open_switch() % switches_a_word<Real>);
    constexpr Word codes = (Word{1} << held_bits) - 1;
    if (parent != nullptr && (parent[word] >> shift & codes) != 0) return false;
    for (unsigned outcome = 0; outcome < open.outcomes(); ++outcome) {
        cells_.push_back(cell);
        const std::size_t begin = words_.size();
        if (parent != nullptr) {
            words_.insert(words_.end(), parent, parent + words_a_piece_);
        } else {
            words_.resize(begin + words_a_piece_, 0);
        }
        words_[begin + word] |= static_cast<Word>(held_code(outcome, open.outcomes())) << shift;
    }
    return true;
}

/// Pieces of cells, switch after switch.
template <class Real>
class Pieces {
public:
    /// For a kernel with so many switches.
    void begin(std::size_t switches) {
        switches_ = switches;
        now_.begin(switches);
        next_.begin(switches);
    }
    void push(std::size_t cell, const BranchBits& open) { now_.push(cell, open); }

    /// Looks at all pieces, holding up to `most_switches` switches of each. `evaluate(list)` asks a
    /// kernel about the pieces of a list; then `rejected(i)` tells whether the i-th holds no root
    /// and `branches(i)` its open switches. `keep(cell, i)` takes those that may hold one and are
    /// not divided any further.
    void visit(int most_switches, auto evaluate, auto rejected, auto branches, auto keep) {
        for (int held = 1; now_.size() > 0; ++held) {
            evaluate(now_);
            next_.begin(switches_);
            for (std::size_t i = 0; i < now_.size(); ++i) {
                if (rejected(i)) continue;
                const BranchBits open = branches(i);
                const bool divides = held < most_switches && open.outcomes() > 0 &&
                                     next_.push(now_.cell(i), open, now_, i);
                if (!divides) keep(now_.cell(i), i);
            }
            std::swap(now_, next_);
        }
    }

private:
    std::size_t switches_ = 0;
    PieceList<Real> now_, next_;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
