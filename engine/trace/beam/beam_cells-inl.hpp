// Cells of a tile of pixels times a slab of depth, and what their forms say of them.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_CELLS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_CELLS_INL
#undef ZEROSET_BEAM_CELLS_INL
#else
#define ZEROSET_BEAM_CELLS_INL
#endif

#include "engine/real/lanes-inl.hpp"
#include "engine/trace/beam/cell_kernels.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/tile_rays.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The forms of a list of cells: FormBatchOf's arrays.
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

/// Where cells are: the first four arguments of FormBatchOf.
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

/// A batch of `count` cells from `first` on, and of those behind them up to whole vectors: what is
/// said of the latter is to be overwritten. `held`: of these cells.
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

/// Evaluates the run's cells by its kernel; a specializer records their choices, too.
template <class Real>
void evaluate(const TraceFrame& frame, const FrustumOf<Real>& frustum, CellRun& run,
              const CellPlaces<Real>& places, Forms<Real>& out, Counters& counters) {
    counters.form += run.count;
    const FormBatchOf<Real> batch =
        form_batch(frame, *run.kernel, frustum, run.first, run.count, places, out);
    if (run.kernel->specializer != nullptr) {
        run.kernel->specializer->form(batch, run.record);
    } else {
        run.kernel->form(batch);
    }
}

/// Facts about the cells of a vector, a bit for each.
struct CellBits {
    LaneBits rejected;  ///< hold no root
    LaneBits smooth;    ///< f is continuous, df/ds not 0: at most one root a ray
    LaneBits flat;      ///< f is continuous, its form 0 but for the error
    LaneBits finished;  ///< every ray surely has a root in the slab
    std::array<LaneBits, 4> child_finished;  ///< every ray of a quarter has one
};

/// The tile of pixels of a cell: its first pixel in the tile at work.
struct CellTile {
    std::uint16_t pixel = 0;   ///< in rows of tile_size
    std::uint16_t inside = 0;  ///< 1: all rays are inside the clip box in the cell's slab

    [[nodiscard]] int col() const { return pixel % tile_size; }
    [[nodiscard]] int row() const { return pixel / tile_size; }
    static CellTile at(int col, int row, bool inside) {
        return {.pixel = static_cast<std::uint16_t>(row * tile_size + col),
                .inside = static_cast<std::uint16_t>(inside ? 1 : 0)};
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
        bits.resize(capacity / lanes<Real> + 1);
    }
    /// Makes room for so many more cells.
    void reserve(std::size_t more) {
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
    void place(const TileRays& rays, int pixels, Real margin);
    [[nodiscard]] bool bit(LaneBits CellBits::* member, std::size_t cell) const {
        return (bits[cell / lanes<Real>].*member >> (cell % lanes<Real>)&1U) != 0;
    }
    void set_bit(LaneBits CellBits::* member, std::size_t cell) {
        bits[cell / lanes<Real>].*member |= LaneBits{1} << (cell % lanes<Real>);
    }
    /// Every ray of an inside cell surely has a root in the slab.
    void finish(std::size_t cell) {
        set_bit(&CellBits::finished, cell);
        for (LaneBits& child : bits[cell / lanes<Real>].child_finished)
            child |= LaneBits{1} << (cell % lanes<Real>);
    }
    [[nodiscard]] bool child_finished(std::size_t child, std::size_t cell) const {
        return (bits[cell / lanes<Real>].child_finished[child] >> (cell % lanes<Real>)&1U) != 0;
    }
};

template <class Real>
void Cells<Real>::place(const TileRays& rays, int pixels, Real margin) {
    std::array<Real, tile_size> u, v;
    const double half = TileRays::middle_of(pixels);
    for (int first = 0; first < tile_size; first += pixels) {
        u[static_cast<std::size_t>(first)] = static_cast<Real>(rays.u(first + half));
        v[static_cast<std::size_t>(first)] = static_cast<Real>(rays.v(first + half));
    }
    for (std::size_t i = 0; i < size; ++i) {
        places.u[i] = u[tile[i].pixel % tile_size];
        places.v[i] = v[tile[i].pixel / tile_size];
    }
    const auto one_half = hn::Set(d<Real>, Real{0.5});
    for (std::size_t i = 0; i < size; i += lanes<Real>) {
        const auto lo = hn::LoadU(d<Real>, from.data() + i);
        const auto hi = hn::LoadU(d<Real>, to.data() + i);
        const auto middle = hn::Add(hn::Mul(one_half, lo), hn::Mul(one_half, hi));
        const auto radius = hn::Max(hn::Sub(hi, middle), hn::Sub(middle, lo));
        hn::StoreU(middle, d<Real>, places.s.data() + i);
        hn::StoreU(hn::Add(radius, hn::Set(d<Real>, margin)), d<Real>, places.s_radius.data() + i);
    }
    places.pad(size);
}

/// Judges the cells by their forms, and contracts their slabs for the quarters of their tiles.
/// `pixels`: the tiles' side.
template <class Real>
class CellJudge {
public:
    CellJudge(const TileRays& rays, int pixels) {
        // Middle and radius of a quarter in units of the tile's radius; the radius a little more,
        // for the roundings of the cells' places.
        const double radius = rays.radius_of(pixels);
        offset_ = static_cast<Real>(0.25 * pixels / radius);
        radius_ = static_cast<Real>((rays.radius_of(pixels / 2) / radius) + 0x1p-10);
    }
    void judge(Cells<Real>& cells) const {
        for (std::size_t i = 0; i < cells.size; i += lanes<Real>)
            judge_vector(cells, i);
    }

private:
    struct Form {
        V<Real> c, ku, kv, kt, e;
    };

