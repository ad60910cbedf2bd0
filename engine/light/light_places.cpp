#include "engine/light/light_places.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/light/light_places.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/trace/simd/vectors-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A vector of the world that is linear in the column and the row of a pixel of a tile.
struct LinearVector {
    glm::dvec3 first, by_col, by_row;
};

/// The products of such a vector and an axis, in a row of pixels: of the next vector's lanes each
/// time.
class RowProducts {
public:
    RowProducts(const LinearVector& vector, int row, const glm::dvec3& axis) {
        const double first =
            glm::dot(axis, vector.first + static_cast<double>(row) * vector.by_row);
        const double by_col = glm::dot(axis, vector.by_col);
        next_ = hn::MulAdd(hn::Iota(d<float>, 0.0F), number(by_col), number(first));
        step_ = number(static_cast<double>(lanes<float>) * by_col);
    }
    HWY_INLINE V<float> next() {
        const V<float> products = next_;
        next_ = hn::Add(next_, step_);
        return products;
    }

private:
    static V<float> number(double value) { return hn::Set(d<float>, static_cast<float>(value)); }

    V<float> next_, step_;
};

/// The rays of a tile's pixels: start + t direction / |direction|, with t the distance of a hit.
struct TileLines {
    LinearVector start;  ///< from the point that the light looks at
    LinearVector direction;

    TileLines(const TraceFrame& frame, const Tile& tile, const glm::dvec3& look_at) {
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

    PlacesRow(const TileLines& lines, const ViewFrame& eye, const ViewFrame& light, int row)
        : start{{lines.start, row, light.right},
                {lines.start, row, light.up},
                {lines.start, row, light.forward}},
          along{{lines.direction, row, light.right},
                {lines.direction, row, light.up},
                {lines.direction, row, light.forward}},
          right(lines.direction, row, eye.right),
          up(lines.direction, row, eye.up),
          world{{lines.direction, row, {1, 0, 0}},
                {lines.direction, row, {0, 1, 0}},
                {lines.direction, row, {0, 0, 1}}} {}

    /// 1 / |direction| of the next pixels; the directions are 1 along the eye's axis.
    HWY_INLINE V<float> per_length() {
        const V<float> one = hn::Set(d<float>, 1.0F);
        const V<float> x = right.next();
        const V<float> y = up.next();
        return hn::Div(one, hn::Sqrt(hn::MulAdd(x, x, hn::MulAdd(y, y, one))));
    }
};

/// Whether the gradients' products with two directions are of opposite signs.
HWY_INLINE M<float> are_opposite(V<float> a, V<float> b) {
    const V<float> zero = hn::Zero(d<float>);
    return hn::Or(hn::And(hn::Lt(a, zero), hn::Gt(b, zero)),
                  hn::And(hn::Gt(a, zero), hn::Lt(b, zero)));
}

TileBits places_of(const TraceFrame& frame, const ViewFrame& light, const Tile& tile,
                   const TileHits& hits, LightPlaces& places) {
    const glm::dvec3 look_at = light.eye + light.look_distance * light.forward;
    const TileLines lines(frame, tile, look_at);
    float* const out[3] = {places.u.data(), places.v.data(), places.s.data()};
    V<float> to_light[3];
    for (int axis = 0; axis < 3; ++axis)
        to_light[axis] = hn::Set(d<float>, static_cast<float>(-light.forward[axis]));
    V<float> farthest = hn::Zero(d<float>);
    TileBits turned{};

    for (int row = 0; row < tile.rows; ++row) {
        PlacesRow of(lines, frame.view, light, row);
        std::uint64_t bits = 0;
        for (std::size_t col = 0; col < tile_size; col += lanes<float>) {
            const std::size_t at = static_cast<std::size_t>(row) * tile_size + col;
            // Where the hits are.
            const V<float> distance = hn::LoadU(d<float>, &hits.depth[at]);
            const auto is_hit = hn::Lt(distance, hn::Inf(d<float>));
            farthest = hn::Max(farthest, hn::IfThenElseZero(is_hit, hn::Abs(distance)));
            const V<float> length = hn::Mul(distance, of.per_length());
            for (int axis = 0; axis < 3; ++axis) {
                const V<float> place =
                    hn::MulAdd(length, of.along[axis].next(), of.start[axis].next());
                const V<float> before = hn::LoadU(d<float>, out[axis] + at);
                hn::StoreU(hn::IfThenElse(is_hit, place, before), d<float>, out[axis] + at);
            }
            // How they are turned.
            V<float> away_from_eye = hn::Zero(d<float>);
            V<float> to_the_light = hn::Zero(d<float>);
            for (int axis = 0; axis < 3; ++axis) {
                const V<float> gradient =
                    hn::LoadU(d<float>, &hits.gradient[static_cast<std::size_t>(axis)][at]);
                away_from_eye = hn::MulAdd(gradient, of.world[axis].next(), away_from_eye);
                to_the_light = hn::MulAdd(gradient, to_light[axis], to_the_light);
            }
            const auto is_turned = hn::And(is_hit, are_opposite(away_from_eye, to_the_light));
            bits |= std::uint64_t{bits_of(d<float>, is_turned)} << col;
        }
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

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(places_of);

}  // namespace

TileBits find_places(const TraceFrame& frame, const ViewFrame& light, const Tile& tile,
                     const TileHits& hits, LightPlaces& places) {
    return HWY_DYNAMIC_DISPATCH(places_of)(frame, light, tile, hits, places);
}

}  // namespace zeroset

#endif
