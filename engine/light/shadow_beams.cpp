#include "engine/light/shadow_cells.hpp"
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
/// The length of a beam's first cell, in its widths, and how much longer a cell is than the one
/// before it.
constexpr double first_widths = 2.0;
constexpr double growth = 4.0;
/// Beams of one group are of widths that differ by a factor of 2 at most; the narrowest and the
/// widest groups have no bound.
constexpr int width_groups = 16;

/// A square of pixels of a tile.
struct Square {
    std::uint8_t col, row, side;

    /// Its bits in each of its rows.
    [[nodiscard]] std::uint64_t bits() const {
        return (~std::uint64_t{0} >> (tile_size - side)) << col;
    }
};

/// The box of the places of a square's hits that are asked about.
struct Places {
    double u, v, u_radius, v_radius;
    double s_near, s_far;
    bool any_root, any_other;  ///< there are roots of the surface's function among them; others
};

/// The rays from a square of hits to the light.
struct Beam {
    Square square;
    Places hits;
    /// Depths at which the first of the rays enters what is visible, and the last one.
    double first_enters, last_enters;
    double to;    ///< behind it, there is no root but the hits
    double step;  ///< of the next cell, in front of `to`, or of the hits
    bool left;    ///< all hits lie behind `to`; else the next cell holds them
    Sign sign;    ///< of f at `to` on all rays, if the hits are left

