// A packet of rays for K-bisection. Included once for each instruction set, after Highway.

#if defined(ZEROSET_K_PACKET_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_K_PACKET_INL
#undef ZEROSET_K_PACKET_INL
#else
#define ZEROSET_K_PACKET_INL
#endif

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <hwy/highway.h>

#include "engine/num/scalar.hpp"
#include "engine/trace/tracer.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;
using DUint = hn::RebindToUnsigned<D>;
using D64 = hn::Repartition<double, D>;
using DHalf = hn::Half<D>;
using V = hn::Vec<D>;
using V64 = hn::Vec<D64>;
using M = hn::Mask<D>;
constexpr D d;
constexpr DUint du;
constexpr D64 d64;
constexpr DHalf d_half;
constexpr std::size_t lanes = hn::MaxLanes(d);
constexpr std::size_t vector_bytes = lanes * sizeof(float);
constexpr int block_cols = lanes == 4 ? 2 : 4;
constexpr int block_rows = static_cast<int>(lanes) / block_cols;
constexpr unsigned all_lanes = (1U << lanes) - 1U;

constexpr int group_size = 16;  ///< packets a batch
constexpr std::size_t batch_capacity = group_size * lanes;

constexpr float no_k = std::numeric_limits<float>::infinity();

enum class Sign : std::int8_t { Negative = -1, Unknown = 0, Positive = 1 };

/// x_U as a function of K on each ray: between -(neg_lo - slope k) and hi + slope k.
struct Line {
    alignas(vector_bytes) float slope[lanes];
    alignas(vector_bytes) float neg_lo[lanes];
    alignas(vector_bytes) float hi[lanes];
    std::size_t neg_lo_offset;  ///< of the coordinate's -lo in a batch, in floats
};

/// Rays that march together along an axis. K is world coordinate axis[0], negated if `mirrored`.
struct Packet {
    alignas(vector_bytes) float k_in[lanes];       ///< where the ray enters the clip box; +inf: a dead ray
    alignas(vector_bytes) float k_out[lanes];      ///< where it leaves; -inf: a dead ray
    alignas(vector_bytes) float hit_from[lanes];   ///< the slice where the search stopped
    alignas(vector_bytes) float hit_to[lanes];
    alignas(vector_bytes) float hit_start[lanes];  ///< k_in of a stopped ray
    alignas(vector_bytes) float hit_limit[lanes];  ///< k_out of a stopped ray
    alignas(vector_bytes) float stretch[lanes];    ///< distance along the ray for 1 along K
    Line line[2];
    std::size_t k_from_offset, k_to_offset;  ///< where a batch holds -from and to, in floats
    double k_eye;
    int axis[3];  ///< K, U, V
    bool mirrored;
    unsigned hit;        ///< bits of the rays that stopped at a root
    unsigned unsettled;  ///< bits of the rays that passed a slice where f is not continuous
    int col, row;        ///< of the block's first pixel in the tile
    // The current slice goes from grid(cell) to grid(cell + size); size is a power of two, 1 at
    // d_stop.
    float origin, unit;
    std::int32_t cell, size, root_size;
    std::int32_t first_cell;  ///< a slice of d_stop not behind the first ray's entry

    /// The floats that divide K: increasing, and equal for equal indices.
    [[nodiscard]] float grid(std::int32_t index) const {
        return origin + static_cast<float>(index) * unit;
    }
    [[nodiscard]] float cell_start() const { return grid(cell); }
    [[nodiscard]] float cell_end() const { return grid(cell + size); }
    /// To a half of the slice (the first that a ray may meet), or to the next slice: the largest
    /// of the grid that starts where this one ends, as bisection would reach it. Arithmetic
    /// instead of branches, as none could be foreseen.
    void go_on(bool descend) {
        const auto keep = -static_cast<std::int32_t>(descend);
        const std::int32_t next = cell + size;
        const std::int32_t half = size / 2;
        const std::int32_t skip = cell + half <= first_cell ? half : 0;
        // The largest power of two that divides `next` (all of them if it is 0), less one.
        const std::uint32_t ones = (static_cast<std::uint32_t>(next) - 1U) & ~static_cast<std::uint32_t>(next);
        const auto widest = static_cast<std::int32_t>(
            std::min(ones, static_cast<std::uint32_t>(root_size) - 1U) + 1U);
        cell = ((cell + skip) & keep) | (next & ~keep);
        size = (half & keep) | (widest & ~keep);
    }
    /// Rays of `found` end in the current slice; those of `unclear` go on without a certificate.
    HWY_INLINE void stop_at(M found, M unclear) {
        hit |= bits_of(found);
        unsettled |= bits_of(unclear);
        const V in = hn::Load(d, k_in);
        const V out = hn::Load(d, k_out);
        const V from = hn::Max(hn::Set(d, cell_start()), in);
        const V to = hn::Min(hn::Set(d, cell_end()), out);
        hn::Store(hn::IfThenElse(found, from, hn::Load(d, hit_from)), d, hit_from);
        hn::Store(hn::IfThenElse(found, to, hn::Load(d, hit_to)), d, hit_to);
        hn::Store(hn::IfThenElse(found, in, hn::Load(d, hit_start)), d, hit_start);
        hn::Store(hn::IfThenElse(found, out, hn::Load(d, hit_limit)), d, hit_limit);
        hn::Store(hn::IfThenElse(found, hn::Set(d, no_k), in), d, k_in);
        hn::Store(hn::IfThenElse(found, hn::Set(d, -no_k), out), d, k_out);
    }
    static unsigned bits_of(M mask) {
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(d, mask, bytes);
        return bytes[0] | static_cast<unsigned>(bytes[1]) << 8U;
    }
};

