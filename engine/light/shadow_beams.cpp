#include "engine/kernel/form_signs.hpp"
#include "engine/light/cell_verdicts-inl.hpp"
#include "engine/light/shadow_search.hpp"
#include "engine/real/scalar.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace zeroset {
namespace {

constexpr std::size_t cells_at_once = 64;
/// The side of the squares that a tile is divided into at first, in pixels.
constexpr int first_side = 8;
/// How much longer a cell is than the one before it.
constexpr double growth = 3.0;
/// Squares with no more hits than these are rays at once: a cell of a beam takes the time of many.
constexpr unsigned few_hits = 4;
/// Beams of one group are of widths that differ by a factor of 2 at most; the narrowest and the
/// widest groups have no bound.
constexpr int width_groups = 16;

template <class Real>
using OneCell = HWY_NAMESPACE::OneCell<Real>;
template <class Real>
using CellLine = HWY_NAMESPACE::CellLine<OneCell<Real>>;

/// The hits of a beam: in the next cell, or behind it as the light sees it.
enum class Start : std::uint8_t {
    Roots,   ///< in it, the hits: roots of the surface's own function
    Above,   ///< in it, hits at which f is 0 or above
    Others,  ///< in it, hits of other surfaces, or on caps
    Behind,  ///< the hits are behind it
};

Square square_at(int col, int row, int side) {
    return {.col = static_cast<std::uint8_t>(col),
            .row = static_cast<std::uint8_t>(row),
            .side = static_cast<std::uint8_t>(side)};
}

/// The hits of a square that are asked about, in the light's view: u and v of its rays, and the
/// depths of hits over a plane that is about the surface's tangent,
/// h = s - by_u u - by_v v.
struct Hits {
    double u, v, u_radius, v_radius;
    double by_u, by_v;
    double h_near, h_far;

    /// The depth of the plane in the middle of the rays.
    [[nodiscard]] double plane() const { return by_u * u + by_v * v; }
    /// How far the plane rises from there.
    [[nodiscard]] double rise() const {
        return std::abs(by_u) * u_radius + std::abs(by_v) * v_radius;
    }
};

/// The rays from a square of hits to the light. Depths are over the plane of the hits.
struct Beam {
    Square square;
    Start start;   ///< Behind: all hits lie behind `to`; else the next cell holds them
    RaySign sign;  ///< of f at `to` on all rays, if they lie behind
    Hits hits;
    LightWalls::Entry entry;
    double to;    ///< behind it, there is no root but the hits
    double step;  ///< of the next cell, in front of `to`, or of the hits

    [[nodiscard]] double next() const {
        const double from = start == Start::Behind ? to : std::min(to, hits.h_near);
        return std::max(entry.first, from - step);
    }
    [[nodiscard]] double length() const { return to - next(); }
    /// The depth in the middle of the next cell.
    [[nodiscard]] double middle() const { return hits.plane() + 0.5 * (next() + to); }
    [[nodiscard]] double width() const { return 2.0 * std::max(hits.u_radius, hits.v_radius); }
    /// The length of a cell that is about as long as the box about it is wide.
    [[nodiscard]] double fair_length() const { return width() + 2.0 * hits.rise(); }
    /// Whether the next cell is to be cut across, before the square is divided.
    [[nodiscard]] bool is_long() const {
        const double of_hits = start == Start::Behind ? 0.0 : hits.h_far - hits.h_near;
        return length() > 2.0 * (fair_length() + of_hits);
    }
};

template <class Real>
class BeamSearch {
public:
    BeamSearch(const ShadowSearch& search, ShadowBits& found, std::vector<LightRay>& rest,
               Counters& counters)
        : search_(search),
          found_(found),
          rest_(rest),
          counters_(counters),
          frustum_(search.rays.frustum<Real>(1)),
          per_distance_(1.0 / search.rays.distance()),
          widest_(search.light.view.pixel_at_look(1)),
          margin_(search.places.error + search.rays.depth_error()) {}

