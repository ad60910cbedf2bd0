// Cells of a tile of pixels times a slab of depth, and what their forms say of them.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_CELLS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_CELLS_INL
#undef ZEROSET_BEAM_CELLS_INL
#else
#define ZEROSET_BEAM_CELLS_INL
#endif

#include "engine/trace/beam/cell_kernels.hpp"
#include "engine/trace/beam_view.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class Real>
using LanesOf = hn::CappedTag<Real, 64 / sizeof(Real)>;

/// Numbers of either type as doubles.
inline auto load_doubles(auto dd, const float* from) {
    return hn::PromoteTo(dd, hn::LoadU(hn::Rebind<float, decltype(dd)>(), from));
}
inline auto load_doubles(auto dd, const double* from) { return hn::LoadU(dd, from); }

inline std::size_t padded(std::size_t size, std::size_t multiple = batch_multiple) {
    return (size + multiple - 1) / multiple * multiple;
}

/// What a kernel says of a list of cells: FormBatchOf's arrays.
template <class Real>
struct Forms {
    std::vector<Real> c, e, r, slope_neg_lo, slope_hi, cut_from, cut_to;
    std::array<std::vector<Real>, 3> k;
    std::vector<ContinuityMask<Real>> continuous, nowhere, branches;

    /// Whether the form says something of cell i.
    [[nodiscard]] bool known(std::size_t i) const {
        return e[i] <= std::numeric_limits<Real>::max();
    }
    [[nodiscard]] BranchBits branches_of(std::size_t i) const {
        return {static_cast<std::uint32_t>(branches[i])};
    }
    void resize(std::size_t capacity) {
        for (std::vector<Real>* column :
             {&c, &e, &r, &slope_neg_lo, &slope_hi, &cut_from, &cut_to, &k[0], &k[1], &k[2]})
            column->resize(capacity);
        continuous.resize(capacity);
        nowhere.resize(capacity);
        branches.resize(capacity);
    }
};

/// The first four arguments of FormBatchOf.
template <class Real>
struct CellPlaces {
    std::vector<Real> u, v, s, s_radius;

    void resize(std::size_t capacity) {
        for (std::vector<Real>* column : {&u, &v, &s, &s_radius})
            column->resize(capacity);
    }
    /// Repeats the last of `size` cells, so that any of them begins a whole batch.
    void pad(std::size_t size) {
        const std::size_t count = std::min(batch_multiple, u.size() - size);
        for (std::vector<Real>* column : {&u, &v, &s, &s_radius})
            std::fill_n(column->data() + size, count, (*column)[size - 1]);
    }
};

/// Some cells, and those behind them up to a whole batch: what is said of these is to be
/// overwritten. `held`: of these cells.
template <class Real>
FormBatchOf<Real> form_batch(const TraceFrame& frame, const Kernel& kernel,
                             const FrustumOf<Real>& frustum, std::size_t first, std::size_t count,
                             const CellPlaces<Real>& places, Forms<Real>& out,
                             const HeldSwitches<Real>& held = {}) {
    return {.size = padded(count, kernel.lane_multiple),
            .u = places.u.data() + first,
            .v = places.v.data() + first,
            .s = places.s.data() + first,
            .s_radius = places.s_radius.data() + first,
            .frustum = frustum.base,
            .uniforms = frame.scene.uniforms.template boxes<Real>(),
            .c = out.c.data() + first,
            .k = {out.k[0].data() + first, out.k[1].data() + first, out.k[2].data() + first},
            .e = out.e.data() + first,
            .r = out.r.data() + first,
            .slope_neg_lo = out.slope_neg_lo.data() + first,
            .slope_hi = out.slope_hi.data() + first,
            .continuous = out.continuous.data() + first,
            .nowhere = out.nowhere.data() + first,
            .held = held,
            .branches = out.branches.data() + first};
}

/// The run's cells, by its kernel.
template <class Real>
void evaluate(const TraceFrame& frame, const FrustumOf<Real>& frustum, CellRun& run,
              const CellPlaces<Real>& places, Forms<Real>& out, Counters& counters) {
    counters.form += run.count;
    const FormBatchOf<Real> batch =
        form_batch(frame, *run.kernel, frustum, run.first, run.count, places, out);
    if (run.kernel->shortener != nullptr) {
        run.kernel->shortener->form(batch, run.record);
    } else {
        run.kernel->form(batch);
    }
}