/// Directions of half a packet and where they enter and leave the clip box, in double.
struct HalfPacket {
    V64 direction[3], inverse[3];
    V64 t_in, t_out;
};

/// Makes the packets of a tile, block of pixels by block of pixels.
class PacketSource {
public:
    PacketSource(const TraceFrame& frame, const Tile& tile);
    /// Sets up the next packet; false when there is none left.
    bool next(Packet& packet);

private:
    bool next_block();
    void choose_axis(Packet& packet, const glm::dvec3& direction) const;
    [[nodiscard]] HalfPacket clipped_half(const glm::dvec3& block_direction,
                                          std::size_t half) const;
    void set_up_half(Packet& packet, const HalfPacket& rays, std::size_t half) const;
    [[nodiscard]] unsigned fitting_lanes(const Packet& packet) const;
    /// Chooses the grid; false when no ray of the packet meets the clip box.
    bool set_up_grid(Packet& packet) const;
    [[nodiscard]] float epsilon_unit(const Packet& packet, float k_min, float k_max) const;

    const TraceFrame& frame_;
    Tile tile_;
    glm::dvec3 step_col_, step_row_, corner_;  ///< directions: per pixel, and of the tile's first
    alignas(vector_bytes) double lane_offset_[3][lanes];
    float unit_[3];  ///< width of the slices of d_stop along each axis
    int col_ = -block_cols, row_ = 0;
    unsigned pending_ = 0;  ///< rays of the current block not yet in a packet
};

inline PacketSource::PacketSource(const TraceFrame& frame, const Tile& tile)
    : frame_(frame), tile_(tile) {
    const ViewFrame& view = frame.view;
    const double pixel = view.pixel_size(frame.height);
    step_col_ = pixel * view.right;
    step_row_ = -pixel * view.up;
    corner_ = view.direction(tile.col + 0.5, tile.row + 0.5, frame.width, frame.height);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const auto col = static_cast<double>(lane % block_cols);
        const auto row = static_cast<double>(lane / block_cols);
        const glm::dvec3 offset = col * step_col_ + row * step_row_;
        for (int i = 0; i < 3; ++i) lane_offset_[i][lane] = offset[i];
    }
    const double d_stop = frame.stop.rule == StopRule::DStop ? frame.stop.value : max_d_stop;
    const Box& clip = frame.scene.clip;
    for (int i = 0; i < 3; ++i) {
        // No finer than two ulp of the largest coordinate.
        const double largest = std::max(std::abs(clip.lo[i]), std::abs(clip.hi[i]));
        const double finest = std::ldexp(1.0, std::ilogb(largest) + 2 - 23);
        unit_[i] = float_above(std::max(finest, clip.size() * std::exp2(-d_stop)));
    }
}

inline bool PacketSource::next_block() {
    col_ += block_cols;
    if (col_ >= tile_.cols) {
        col_ = 0;
        row_ += block_rows;
    }
    if (row_ >= tile_.rows) return false;
    pending_ = all_lanes;
    if (col_ + block_cols > tile_.cols || row_ + block_rows > tile_.rows) {
        for (int lane = 0; lane < static_cast<int>(lanes); ++lane) {
            const bool inside = col_ + lane % block_cols < tile_.cols &&
                                row_ + lane / block_cols < tile_.rows;
            if (!inside) pending_ &= ~(1U << lane);
        }
    }
    return true;
}