    void judge_vector(Cells<Real>& cells, std::size_t i) const;
    HWY_INLINE static LaneBits inside_of(const Cells<Real>& cells, std::size_t i);
    HWY_INLINE LaneBits contract(Cells<Real>& cells, std::size_t i, std::size_t child,
                                 const Form& form, V<Real> inverse, M<Real> usable,
                                 V<Real> width) const;

    Real offset_, radius_;
};

template <class Real>
void CellJudge<Real>::judge_vector(Cells<Real>& cells, std::size_t i) const {
    const auto load = [&](const std::vector<Real>& column) {
        return hn::LoadU(d<Real>, column.data() + i);
    };
    const V<Real> zero = hn::Zero(d<Real>);
    const Forms<Real>& f = cells.forms;
    const Form form{
        .c = load(f.c), .ku = load(f.k[0]), .kv = load(f.k[1]), .kt = load(f.k[2]), .e = load(f.e)};
    // Reject cells on which the form excludes 0, or f is nowhere defined.
    const V<Real> aside = hn::Add(hn::Add(hn::Abs(form.ku), hn::Abs(form.kv)), form.e);
    const V<Real> size_c = hn::Abs(form.c);
    const V<Real> size_kt = hn::Abs(form.kt);
    const M<Real> rejected =
        hn::Or(hn::Gt(size_c, hn::Add(aside, size_kt)), mask_at(d<Real>, f.nowhere.data() + i));
    CellBits& bits = cells.bits[i / lanes<Real>];
    bits.rejected = bits_of(d<Real>, rejected);
    // Find those on which f is monotone along the rays.
    const M<Real> continuous = mask_at(d<Real>, f.continuous.data() + i);
    const M<Real> sloped =
        hn::Or(hn::Lt(load(f.slope_neg_lo), zero), hn::Lt(load(f.slope_hi), zero));
    bits.smooth = bits_of(d<Real>, hn::And(continuous, sloped));
    // Find those on which the form says nothing but its error.
    const V<Real> linear =
        hn::Add(hn::Add(size_c, size_kt), hn::Add(hn::Abs(form.ku), hn::Abs(form.kv)));
    bits.flat = bits_of(d<Real>, hn::And(continuous, hn::Eq(linear, zero)));
    // Contract the slab for each quarter of the tile.
    const V<Real> inverse =
        hn::Div(hn::Set(d<Real>, Real{1}), form.kt);  // infinite where nothing is steep
    const V<Real> radius = hn::Set(d<Real>, radius_);
    const V<Real> width = hn::MulAdd(radius, hn::Add(hn::Abs(form.ku), hn::Abs(form.kv)), form.e);
    const LaneBits may_finish = inside_of(cells, i) & bits_of(d<Real>, continuous);
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
    const hn::Rebind<std::uint32_t, Tag<Real>> words;
    const hn::Repartition<std::uint8_t, decltype(words)> bytes;
    const auto* const from = reinterpret_cast<const std::uint8_t*>(cells.tile.data() + i);
    const auto tiles = hn::BitCast(words, hn::LoadU(bytes, from));
    constexpr auto flag = std::bit_cast<std::uint32_t>(CellTile{.pixel = 0, .inside = 1});
    return bits_of(words, hn::TestBit(tiles, hn::Set(words, flag)));
}

/// The depths where f may vanish on the rays of a quarter; returns where all rays surely have a
/// root within the slab.
template <class Real>
HWY_INLINE LaneBits CellJudge<Real>::contract(Cells<Real>& cells, std::size_t i, std::size_t child,
                                              const Form& form, V<Real> inverse, M<Real> usable,
                                              V<Real> width) const {
    // Where the linear part vanishes in the quarter's middle, and how far from there f may: in
    // units of the cell's radius.
    const V<Real> one = hn::Set(d<Real>, Real{1});
    const V<Real> right = hn::Set(d<Real>, (child & 1U) != 0 ? offset_ : -offset_);
    const V<Real> up = hn::Set(d<Real>, (child & 2U) != 0 ? -offset_ : offset_);
    const V<Real> c = hn::MulAdd(form.ku, right, hn::MulAdd(form.kv, up, form.c));
    const V<Real> middle = hn::Neg(hn::Mul(c, inverse));
    // Eight units for the roundings of middle and radius.
    const V<Real> slack = hn::Mul(hn::Add(hn::Abs(middle), one),
                                  hn::Set(d<Real>, 8 * std::numeric_limits<Real>::epsilon()));
    const V<Real> radius = hn::Add(hn::MulAdd(width, hn::Abs(inverse), slack), slack);
    const V<Real> lo = hn::Sub(middle, radius);
    const V<Real> hi = hn::Add(middle, radius);
    const V<Real> from = hn::LoadU(d<Real>, cells.from.data() + i);
    const V<Real> to = hn::LoadU(d<Real>, cells.to.data() + i);
    const V<Real> s = hn::LoadU(d<Real>, cells.places.s.data() + i);
    const V<Real> s_radius = hn::LoadU(d<Real>, cells.places.s_radius.data() + i);
    // Round outward on the way to depths; -1 and 1 where NaN.
    const V<Real> lo_in = hn::Max(lo, hn::Neg(one));
    const V<Real> hi_in = hn::Min(hi, one);
    const V<Real> rounding = hn::Mul(hn::Add(hn::Abs(s), s_radius),
                                     hn::Set(d<Real>, 4 * std::numeric_limits<Real>::epsilon()));
    const V<Real> found_from = hn::Sub(hn::MulAdd(lo_in, s_radius, s), rounding);
    const V<Real> found_to = hn::Add(hn::MulAdd(hi_in, s_radius, s), rounding);
    // Store an empty slab where nothing is left.
    const M<Real> possible =
        hn::And(usable, hn::Not(hn::Or(hn::Gt(lo, one), hn::Lt(hi, hn::Neg(one)))));
    const V<Real> empty = hn::Set(d<Real>, std::numeric_limits<Real>::infinity());
    hn::StoreU(hn::IfThenElse(possible, hn::Max(found_from, from), empty), d<Real>,
               cells.child_from[child].data() + i);
    hn::StoreU(hn::Min(found_to, to), d<Real>, cells.child_to[child].data() + i);
    // All rays have a root where the form vanishes inside the cell, within the slab.
    const M<Real> known = hn::And(hn::Gt(lo, hn::Neg(one)), hn::Lt(hi, one));
    return bits_of(d<Real>,
                   hn::And(known, hn::And(hn::Ge(found_from, from), hn::Le(found_to, to))));
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
