// Parts of rays that are searched on their own, and what is known of them (beam_rays-inl.hpp).
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_SEGMENTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_SEGMENTS_INL
#undef ZEROSET_BEAM_SEGMENTS_INL
#else
#define ZEROSET_BEAM_SEGMENTS_INL
#endif

#include "engine/trace/beam/beam_pieces-inl.hpp"
#include "engine/trace/beam/beam_ranges-inl.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A part of a ray still to be searched, from the front.
template <class Real>
struct Segment {
    std::uint32_t pixel;
    bool inside;  ///< surely inside the clip box
    Real from, to;
    Real step;             ///< how far the next cell reaches
    const Kernel* kernel;  ///< of f on it

    [[nodiscard]] Real end() const { return std::min(to, from + step); }
};

/// How a march ends.
template <class Real>
struct MarchSettings {
    Real finest;     ///< segments are not made shorter
    Real margin;     ///< cells are longer than their part of the ray by this at both ends
    bool certifies;  ///< brackets of some `finest` are narrow enough to certify a root
};

/// What forms say of segments.
template <class Real>
struct Verdicts {
    /// The parts of the segments that were evaluated, and where in them f may vanish.
    std::vector<Real> begin, end, from, to;
    std::vector<Real> last;   ///< the ends of the segments
    std::vector<Real> guess;  ///< a guess of the root
    /// Where a switch may change, or not far from it.
    std::vector<Real> cut_from, cut_to;

    /// Of the segments of a vector.
    struct Bits {
        LaneBits rejected;   ///< no root in the part
        LaneBits finished;   ///< nor is there anything behind it
        LaneBits weak;       ///< the form says little; the natural interval extension may say more
        LaneBits monotone;   ///< f is continuous, with a slope that bends little
        LaneBits certain;    ///< then there is a root
        LaneBits contracts;  ///< the form leaves less than three fifths of the part
        LaneBits vanishes;   ///< f is surely 0 in all of the part
        LaneBits cut;        ///< to be cut where a switch may change, see `cut_from`
    };
    std::vector<Bits> bits;

    explicit Verdicts(std::size_t capacity) : bits(capacity / hn::Lanes(LanesOf<Real>())) {
        for (std::vector<Real>* column :
             {&begin, &end, &from, &to, &last, &guess, &cut_from, &cut_to})
            column->resize(capacity);
    }
    [[nodiscard]] bool bit(LaneBits Bits::* member, std::size_t i) const {
        const std::size_t lanes = hn::Lanes(LanesOf<Real>());
        return (bits[i / lanes].*member >> (i % lanes) & 1U) != 0;
    }
    void set_bit(LaneBits Bits::* member, std::size_t i) {
        const std::size_t lanes = hn::Lanes(LanesOf<Real>());
        bits[i / lanes].*member |= LaneBits{1} << (i % lanes);
    }
    void reject(std::size_t i) { set_bit(&Bits::rejected, i); }
    /// A root is nowhere else in the part than from `lo` to `hi`.
    void narrow(std::size_t i, Real lo, Real hi) {
        from[i] = std::max(from[i], lo);
        to[i] = std::min(to[i], hi);
        if (!(from[i] <= to[i])) return reject(i);
        guess[i] = std::clamp(guess[i], from[i], to[i]);
        constexpr auto much = static_cast<Real>(0.6);
        const bool contracts = to[i] - from[i] < much * (end[i] - begin[i]);
        if (contracts) set_bit(&Bits::contracts, i);
    }
};

/// Parts of segments as cells, and what their forms say.
template <class Real>
struct SegmentCells {
    CellPlaces<Real> places;
    Forms<Real> forms;
    Verdicts<Real> verdicts;

    explicit SegmentCells(std::size_t capacity) : verdicts(capacity) {
        places.resize(capacity);
        forms.resize(capacity);
    }
    /// Cell `at` becomes cell i of another list.
    void copy_cell(const SegmentCells& other, std::size_t i, std::size_t at) {
        places.u[at] = other.places.u[i];
        places.v[at] = other.places.v[i];
        places.s[at] = other.places.s[i];
        places.s_radius[at] = other.places.s_radius[i];
        verdicts.begin[at] = other.verdicts.begin[i];
        verdicts.end[at] = other.verdicts.end[i];
        verdicts.last[at] = other.verdicts.last[i];
    }
};

/// What is left of a segment that is not cut any further.
template <class Real>
struct Rest {
    Segment<Real> segment;
    Real from, to;  ///< where the root may be
    bool continuous;
};

/// What a RayMarcher keeps; empty between marches but for the room.
template <class Real>
struct MarchMemory {
    static constexpr std::size_t capacity = 256;
    /// Switches that are held at a time, and pieces of a cell at most.
    static constexpr int most_switches = 3;
    static constexpr std::size_t most_pieces = 27;

    std::vector<Segment<Real>> segments;
    std::vector<Segment<Real>> next;  ///< what goes on from them
    std::vector<Rest<Real>> rests;    ///< of the batch at work
    std::vector<std::size_t> asked;
    RangeMemory<Real> ranges, witness_ranges;
    SegmentCells<Real> cells{capacity};
    Pieces<Real> pieces;
    SegmentCells<Real> piece_cells{most_pieces * capacity};
    /// Where a root may be in some piece of each cell; empty where from > to.
    std::vector<Real> left_from, left_to;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