/// A bit for each lane.
using LaneBits = std::uint32_t;

/// What is known of the cells of a vector.
struct CellBits {
    LaneBits rejected;  ///< hold no root
    LaneBits smooth;    ///< f is continuous, df/ds not 0: at most one root a ray
    LaneBits flat;      ///< f is continuous, its form 0 but for the error
    LaneBits finished;  ///< every ray surely has a root in the slab
    std::array<LaneBits, 4> child_finished;  ///< the same for a quarter of the tile
};

/// The tile of pixels of a cell: its first pixel in the tile at work.
struct CellTile {
    std::uint16_t pixel = 0;   ///< in rows of tile_size
    std::uint16_t inside = 0;  ///< 1: all rays are inside the clip box in the cell's slab

    [[nodiscard]] int col() const { return pixel % tile_size; }
    [[nodiscard]] int row() const { return pixel / tile_size; }
    static CellTile at(int col, int row, bool inside) {
        return {static_cast<std::uint16_t>(row * tile_size + col),
                static_cast<std::uint16_t>(inside ? 1 : 0)};
    }
};

/// The cells of one size of a tile, in order: tile by tile, front to back.
template <class Real>
struct Cells {
    std::size_t size = 0;
    std::vector<Real> from, to;  ///< the slabs: neighbours touch
    std::vector<CellTile> tile;
    CellRuns runs;

    CellPlaces<Real> places;  ///< once they are placed: the slabs a little longer
    Forms<Real> forms;
    std::vector<CellBits> bits;  ///< one for each vector of cells
    /// Where f may vanish in each quarter of the cell's tile: left top, right top, left bottom,
    /// right bottom. Empty where lo > hi.
    std::array<std::vector<Real>, 4> child_from, child_to;

    void clear() {
        size = 0;
        runs.clear();
    }
    void resize(std::size_t capacity) {
        places.resize(capacity);
        forms.resize(capacity);
        for (std::vector<Real>* column : {&from, &to})
            column->resize(capacity);
        for (std::size_t q = 0; q < 4; ++q) {
            child_from[q].resize(capacity);
            child_to[q].resize(capacity);
        }
        tile.resize(capacity);
        bits.resize(capacity / hn::Lanes(LanesOf<Real>()) + 1);
    }
    /// Makes room for so many more cells.
    void make_room(std::size_t more) {
        if (size + more + 2 * batch_multiple > from.size()) resize(2 * from.size() + more + 256);
    }
    /// There must be room. Empty slabs leave nothing: whether one is empty is hard to predict.
    void push(CellTile at, Real slab_from, Real slab_to) {
        from[size] = slab_from;
        to[size] = slab_to;
        tile[size] = at;
        size += slab_from <= slab_to ? 1U : 0U;
    }
    /// A cell of another list, in its place. There must be room.
    void push_copy(const Cells& other, std::size_t i) {
        from[size] = other.from[i];
        to[size] = other.to[i];
        tile[size] = other.tile[i];
        places.u[size] = other.places.u[i];
        places.v[size] = other.places.v[i];
        places.s[size] = other.places.s[i];
        places.s_radius[size] = other.places.s_radius[i];
        ++size;
    }
    /// Makes `places` of cells whose tiles have this side; `margin`: how much longer than their
    /// slabs they are.
    void place(const BeamView& view, int pixels, Real margin);
    [[nodiscard]] bool bit(LaneBits CellBits::* member, std::size_t cell) const {
        const std::size_t lanes = hn::Lanes(LanesOf<Real>());
        return (bits[cell / lanes].*member >> (cell % lanes) & 1U) != 0;
    }
    void set_bit(LaneBits CellBits::* member, std::size_t cell) {
        const std::size_t lanes = hn::Lanes(LanesOf<Real>());
        bits[cell / lanes].*member |= LaneBits{1} << (cell % lanes);
    }
    /// Every ray of an inside cell surely has a root in the slab.
    void finish(std::size_t cell) {
        set_bit(&CellBits::finished, cell);
        const std::size_t lanes = hn::Lanes(LanesOf<Real>());
        for (LaneBits& child : bits[cell / lanes].child_finished)
            child |= LaneBits{1} << (cell % lanes);
    }
    [[nodiscard]] bool child_finished(std::size_t child, std::size_t cell) const {
        const std::size_t lanes = hn::Lanes(LanesOf<Real>());
        return (bits[cell / lanes].child_finished[child] >> (cell % lanes) & 1U) != 0;
    }
};

