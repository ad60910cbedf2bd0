#include "engine/light/light_places.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/light/light_places.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/real/lanes-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A vector of the world that is linear in the column and the row of a pixel of a tile.
struct LinearVector {
    glm::dvec3 first, by_col, by_row;
};

/// Places of the rays of some pixels of a row: to the right of the tile's first pixel, and below
/// the row; or below the first pixel, where the tile has places of its own.
struct RowPlaces {
    V<float> right, down;
};

HWY_INLINE RowPlaces row_places(const Tile& tile, int row, std::size_t col) {
    if (tile.places == nullptr) {
        return {.right = hn::Iota(d<float>, static_cast<float>(col)), .down = hn::Zero(d<float>)};
    }
    const std::size_t at = static_cast<std::size_t>(row) * tile_size + col;
    return {.right = hn::LoadU(d<float>, tile.places->col + at),
            .down = hn::LoadU(d<float>, tile.places->row + at)};
}

/// The products of such a vector and an axis, in a row of pixels.
class RowProducts {
public:
    /// `row`: 0 where places are below the first pixel.
    RowProducts(const LinearVector& vector, int row, const glm::dvec3& axis)
        : first_(number(glm::dot(axis, vector.first + static_cast<double>(row) * vector.by_row))),
          by_col_(number(glm::dot(axis, vector.by_col))),
          by_row_(number(glm::dot(axis, vector.by_row))) {}
    HWY_INLINE V<float> at(const RowPlaces& places) const {
        return hn::MulAdd(places.right, by_col_, hn::MulAdd(places.down, by_row_, first_));
    }

private:
    static V<float> number(double value) { return hn::Set(d<float>, static_cast<float>(value)); }

    V<float> first_, by_col_, by_row_;
};

/// The rays of a tile's pixels: start + t direction / |direction|, with t the distance of a hit.
struct LightLines {
    LinearVector start;  ///< from the point that the light looks at
    LinearVector direction;

    LightLines(const TraceFrame& frame, const Tile& tile, const glm::dvec3& look_at) {
        const auto at = [&](int col, int row) {
            return pixel_centre(tile.col + col, tile.row + row);
        };
        const auto linear = [&](const auto& vector) {
            const glm::dvec3 first = vector(at(0, 0));
            return LinearVector{.first = first,
                                .by_col = vector(at(1, 0)) - first,
                                .by_row = vector(at(0, 1)) - first};
        };
        start = linear([&](const PixelPoint& pixel) {
            return frame.view.origin(pixel, frame.image) - look_at;
        });
        direction = linear(
            [&](const PixelPoint& pixel) { return frame.view.direction(pixel, frame.image); });
    }
};

/// A row of pixels of a tile: what its hits are multiplied by, axis by axis.
struct PlacesRow {
    RowProducts start[3], along[3];  ///< by the light's axes: right, up, forward
    RowProducts right, up;           ///< of directions, by the eye's axes
    RowProducts world[3];            ///< of directions, by x, y and z

    /// 1 / |direction| of some pixels; the directions are 1 along the eye's axis.
    HWY_INLINE V<float> per_length(const RowPlaces& places) const {
        const V<float> one = hn::Set(d<float>, 1.0F);
        const V<float> x = right.at(places);
        const V<float> y = up.at(places);
        return hn::Div(one, hn::Sqrt(hn::MulAdd(x, x, hn::MulAdd(y, y, one))));
    }
};

PlacesRow places_row(const LightLines& lines, const ViewFrame& eye, const ViewFrame& light,
                     int row) {
    return {.start = {{lines.start, row, light.right},
                      {lines.start, row, light.up},
                      {lines.start, row, light.forward}},
            .along = {{lines.direction, row, light.right},
                      {lines.direction, row, light.up},
                      {lines.direction, row, light.forward}},
            .right = {lines.direction, row, eye.right},
            .up = {lines.direction, row, eye.up},
            .world = {{lines.direction, row, {1, 0, 0}},
                      {lines.direction, row, {0, 1, 0}},
                      {lines.direction, row, {0, 0, 1}}}};
}

/// Whether both are above 0, or both below.
HWY_INLINE M<float> have_one_sign(V<float> a, V<float> b) {
    const V<float> zero = hn::Zero(d<float>);
    return hn::Or(hn::And(hn::Gt(a, zero), hn::Gt(b, zero)),
                  hn::And(hn::Lt(a, zero), hn::Lt(b, zero)));
}

/// No steeper than LightPlaces::steepest; 0 where NaN.
HWY_INLINE V<float> within(V<float> change) {
    const V<float> most = hn::Set(d<float>, LightPlaces::steepest);
    const V<float> number = hn::IfThenElseZero(hn::Eq(change, change), change);
    return hn::Max(hn::Min(number, most), hn::Neg(most));
}