inline bool PacketSource::next(Packet& packet) {
    for (;;) {
        if (pending_ == 0 && !next_block()) return false;
        const glm::dvec3 block =
            corner_ + static_cast<double>(col_) * step_col_ + static_cast<double>(row_) * step_row_;
        const HalfPacket halves[2] = {clipped_half(block, 0), clipped_half(block, lanes / 2)};
        const bool all_miss = hn::AllTrue(d64, hn::Gt(halves[0].t_in, halves[0].t_out)) &&
                              hn::AllTrue(d64, hn::Gt(halves[1].t_in, halves[1].t_out));
        if (all_miss) {
            pending_ = 0;
            continue;
        }
        const auto first = static_cast<std::size_t>(std::countr_zero(pending_));
        choose_axis(packet, block + glm::dvec3(lane_offset_[0][first], lane_offset_[1][first],
                                               lane_offset_[2][first]));
        packet.col = col_;
        packet.row = row_;
        set_up_half(packet, halves[0], 0);
        set_up_half(packet, halves[1], lanes / 2);
        // The first pending ray always fits; rays that do not share its axis make packets of
        // their own.
        const unsigned mine = pending_ & (fitting_lanes(packet) | 1U << first);
        pending_ &= ~mine;
        for (std::size_t lane = 0; mine != all_lanes && lane < lanes; ++lane) {
            if ((mine >> lane & 1U) != 0) continue;
            packet.k_in[lane] = no_k;
            packet.k_out[lane] = -no_k;
        }
        if (set_up_grid(packet)) return true;
    }
}

inline void PacketSource::choose_axis(Packet& packet, const glm::dvec3& direction) const {
    const glm::dvec3 size = glm::abs(direction);
    const int k = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    packet.axis[0] = k;
    packet.axis[1] = (k + 1) % 3;
    packet.axis[2] = (k + 2) % 3;
    packet.mirrored = direction[k] < 0;
    packet.k_eye = packet.mirrored ? -frame_.view.eye[k] : frame_.view.eye[k];
    packet.hit = 0;
    packet.unsettled = 0;
    // A batch holds -lo of x, y, z, then hi of x, y, z; mirroring swaps the ends of K.
    const auto k_offset = static_cast<std::size_t>(k) * batch_capacity;
    packet.k_from_offset = k_offset + (packet.mirrored ? 3 * batch_capacity : 0);
    packet.k_to_offset = k_offset + (packet.mirrored ? 0 : 3 * batch_capacity);
    for (int i = 0; i < 2; ++i) {
        packet.line[i].neg_lo_offset = static_cast<std::size_t>(packet.axis[i + 1]) * batch_capacity;
    }
}

HWY_INLINE HalfPacket PacketSource::clipped_half(const glm::dvec3& block_direction,
                                                 std::size_t half) const {
    const Box& clip = frame_.scene.clip;
    const glm::dvec3& eye = frame_.view.eye;
    HalfPacket rays{};
    rays.t_in = hn::Zero(d64);
    rays.t_out = hn::Set(d64, std::numeric_limits<double>::infinity());
    for (int i = 0; i < 3; ++i) {
        const V64 direction =
            hn::Add(hn::Set(d64, block_direction[i]), hn::Load(d64, lane_offset_[i] + half));
        const V64 nonzero =
            hn::IfThenElse(hn::Eq(direction, hn::Zero(d64)), hn::Set(d64, 1e-300), direction);
        rays.direction[i] = direction;
        rays.inverse[i] = hn::Div(hn::Set(d64, 1.0), nonzero);
        const V64 a = hn::Mul(hn::Set(d64, clip.lo[i] - eye[i]), rays.inverse[i]);
        const V64 b = hn::Mul(hn::Set(d64, clip.hi[i] - eye[i]), rays.inverse[i]);
        rays.t_in = hn::Max(rays.t_in, hn::Min(a, b));
        rays.t_out = hn::Min(rays.t_out, hn::Max(a, b));
    }
    return rays;
}

