#pragma once

#include "engine/real/field.hpp"
#include "engine/volume/geometry.hpp"
#include "engine/volume/samples.hpp"

#include <cstddef>
#include <cstdint>

// Questions to a volume for many lanes at once, in the machine's widest vectors: as in
// index_box.hpp and trilinear.hpp. Arrays hold a number for each lane; those beyond `count` mean
// nothing, if they are computed at all. A lane's numbers do not depend on the others. In any
// rounding mode.

namespace zeroset {

/// The most lanes at once.
inline constexpr std::size_t most_lanes = 16;
using Lanes16 = double[most_lanes];

/// Boxes in the world and in indices, as IndexBox.
struct BoxLanes {
    alignas(64) Lanes16 lo[3], hi[3];  ///< in the world
    Lanes16 from[3], to[3], terms[3];
    Lanes16 first[3], last[3];  ///< the cells that hold them
    std::uint32_t inside;       ///< bits of the lanes that are surely in the grid
    std::size_t count;          ///< lanes that are asked for
};
void place_boxes(const IndexMap& map, const GridSize& size, BoxLanes& boxes);

/// Parts of boxes, each in one cell.
struct CellParts {
    static constexpr std::size_t most = 64;
    using Numbers = double[most];

    alignas(64) Numbers corners[8];  ///< samples, the first axis running fastest
    Numbers from[3], to[3];          ///< shares of the cell
    Numbers lo, hi;                  ///< of the values, and of the slopes by the indices
    Numbers slope_lo[3], slope_hi[3];
    Numbers largest;  ///< the largest sample, in size; not a number or infinite in holes
    std::size_t count;
};
/// Encloses the values and the slopes over the parts.
void enclose_parts(CellParts& parts);

/// Points in the world, and in indices.
struct PointLanes {
    alignas(64) Lanes16 at[3];        ///< in the world
    Lanes16 cell[3];                  ///< that holds them
    Lanes16 share[3], share_rest[3];  ///< of the cell, as sums of two numbers
    Lanes16 corners[8];
    Lanes16 value;
    Lanes16 slope[3];      ///< in the world
    std::uint32_t inside;  ///< bits of the lanes that are in the grid
    std::size_t count;     ///< lanes that are asked for
};
/// Whether numbers are computed as sums of two doubles, far beyond the digits of long double, or in
/// double.
enum class Digits : std::uint8_t { Double, TwoDoubles };
/// Finds the cells of points and where they are in them. Where the machine cannot multiply and add
/// at once no lane is inside with TwoDoubles.
void place_points(const IndexMap& map, const GridSize& size, Digits digits, PointLanes& points);
/// Makes values and slopes from the corners.
void mix_points(const IndexMap& map, Digits digits, bool with_slopes, PointLanes& points);

/// The part of a kernel's unit that roundings of values take, which are computed with more digits.
inline constexpr double wide_share = 0x1p-8;

/// Bounds over boxes in the grid without holes.
struct FormLanes {
    alignas(64) Lanes16 lo, hi, largest;
    Lanes16 slope_lo[3], slope_hi[3];  ///< by the indices
};
/// Columns of FieldForm::answers.
template <class Real>
struct FormColumns {
    alignas(64) Real column[FieldForm::answers][most_lanes];
};
/// Makes the columns of all lanes, rounded outward. `unit`: the relative error of one operation in
/// the values at the middles.
void make_forms(const IndexMap& map, const BoxLanes& boxes, const PointLanes& middles, double unit,
                const FormLanes& forms, FormColumns<float>& columns);
void make_forms(const IndexMap& map, const BoxLanes& boxes, const PointLanes& middles, double unit,
                const FormLanes& forms, FormColumns<double>& columns);

}  // namespace zeroset