    void search();

private:
    [[nodiscard]] Start start_of(const Square& square) const;
    /// How many pixels of the square are asked about.
    [[nodiscard]] unsigned count_in(const Square& square) const;
    /// A pixel of the square that is asked about, near its middle; LightPlaces::pixels: none is.
    [[nodiscard]] std::size_t pixel_of(const Square& square) const;
    [[nodiscard]] Hits hits_of(const Square& square, float by_u, float by_v, bool keep_plane) const;
    /// Adds the beam of a square, that of a part of `whole` if there is one.
    void add(const Square& square, const Beam* whole);
    /// Adds the ray of a pixel, or what is left of it where it goes on from `whole`.
    void add_ray(std::size_t pixel, const Beam* whole);
    /// Adds the rays of a square's pixels.
    void add_each_ray(const Square& square, const Beam* whole);
    void divide(const Beam& beam);
    void search_group(std::vector<Beam>& beams);
    void evaluate(std::span<const Beam> beams);
    [[nodiscard]] CellLine<Real> slanted_line(const Beam& beam, std::size_t i) const;
    void take(Beam& beam, const CellLine<Real>& line, std::vector<Beam>& group);
    void darken(const Square& square);

    const ShadowSearch& search_;
    ShadowBits& found_;
    std::vector<LightRay>& rest_;
    Counters& counters_;
    FrustumOf<Real> frustum_;
    double widest_u_ = 0.0, widest_v_ = 0.0;  ///< radii of the cells in the last batch
    double per_distance_;
    double widest_;  ///< the height of all that the light sees
    double margin_;  ///< cells are longer than their part of the beam
    std::array<std::vector<Beam>, width_groups> groups_;  ///< by width, the widest first
    FormCells<Real, cells_at_once> cells_;
};

template <class Real>
Start BeamSearch<Real>::start_of(const Square& square) const {
    std::uint64_t others = 0;
    for (std::size_t row = square.row; row < std::size_t{square.row} + square.side; ++row)
        others |= search_.open[row] & square.bits() & ~search_.roots[row];
    if (others != 0) return Start::Others;
    return search_.is_member ? Start::Above : Start::Roots;
}

template <class Real>
unsigned BeamSearch<Real>::count_in(const Square& square) const {
    unsigned sum = 0;
    for (std::size_t row = square.row; row < std::size_t{square.row} + square.side; ++row)
        sum += static_cast<unsigned>(std::popcount(search_.open[row] & square.bits()));
    return sum;
}

template <class Real>
std::size_t BeamSearch<Real>::pixel_of(const Square& square) const {
    // Begin in the middle row, and wrap around.
    for (std::size_t i = 0; i < square.side; ++i) {
        const std::size_t row = square.row + (square.side / 2U + i) % square.side;
        const std::uint64_t bits = search_.open[row] & square.bits();
        if (bits == 0) continue;
        const unsigned middle = square.col + square.side / 2U;
        const std::uint64_t right = bits >> middle << middle;
        return row * tile_size +
               static_cast<std::size_t>(std::countr_zero(right != 0 ? right : bits));
    }
    return LightPlaces::pixels;
}

template <class Real>
Hits BeamSearch<Real>::hits_of(const Square& square, float by_u, float by_v,
                               bool keep_plane) const {
    const PlaceBounds bounds = bounds_of(search_.places, search_.open, square, by_u, by_v);
    const float rise = std::abs(by_u) * bounds.u.size() + std::abs(by_v) * bounds.v.size();
    // A plane that the hits do not follow is none for them.
    const bool slanted = keep_plane || bounds.h.size() + rise < 1.5F * bounds.s.size();
    const PlaceRange& h = slanted ? bounds.h : bounds.s;
    const double slope_u = slanted ? static_cast<double>(by_u) : 0.0;
    const double slope_v = slanted ? static_cast<double>(by_v) : 0.0;
    const double error = search_.places.error;
    const double h_error = (1.0 + std::abs(slope_u) + std::abs(slope_v)) * error;
    return {.u = bounds.u.middle(),
            .v = bounds.v.middle(),
            .u_radius = bounds.u.radius() + error,
            .v_radius = bounds.v.radius() + error,
            .by_u = slope_u,
            .by_v = slope_v,
            .h_near = static_cast<double>(h.least) - h_error,
            .h_far = static_cast<double>(h.greatest) + h_error};
}

template <class Real>
void BeamSearch<Real>::add(const Square& square, const Beam* whole) {
    const unsigned hits_here = count_in(square);
    if (hits_here == 0) return;
    if (hits_here <= few_hits || square.side == 1) return add_each_ray(square, whole);
    const std::size_t pixel = pixel_of(square);
    const bool behind = whole != nullptr && whole->start == Start::Behind;
    const LightPlaces& places = search_.places;
    // Where the beam goes on, it goes on over the same plane.
    const Hits hits = behind ? hits_of(square, static_cast<float>(whole->hits.by_u),
                                       static_cast<float>(whole->hits.by_v), true)
                             : hits_of(square, places.by_u[pixel], places.by_v[pixel], false);
    const Plane plane{.middle = hits.plane(), .by_u = hits.by_u, .by_v = hits.by_v};
    Beam beam{.square = square,
              .start = behind ? Start::Behind : start_of(square),
              .sign = behind ? whole->sign : RaySign::Unknown,
              .hits = hits,
              .entry = search_.walls.entry(hits.u, hits.v, hits.u_radius, hits.v_radius, plane),
              .to = behind ? whole->to : hits.h_far,
              .step = 0.0};
    if (!(beam.entry.first < beam.to)) return;
    beam.step = std::max(behind ? whole->step : 0.0, beam.fair_length());
    const double narrower = std::log2(widest_ / beam.width());
    const int group = std::clamp(static_cast<int>(narrower), 0, width_groups - 1);
    groups_[static_cast<std::size_t>(group)].push_back(beam);
}

template <class Real>
void BeamSearch<Real>::add_ray(std::size_t pixel, const Beam* whole) {
    const LightPlaces& places = search_.places;
    const auto u = static_cast<double>(places.u[pixel]);
    const auto v = static_cast<double>(places.v[pixel]);
    const auto s = static_cast<double>(places.s[pixel]);
    const bool behind = whole != nullptr && whole->start == Start::Behind;
    // Where the beam goes on, depths are over its plane.
    const double to = behind ? whole->hits.by_u * u + whole->hits.by_v * v + whole->to : s;
    constexpr Plane none{.middle = 0.0, .by_u = 0.0, .by_v = 0.0};
    const LightRay ray{
        .pixel = pixel,
        .u = u * per_distance_,
        .v = v * per_distance_,
        .s = s,
        .from = search_.walls.entry(u, v, places.error, places.error, none).first,
        .to = to + (behind ? margin_ : places.error),
        .left = behind,
        .sign = behind ? whole->sign : RaySign::Unknown,
        .is_root = (search_.roots[pixel / tile_size] >> pixel % tile_size & 1U) != 0};
    if (ray.from < ray.to) rest_.push_back(ray);
}

template <class Real>
void BeamSearch<Real>::add_each_ray(const Square& square, const Beam* whole) {
    for (std::size_t row = square.row; row < std::size_t{square.row} + square.side; ++row) {
        for (std::uint64_t bits = search_.open[row] & square.bits(); bits != 0; bits &= bits - 1)
            add_ray(row * tile_size + static_cast<std::size_t>(std::countr_zero(bits)), whole);
    }
}

template <class Real>
void BeamSearch<Real>::divide(const Beam& beam) {
    for (const Square& quarter : beam.square.quarters())
        add(quarter, &beam);
}

template <class Real>
void BeamSearch<Real>::evaluate(std::span<const Beam> beams) {
    const std::size_t size = padded(beams.size());
    widest_u_ = 0.0;
    widest_v_ = 0.0;
    for (std::size_t i = 0; i < size; ++i) {
        const Beam& beam = beams[std::min(i, beams.size() - 1)];
        const Hits& hits = beam.hits;
        widest_u_ = std::max(widest_u_, hits.u_radius);
        widest_v_ = std::max(widest_v_, hits.v_radius);
        cells_.u[i] = static_cast<Real>(hits.u * per_distance_);
        cells_.v[i] = static_cast<Real>(hits.v * per_distance_);
        cells_.s[i] = static_cast<Real>(beam.middle());
        const double off = std::abs(static_cast<double>(cells_.s[i]) - beam.middle());
        cells_.s_radius[i] = upper_end(Real{}, 0.5 * beam.length() + hits.rise() + off + margin_);
    }
    frustum_.u_radius = upper_end(Real{}, widest_u_ * per_distance_);
    frustum_.v_radius = upper_end(Real{}, widest_v_ * per_distance_);
    counters_.form += beams.size();
    const Kernel& kernel = search_.light.kernel;
    const Real* const uniforms = search_.light.scene.uniforms.template boxes<Real>();
    kernel.form(cells_.batch(size, frustum_, uniforms));
    counters_.range += ask_unknown_signs(kernel.template in<Real>().range, frustum_, false,
                                         uniforms, beams.size(), cells_);
}

/// The form of a box holds in the slanted cell inside it: a depth there is
///   plane + by_u u + by_v v + length / 2 t,
/// so that the terms of u and v take up what of the depth's term goes with the plane.
template <class Real>
CellLine<Real> BeamSearch<Real>::slanted_line(const Beam& beam, std::size_t i) const {
    constexpr Real rounding = 16 * std::numeric_limits<Real>::epsilon();
    const Hits& hits = beam.hits;
    const double per_radius = 1.0 / static_cast<double>(cells_.s_radius[i]);
    const auto part = [](double of) { return static_cast<Real>(of); };
    const Real along = cells_.k[2][i];
    const Real aside_u = cells_.k[0][i] * part(hits.u_radius / widest_u_) +
                         along * part(hits.by_u * hits.u_radius * per_radius);
    const Real aside_v = cells_.k[1][i] * part(hits.v_radius / widest_v_) +
                         along * part(hits.by_v * hits.v_radius * per_radius);
    auto line = HWY_NAMESPACE::line_of<OneCell<Real>>(cells_, i);
    const double off = std::abs(static_cast<double>(cells_.s[i]) - beam.middle()) + margin_;
    const Real spare =
        rounding * (line.aside + std::abs(along)) + std::abs(along) * part(off * per_radius);
    line.along = along * part(0.5 * beam.length() * per_radius);
    line.aside = std::abs(aside_u) + std::abs(aside_v) + cells_.e[i] + spare;
    return line;
}

template <class Real>
void BeamSearch<Real>::darken(const Square& square) {
    for (std::size_t row = square.row; row < std::size_t{square.row} + square.side; ++row)
        found_.prove_dark(row, search_.open[row] & square.bits());
}

template <class Real>
void BeamSearch<Real>::take(Beam& beam, const CellLine<Real>& line, std::vector<Beam>& group) {
    const double length = beam.length();
    const bool at_roots = beam.start == Start::Roots;
    const auto verdict = verdict_of(line, {.behind = beam.start == Start::Behind,
                                           .left_falling = at_roots || beam.start == Start::Above,
                                           .left_rising = at_roots,
                                           .above = beam.sign == RaySign::Positive,
                                           .below = beam.sign == RaySign::Negative});
    if (verdict.dark && beam.next() >= beam.entry.last) {
        darken(beam.square);
        return;
    }
    if (verdict.free) {
        beam.to = beam.next();
        beam.start = Start::Behind;
        beam.sign = verdict.positive   ? RaySign::Positive
                    : verdict.negative ? RaySign::Negative
                                       : RaySign::Unknown;
        beam.step *= growth;
        if (beam.entry.first < beam.to) group.push_back(beam);
        return;
    }
    if (beam.is_long()) {
        beam.step = 0.5 * length;
        group.push_back(beam);
    } else {
        beam.step = length;
        divide(beam);
    }
}

template <class Real>
void BeamSearch<Real>::search_group(std::vector<Beam>& beams) {
    std::vector<Beam> taken;
    while (!beams.empty() && !search_.light.stopped()) {
        const auto first =
            beams.end() - static_cast<std::ptrdiff_t>(std::min(beams.size(), cells_at_once));
        taken.assign(first, beams.end());
        beams.erase(first, beams.end());
        evaluate(taken);
        for (std::size_t i = 0; i < taken.size(); ++i) {
            Beam& beam = taken[i];
            take(beam, slanted_line(beam, i), beams);
        }
    }
}

template <class Real>
void BeamSearch<Real>::search() {
    if (search_.singly) return add_each_ray(square_at(0, 0, tile_size), nullptr);
    for (int row = 0; row < tile_size; row += first_side) {
        for (int col = 0; col < tile_size; col += first_side)
            add(square_at(col, row, first_side), nullptr);
    }
    for (std::vector<Beam>& group : groups_)
        search_group(group);
}

}  // namespace

void search_beams(const ShadowSearch& search, ShadowBits& found, std::vector<LightRay>& rest,
                  Counters& counters) {
    if (search.light.precision == Precision::Double) {
        BeamSearch<double>(search, found, rest, counters).search();
    } else {
        BeamSearch<float>(search, found, rest, counters).search();
    }
}

}  // namespace zeroset