/// Entries, exits and lines of half a packet: floats that enclose the doubles.
HWY_INLINE void PacketSource::set_up_half(Packet& packet, const HalfPacket& rays,
                                          std::size_t half) const {
    const Box& clip = frame_.scene.clip;
    const glm::dvec3& eye = frame_.view.eye;
    const double tiny = 0x1p-45;  // above the relative error of a few operations in double
    const int k = packet.axis[0];
    const V64 sign = hn::Set(d64, packet.mirrored ? -1.0 : 1.0);
    const V64 k_direction = hn::Mul(sign, rays.direction[k]);
    const V64 inverse = hn::Mul(sign, rays.inverse[k]);
    const V64 k_eye = hn::Set(d64, packet.k_eye);
    const double k_size = std::max(std::abs(clip.lo[k]), std::abs(clip.hi[k]));
    const V64 k_error = hn::Set(d64, tiny * (k_size + std::abs(packet.k_eye)));
    const auto demote_up = [](V64 value) { return hn::DemoteTo(d_half, value); };
    const auto misses = hn::Gt(rays.t_in, rays.t_out);
    const V64 never = hn::Set(d64, std::numeric_limits<double>::infinity());
    const V64 k_neg_in = hn::Sub(k_error, hn::MulAdd(rays.t_in, k_direction, k_eye));
    const V64 k_out = hn::Add(k_error, hn::MulAdd(rays.t_out, k_direction, k_eye));
    const V64 neg_never = hn::Neg(never);
    hn::Store(hn::Neg(demote_up(hn::IfThenElse(misses, neg_never, k_neg_in))), d_half,
              packet.k_in + half);
    hn::Store(demote_up(hn::IfThenElse(misses, neg_never, k_out)), d_half, packet.k_out + half);

    V64 length2 = hn::Mul(k_direction, k_direction);
    for (int i = 0; i < 2; ++i) {
        const int u = packet.axis[i + 1];
        Line& line = packet.line[i];
        const V64 slope = hn::Mul(rays.direction[u], inverse);
        const auto slope_float = demote_up(slope);
        const V64 slope_error = hn::Abs(hn::Sub(slope, hn::PromoteTo(d64, slope_float)));
        const V64 base = hn::NegMulAdd(slope, k_eye, hn::Set(d64, eye[u]));
        const V64 size = hn::MulAdd(hn::Abs(slope), hn::Set(d64, std::abs(packet.k_eye) + k_size),
                                    hn::Set(d64, std::abs(eye[u])));
        const V64 error = hn::MulAdd(slope_error, hn::Set(d64, k_size),
                                     hn::Mul(hn::Set(d64, tiny), size));
        hn::Store(slope_float, d_half, line.slope + half);
        hn::Store(demote_up(hn::Add(base, error)), d_half, line.hi + half);
        hn::Store(demote_up(hn::Sub(error, base)), d_half, line.neg_lo + half);
        length2 = hn::MulAdd(rays.direction[u], rays.direction[u], length2);
    }
    const auto length = hn::Sqrt(demote_up(length2));
    hn::Store(hn::Mul(length, demote_up(inverse)), d_half, packet.stretch + half);
}

/// Bits of the rays for which the packet's axis is a good one: forward, and no shorter than a
/// quarter of the others.
HWY_INLINE unsigned PacketSource::fitting_lanes(const Packet& packet) const {
    const V steepest = hn::Set(d, 4.0F);
    const M forward = hn::Gt(hn::Load(d, packet.stretch), hn::Zero(d));
    const V slope = hn::Max(hn::Abs(hn::Load(d, packet.line[0].slope)),
                            hn::Abs(hn::Load(d, packet.line[1].slope)));
    const M fits = hn::And(forward, hn::Le(slope, steepest));
    return hn::AllTrue(d, fits) ? all_lanes : Packet::bits_of(fits);
}

/// The width along K of the slices at which the search stops under the epsilon rule.
inline float PacketSource::epsilon_unit(const Packet& packet, float k_min, float k_max) const {
    float longest = std::numeric_limits<float>::min();  // the packet's Delta [Knoll07, eq. 7]
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const float extent = packet.k_out[lane] - packet.k_in[lane];
        const float u = packet.line[0].slope[lane];
        const float v = packet.line[1].slope[lane];
        if (extent > 0) longest = std::max(longest, extent * (1 + u * u + v * v));
    }
    const double width = double{(k_max - k_min) / longest} * frame_.stop.value;  // eq. 6
    return std::max(unit_[packet.axis[0]], static_cast<float>(width));
}

inline bool PacketSource::set_up_grid(Packet& packet) const {
    const float k_min = hn::GetLane(hn::MinOfLanes(d, hn::Load(d, packet.k_in)));
    const float k_max = hn::GetLane(hn::MaxOfLanes(d, hn::Load(d, packet.k_out)));
    if (!(k_min <= k_max)) return false;
    packet.unit = frame_.stop.rule == StopRule::Epsilon ? epsilon_unit(packet, k_min, k_max)
                                                        : unit_[packet.axis[0]];
    const int k = packet.axis[0];
    const Box& clip = frame_.scene.clip;
    packet.origin = -float_above(packet.mirrored ? clip.hi[k] : -clip.lo[k]);
    // The search starts with slices of a half to all of the packet's extent.
    const auto extent = static_cast<std::uint32_t>((k_max - k_min) / packet.unit);
    packet.root_size = static_cast<std::int32_t>(std::bit_floor(std::max(extent, 1U)));
    packet.first_cell = static_cast<std::int32_t>(std::floor((k_min - packet.origin) / packet.unit)) - 1;
    packet.cell = packet.first_cell & ~(packet.root_size - 1);
    packet.size = packet.root_size;
    return true;
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