    [[nodiscard]] double next() const {
        return std::max(first_enters, (left ? to : std::min(to, hits.s_near)) - step);
    }
    [[nodiscard]] double length() const { return to - next(); }
    [[nodiscard]] double width() const { return 2.0 * std::max(hits.u_radius, hits.v_radius); }
    [[nodiscard]] Start start() const {
        return left ? Start::Behind : hits.any_other ? Start::Others : Start::Roots;
    }
    /// Whether the next cell is to be cut across, before the square is divided.
    [[nodiscard]] bool is_long() const {
        const double hits_length = left ? 0.0 : hits.s_far - hits.s_near;
        return length() > 2.0 * (width() + hits_length);
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
    [[nodiscard]] Places places_of(const Square& square) const;
    /// Adds the beam of a square, that of a part of `whole` if there is one.
    void add(const Square& square, const Beam* whole);
    void add_ray(const Beam& beam);
    void divide(const Beam& beam);
    void search_group(std::vector<Beam>& beams);
    void evaluate(std::span<const Beam> beams);
    void take(Beam& beam, const ShadeVerdict& verdict, std::vector<Beam>& group);
    void darken(const Square& square);

    const ShadowSearch& search_;
    ShadowBits& found_;
    std::vector<LightRay>& rest_;
    Counters& counters_;
    FrustumOf<Real> frustum_;
    double per_distance_;
    double widest_;  ///< the height of all that the light sees
    double margin_;  ///< cells are longer than their part of the beam
    std::array<std::vector<Beam>, width_groups> groups_;  ///< by width, the widest first
    FormCells<Real, cells_at_once> cells_;
};

template <class Real>
Places BeamSearch<Real>::places_of(const Square& square) const {
    constexpr float none = std::numeric_limits<float>::infinity();
    float lo[3] = {none, none, none};
    float hi[3] = {-none, -none, -none};
    const LightPlaces& places = search_.places;
    const float* const numbers[3] = {places.u.data(), places.v.data(), places.s.data()};
    std::uint64_t any_root = 0;
    std::uint64_t any_other = 0;
    for (std::size_t row = square.row; row < std::size_t{square.row} + square.side; ++row) {
        const std::uint64_t open = search_.open[row] & square.bits();
        any_root |= open & search_.roots[row];
        any_other |= open & ~search_.roots[row];
        for (std::uint64_t bits = open; bits != 0; bits &= bits - 1) {
            const std::size_t at =
                row * tile_size + static_cast<std::size_t>(std::countr_zero(bits));
            for (int axis = 0; axis < 3; ++axis) {
                lo[axis] = std::min(lo[axis], numbers[axis][at]);
                hi[axis] = std::max(hi[axis], numbers[axis][at]);
            }
        }
    }
    const auto middle = [&](int axis) { return 0.5F * lo[axis] + 0.5F * hi[axis]; };
    const auto radius = [&](int axis) {
        const double from_middle = std::max(hi[axis] - middle(axis), middle(axis) - lo[axis]);
        return static_cast<double>(from_middle) + places.error;
    };
    return {.u = middle(0),
            .v = middle(1),
            .u_radius = radius(0),
            .v_radius = radius(1),
            .s_near = static_cast<double>(lo[2]) - places.error,
            .s_far = static_cast<double>(hi[2]) + places.error,
            .any_root = any_root != 0,
            .any_other = any_other != 0};
}

template <class Real>
void BeamSearch<Real>::add(const Square& square, const Beam* whole) {
    const Places hits = places_of(square);
    if (!hits.any_root && !hits.any_other) return;
    const DepthRange visible =
        search_.rays.depths(hits.u * per_distance_, hits.v * per_distance_,
                            hits.u_radius * per_distance_, hits.v_radius * per_distance_);
    const bool left = whole != nullptr && whole->left;
    Beam beam{.square = square,
              .hits = hits,
              .first_enters = visible.enter_lo,
              .last_enters = visible.enter_hi,
              .to = left ? whole->to : hits.s_far,
              .step = 0.0,
              .left = left,
              .sign = left ? whole->sign : Sign::Unknown};
    if (!(beam.first_enters < beam.to)) return;
    beam.step = std::max(left ? whole->step : first_widths * beam.width(), beam.width());
    if (square.side == 1) return add_ray(beam);
    if (hits.any_root && hits.any_other) return divide(beam);
    const double narrower = std::log2(widest_ / beam.width());
    const int group = std::clamp(static_cast<int>(narrower), 0, width_groups - 1);
    groups_[static_cast<std::size_t>(group)].push_back(beam);
}

template <class Real>
void BeamSearch<Real>::add_ray(const Beam& beam) {
    const auto pixel = static_cast<std::size_t>(beam.square.row * tile_size + beam.square.col);
    rest_.push_back({.pixel = pixel,
                     .u = beam.hits.u * per_distance_,
                     .v = beam.hits.v * per_distance_,
                     .s = 0.5 * (beam.hits.s_near + beam.hits.s_far),
                     .from = beam.first_enters,
                     .to = beam.to,
                     .left = beam.left,
                     .sign = beam.sign,
                     .is_root = beam.hits.any_root});
}

template <class Real>
void BeamSearch<Real>::divide(const Beam& beam) {
    const auto half = static_cast<std::uint8_t>(beam.square.side / 2);
    for (const std::uint8_t down : {std::uint8_t{0}, half}) {
        for (const std::uint8_t right : {std::uint8_t{0}, half}) {
            add({.col = static_cast<std::uint8_t>(beam.square.col + right),
                 .row = static_cast<std::uint8_t>(beam.square.row + down),
                 .side = half},
                &beam);
        }
    }
}

template <class Real>
void BeamSearch<Real>::evaluate(std::span<const Beam> beams) {
    const std::size_t size = padded(beams.size());
    double u_radius = 0.0;
    double v_radius = 0.0;
    for (std::size_t i = 0; i < size; ++i) {
        const Beam& beam = beams[std::min(i, beams.size() - 1)];
        u_radius = std::max(u_radius, beam.hits.u_radius);
        v_radius = std::max(v_radius, beam.hits.v_radius);
        cells_.u[i] = static_cast<Real>(beam.hits.u * per_distance_);
        cells_.v[i] = static_cast<Real>(beam.hits.v * per_distance_);
        const double next = beam.next();
        cells_.s[i] = static_cast<Real>(0.5 * next + 0.5 * beam.to);
        const auto middle = static_cast<double>(cells_.s[i]);
        cells_.s_radius[i] = upper_end(Real{}, std::max(beam.to - middle, middle - next) + margin_);
    }
    frustum_.u_radius = upper_end(Real{}, u_radius * per_distance_);
    frustum_.v_radius = upper_end(Real{}, v_radius * per_distance_);
    counters_.form += beams.size();
    search_.light.kernel.form(
        cells_.batch(size, frustum_, search_.light.scene.uniforms.template boxes<Real>()));
}

template <class Real>
void BeamSearch<Real>::darken(const Square& square) {
    for (std::size_t row = square.row; row < std::size_t{square.row} + square.side; ++row)
        found_.dark[row] |= search_.open[row] & square.bits();
}

template <class Real>
void BeamSearch<Real>::take(Beam& beam, const ShadeVerdict& verdict, std::vector<Beam>& group) {
    const double length = beam.length();
    if (verdict.shade == Shade::Dark && beam.next() >= beam.last_enters) {
        darken(beam.square);
    } else if (verdict.shade == Shade::Free) {
        beam.to = beam.next();
        beam.left = true;
        beam.sign = verdict.sign;
        beam.step *= growth;
        if (beam.first_enters < beam.to) group.push_back(beam);
    } else if (beam.is_long()) {
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
            take(beam, judge(cells_, i, beam.start(), beam.sign), beams);
        }
    }
}

template <class Real>
void BeamSearch<Real>::search() {
    for (int row = 0; row < tile_size; row += first_side) {
        for (int col = 0; col < tile_size; col += first_side) {
            add({.col = static_cast<std::uint8_t>(col),
                 .row = static_cast<std::uint8_t>(row),
                 .side = first_side},
                nullptr);
        }
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