/// The light's axes in all lanes.
struct LightAxes {
    V<float> numbers[3][3];

    explicit LightAxes(const ViewFrame& light) {
        const glm::dvec3 axes[3] = {light.right, light.up, light.forward};
        for (int k = 0; k < 3; ++k) {
            for (int i = 0; i < 3; ++i)
                numbers[k][i] = hn::Set(d<float>, static_cast<float>(axes[k][i]));
        }
    }
};

/// The products of gradients with the light's axes, and with the directions of the eye's rays.
struct Slopes {
    V<float> light[3], eye;
};
HWY_INLINE Slopes slopes_at(const TileHits& hits, std::size_t at, const LightAxes& light,
                            const PlacesRow& of, const RowPlaces& places) {
    Slopes slopes;
    slopes.eye = hn::Zero(d<float>);
    for (V<float>& slope : slopes.light)
        slope = hn::Zero(d<float>);
    for (int i = 0; i < 3; ++i) {
        const V<float> gradient =
            hn::LoadU(d<float>, &hits.gradient[static_cast<std::size_t>(i)][at]);
        slopes.eye = hn::MulAdd(gradient, of.world[i].at(places), slopes.eye);
        for (int k = 0; k < 3; ++k)
            slopes.light[k] = hn::MulAdd(gradient, light.numbers[k][i], slopes.light[k]);
    }
    return slopes;
}

HWY_INLINE void store_where(M<float> wanted, V<float> numbers, float* to) {
    hn::StoreU(hn::IfThenElse(wanted, numbers, hn::LoadU(d<float>, to)), d<float>, to);
}

TileBits places_of(const TraceFrame& frame, const ViewFrame& light, const Tile& tile,
                   const TileHits& hits, LightPlaces& places) {
    const LightLines lines(frame, tile, light.look_at());
    float* const out[3] = {places.u.data(), places.v.data(), places.s.data()};
    float* const changes[2] = {places.by_u.data(), places.by_v.data()};
    const LightAxes axes(light);
    V<float> farthest = hn::Zero(d<float>);
    TileBits turned{};

    for (int row = 0; row < tile.rows; ++row) {
        const PlacesRow of = places_row(lines, frame.view, light, tile.places == nullptr ? row : 0);
        std::uint64_t bits = 0;
        std::uint64_t outside = 0;
        for (std::size_t col = 0; col < tile_size; col += lanes<float>) {
            const std::size_t at = static_cast<std::size_t>(row) * tile_size + col;
            const RowPlaces at_rays = row_places(tile, row, col);
            // Put the hits into the light's view.
            const V<float> distance = hn::LoadU(d<float>, &hits.depth[at]);
            const auto is_hit = hn::Lt(distance, hn::Inf(d<float>));
            farthest = hn::Max(farthest, hn::IfThenElseZero(is_hit, hn::Abs(distance)));
            const V<float> length = hn::Mul(distance, of.per_length(at_rays));
            for (int i = 0; i < 3; ++i)
                store_where(is_hit,
                            hn::MulAdd(length, of.along[i].at(at_rays), of.start[i].at(at_rays)),
                            out[i] + at);
            // Find how the surface is turned at them.
            const Slopes slopes = slopes_at(hits, at, axes, of, at_rays);
            const V<float> per_slope = hn::Div(hn::Set(d<float>, -1.0F), slopes.light[2]);
            for (int i = 0; i < 2; ++i)
                store_where(is_hit, within(hn::Mul(slopes.light[i], per_slope)), changes[i] + at);
            const auto is_turned = hn::And(is_hit, have_one_sign(slopes.eye, slopes.light[2]));
            bits |= std::uint64_t{bits_of(d<float>, is_turned)} << col;
            const auto is_outside = hn::And(is_turned, hn::Lt(slopes.eye, hn::Zero(d<float>)));
            outside |= std::uint64_t{bits_of(d<float>, is_outside)} << col;
        }
        places.outside[static_cast<std::size_t>(row)] |= outside;
        turned[static_cast<std::size_t>(row)] = bits & ~std::uint64_t{0} >> (tile_size - tile.cols);
    }

    // Some 15 roundings of numbers no larger than these.
    const double most = static_cast<double>(hn::GetLane(hn::MaxOfLanes(d<float>, farthest)));
    const double size =
        most + glm::length(lines.start.first) +
        tile_size * (glm::length(lines.start.by_col) + glm::length(lines.start.by_row));
    places.error = std::max(places.error, 0x1p-19 * size);
    return turned;
}