template <class Real>
void Cells<Real>::place(const BeamView& view, int pixels, Real margin) {
    constexpr LanesOf<Real> d;
    std::array<Real, tile_size> u, v;
    const double half = 0.5 * (pixels - 1);
    for (int first = 0; first < tile_size; first += pixels) {
        u[static_cast<std::size_t>(first)] = static_cast<Real>(view.u(first + half));
        v[static_cast<std::size_t>(first)] = static_cast<Real>(view.v(first + half));
    }
    for (std::size_t i = 0; i < size; ++i) {
        places.u[i] = u[tile[i].pixel % tile_size];
        places.v[i] = v[tile[i].pixel / tile_size];
    }
    const auto one_half = hn::Set(d, Real{0.5});
    for (std::size_t i = 0; i < size; i += hn::Lanes(d)) {
        const auto lo = hn::LoadU(d, from.data() + i);
        const auto hi = hn::LoadU(d, to.data() + i);
        const auto middle = hn::Add(hn::Mul(one_half, lo), hn::Mul(one_half, hi));
        const auto radius = hn::Max(hn::Sub(hi, middle), hn::Sub(middle, lo));
        hn::StoreU(middle, d, places.s.data() + i);
        hn::StoreU(hn::Add(radius, hn::Set(d, margin)), d, places.s_radius.data() + i);
    }
    places.pad(size);
}

template <class D>
HWY_INLINE LaneBits bits_of(D d, hn::Mask<D> mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return bytes[0] | static_cast<LaneBits>(bytes[1]) << 8U;
}

/// Judges the cells by their forms, and contracts their slabs for the quarters of their tiles.
/// `pixels`: the tiles' side.
template <class Real>
class CellJudge {
public:
    explicit CellJudge(int pixels) {
        // Middle and radius of a quarter in units of the tile's radius; the radius a little more,
        // for the roundings of the cells' places.
        const double half = 0.5 * (pixels - 1);
        offset_ = static_cast<Real>(0.25 * pixels / half);
        radius_ = static_cast<Real>((0.5 * (0.5 * pixels - 1) / half) + 0x1p-10);
    }
    void judge(Cells<Real>& cells) const {
        for (std::size_t i = 0; i < cells.size; i += hn::Lanes(d))
            judge_vector(cells, i);
    }

private:
    using D = LanesOf<Real>;
    using V = hn::Vec<D>;
    using M = hn::Mask<D>;
    static constexpr D d{};

    struct Form {
        V c, ku, kv, kt, e;
    };

    void judge_vector(Cells<Real>& cells, std::size_t i) const;
    HWY_INLINE static LaneBits inside_of(const Cells<Real>& cells, std::size_t i);
    HWY_INLINE LaneBits contract(Cells<Real>& cells, std::size_t i, std::size_t child,
                                 const Form& form, V inverse, M usable, V width) const;
    static M mask_at(const std::vector<ContinuityMask<Real>>& masks, std::size_t i) {
        const hn::RebindToUnsigned<D> du;
        return hn::MaskFromVec(hn::BitCast(d, hn::LoadU(du, masks.data() + i)));
    }

    Real offset_, radius_;
};

template <class Real>
void CellJudge<Real>::judge_vector(Cells<Real>& cells, std::size_t i) const {
    const auto load = [&](const std::vector<Real>& column) {
        return hn::LoadU(d, column.data() + i);
    };
    const V zero = hn::Zero(d);
    const Forms<Real>& f = cells.forms;
    const Form form{load(f.c), load(f.k[0]), load(f.k[1]), load(f.k[2]), load(f.e)};
    const V aside = hn::Add(hn::Add(hn::Abs(form.ku), hn::Abs(form.kv)), form.e);
    const V size_c = hn::Abs(form.c);
    const V size_t_ = hn::Abs(form.kt);
    const M rejected = hn::Or(hn::Gt(size_c, hn::Add(aside, size_t_)), mask_at(f.nowhere, i));
    CellBits& bits = cells.bits[i / hn::Lanes(d)];
    bits.rejected = bits_of(d, rejected);
    const M continuous = mask_at(f.continuous, i);
    const M sloped = hn::Or(hn::Lt(load(f.slope_neg_lo), zero), hn::Lt(load(f.slope_hi), zero));
    bits.smooth = bits_of(d, hn::And(continuous, sloped));
    const LaneBits inside = inside_of(cells, i);
    const V inverse = hn::Div(hn::Set(d, Real{1}), form.kt);  // infinite where nothing is steep
    const V radius = hn::Set(d, radius_);
    const V width = hn::MulAdd(radius, hn::Add(hn::Abs(form.ku), hn::Abs(form.kv)), form.e);
    const LaneBits may_finish = inside & bits_of(d, continuous);
    const V linear = hn::Add(hn::Add(size_c, size_t_), hn::Add(hn::Abs(form.ku), hn::Abs(form.kv)));
    bits.flat = bits_of(d, hn::And(continuous, hn::Eq(linear, zero)));
    for (std::size_t child = 0; child < 4; ++child) {
        bits.child_finished[child] =
            may_finish & contract(cells, i, child, form, inverse, hn::Not(rejected), width);
    }
    bits.finished = bits.child_finished[0] & bits.child_finished[1] & bits.child_finished[2] &
                    bits.child_finished[3];
}