TileBits places_in_box(const LightPlaces& places, const TileBits& bits, const LightBox& box) {
    const auto number = [](double value) { return hn::Set(d<float>, static_cast<float>(value)); };
    // Wider than rounding makes the numbers narrower.
    const double spare = 2.0 * places.error;
    const V<float> u[2] = {number(box.u[0] - spare), number(box.u[1] + spare)};
    const V<float> v[2] = {number(box.v[0] - spare), number(box.v[1] + spare)};
    const V<float> s[2] = {number(box.s[0] - spare), number(box.s[1] + spare)};
    TileBits found{};
    for (std::size_t row = 0; row < tile_size; ++row) {
        if (bits[row] == 0) continue;
        for (std::size_t col = 0; col < tile_size; col += lanes<float>) {
            const std::size_t at = row * tile_size + col;
            const V<float> place_u = hn::LoadU(d<float>, &places.u[at]);
            const V<float> place_v = hn::LoadU(d<float>, &places.v[at]);
            const V<float> place_s = hn::LoadU(d<float>, &places.s[at]);
            const auto in_u = hn::And(hn::Ge(place_u, u[0]), hn::Le(place_u, u[1]));
            const auto in_v = hn::And(hn::Ge(place_v, v[0]), hn::Le(place_v, v[1]));
            const auto in_s = hn::And(hn::Ge(place_s, s[0]), hn::Le(place_s, s[1]));
            const auto is_in = hn::And(hn::And(in_u, in_v), in_s);
            found[row] |= std::uint64_t{bits_of(d<float>, is_in)} << col;
        }
        found[row] &= bits[row];
    }
    return found;
}

/// The least and the greatest of some numbers, lane by lane.
template <class D>
struct LaneBounds {
    hn::Vec<D> least, greatest;

    HWY_INLINE LaneBounds() : least(hn::Inf(D())), greatest(hn::Neg(hn::Inf(D()))) {}
    HWY_INLINE void add(hn::Vec<D> numbers, hn::Mask<D> wanted) {
        least = hn::Min(least, hn::IfThenElse(wanted, numbers, hn::Inf(D())));
        greatest = hn::Max(greatest, hn::IfThenElse(wanted, numbers, hn::Neg(hn::Inf(D()))));
    }
    [[nodiscard]] HWY_INLINE PlaceRange range() const {
        return {.least = hn::GetLane(hn::MinOfLanes(D(), least)),
                .greatest = hn::GetLane(hn::MaxOfLanes(D(), greatest))};
    }
};

PlaceBounds bounds_in(const LightPlaces& places, const TileBits& bits, const Square& square,
                      float by_u, float by_v) {
    const hn::CappedTag<float, 8> tag;
    using D = decltype(tag);
    const auto slope_u = hn::Set(tag, -by_u);
    const auto slope_v = hn::Set(tag, -by_v);
    LaneBounds<D> u_bounds, v_bounds, s_bounds, h_bounds;
    for (std::size_t row = square.row; row < std::size_t{square.row} + square.side; ++row) {
        for (std::size_t col = square.col; col < std::size_t{square.col} + square.side;
             col += hn::MaxLanes(tag)) {
            const auto wanted =
                mask_of(tag, static_cast<LaneBits>((bits[row] & square.bits()) >> col & 0xFFU));
            const std::size_t at = row * tile_size + col;
            const auto u = hn::LoadU(tag, &places.u[at]);
            const auto v = hn::LoadU(tag, &places.v[at]);
            const auto s = hn::LoadU(tag, &places.s[at]);
            u_bounds.add(u, wanted);
            v_bounds.add(v, wanted);
            s_bounds.add(s, wanted);
            h_bounds.add(hn::MulAdd(slope_u, u, hn::MulAdd(slope_v, v, s)), wanted);
        }
    }
    return {
        .u = u_bounds.range(), .v = v_bounds.range(), .s = s_bounds.range(), .h = h_bounds.range()};
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(places_of);
HWY_EXPORT(bounds_in);
HWY_EXPORT(places_in_box);

}  // namespace

TileBits find_places(const TraceFrame& frame, const ViewFrame& light, const Tile& tile,
                     const TileHits& hits, LightPlaces& places) {
    return HWY_DYNAMIC_DISPATCH(places_of)(frame, light, tile, hits, places);
}

TileBits places_in(const LightPlaces& places, const TileBits& bits, const LightBox& box) {
    return HWY_DYNAMIC_DISPATCH(places_in_box)(places, bits, box);
}

PlaceBounds bounds_of(const LightPlaces& places, const TileBits& bits, const Square& square,
                      float by_u, float by_v) {
    return HWY_DYNAMIC_DISPATCH(bounds_in)(places, bits, square, by_u, by_v);
}

}  // namespace zeroset

#endif