/// Which cells of a vector are inside the clip region.
template <class Real>
HWY_INLINE LaneBits CellJudge<Real>::inside_of(const Cells<Real>& cells, std::size_t i) {
    const hn::Rebind<std::uint32_t, D> du;
    const hn::Repartition<std::uint8_t, decltype(du)> bytes;
    const auto* const from = reinterpret_cast<const std::uint8_t*>(cells.tile.data() + i);
    const auto tiles = hn::BitCast(du, hn::LoadU(bytes, from));
    constexpr auto flag = std::bit_cast<std::uint32_t>(CellTile{0, 1});
    return bits_of(du, hn::TestBit(tiles, hn::Set(du, flag)));
}

/// The depths where f may vanish on the rays of a quarter; returns where all rays surely have a
/// root within the slab.
template <class Real>
HWY_INLINE LaneBits CellJudge<Real>::contract(Cells<Real>& cells, std::size_t i, std::size_t child,
                                              const Form& form, V inverse, M usable,
                                              V width) const {
    const V one = hn::Set(d, Real{1});
    const V right = hn::Set(d, (child & 1U) != 0 ? offset_ : -offset_);
    const V up = hn::Set(d, (child & 2U) != 0 ? -offset_ : offset_);
    const V c = hn::MulAdd(form.ku, right, hn::MulAdd(form.kv, up, form.c));
    const V middle = hn::Neg(hn::Mul(c, inverse));
    // Eight units for the roundings of middle and radius.
    const V slack = hn::Mul(hn::Add(hn::Abs(middle), one),
                            hn::Set(d, 8 * std::numeric_limits<Real>::epsilon()));
    const V radius = hn::Add(hn::MulAdd(width, hn::Abs(inverse), slack), slack);
    const V lo = hn::Sub(middle, radius);
    const V hi = hn::Add(middle, radius);
    const V from = hn::LoadU(d, cells.from.data() + i);
    const V to = hn::LoadU(d, cells.to.data() + i);
    const V s = hn::LoadU(d, cells.places.s.data() + i);
    const V s_radius = hn::LoadU(d, cells.places.s_radius.data() + i);
    // -1 and 1 where NaN.
    const V lo_in = hn::Max(lo, hn::Neg(one));
    const V hi_in = hn::Min(hi, one);
    const V rounding = hn::Mul(hn::Add(hn::Abs(s), s_radius),
                               hn::Set(d, 4 * std::numeric_limits<Real>::epsilon()));
    const V found_from = hn::Sub(hn::MulAdd(lo_in, s_radius, s), rounding);
    const V found_to = hn::Add(hn::MulAdd(hi_in, s_radius, s), rounding);
    const M possible = hn::And(usable, hn::Not(hn::Or(hn::Gt(lo, one), hn::Lt(hi, hn::Neg(one)))));
    const V empty = hn::Set(d, std::numeric_limits<Real>::infinity());
    hn::StoreU(hn::IfThenElse(possible, hn::Max(found_from, from), empty), d,
               cells.child_from[child].data() + i);
    hn::StoreU(hn::Min(found_to, to), d, cells.child_to[child].data() + i);
    const M known = hn::And(hn::Gt(lo, hn::Neg(one)), hn::Lt(hi, one));
    return bits_of(d, hn::And(known, hn::And(hn::Ge(found_from, from), hn::Le(found_to, to))));
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
