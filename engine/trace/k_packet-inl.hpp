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
constexpr int block_cols = lanes == 4 ? 2 : 4;
constexpr int block_rows = static_cast<int>(lanes) / block_cols;
constexpr unsigned all_lanes = (1U << lanes) - 1U;

constexpr float no_k = std::numeric_limits<float>::infinity();

enum class Sign : std::int8_t { Negative = -1, Unknown = 0, Positive = 1 };

/// x_U as a function of K on each ray: between -(neg_lo - slope k) and hi + slope k.
struct Line {
    alignas(64) float slope[lanes];
    alignas(64) float neg_lo[lanes];
    alignas(64) float hi[lanes];
};

/// Rays that march together along an axis. K is world coordinate axis[0], negated if `mirrored`.
struct Packet {
    alignas(64) float k_in[lanes];       ///< where the ray enters the clip box; +inf: a dead ray
    alignas(64) float k_out[lanes];      ///< where it leaves; -inf: a dead ray
    alignas(64) float side[lanes];       ///< sign of f on the slice before the current one; 0: unknown
    alignas(64) float hit_from[lanes];   ///< the slice where the search stopped
    alignas(64) float hit_to[lanes];
    alignas(64) float hit_limit[lanes];  ///< k_out of a stopped ray
    alignas(64) float stretch[lanes];    ///< distance along the ray for 1 along K
    Line line[2];
    double k_eye;
    int axis[3];  ///< K, U, V
    bool mirrored;
    unsigned hit;        ///< bits of the rays that stopped at a root
    unsigned unsettled;  ///< bits of the rays that passed a slice where f is not continuous
    int col, row;        ///< of the block's first pixel in the tile
    // The current slice is [cell, cell + size] * unit; size is a power of two, 1 at d_stop.
    float unit;
    std::int32_t cell, size, root_size;

    [[nodiscard]] float cell_start() const { return static_cast<float>(cell) * unit; }
    [[nodiscard]] float cell_end() const { return static_cast<float>(cell + size) * unit; }
    void descend() { size /= 2; }
    /// To the next slice, up to the parent's sibling where a parent is done.
    void advance() {
        cell += size;
        while (size < root_size && (cell & (2 * size - 1)) == 0) size *= 2;
    }
    /// Rays of `found` end at [from, to]; those of `unclear` go on without a certificate.
    HWY_INLINE void stop_at(M found, M unclear, V from, V to) {
        hit |= bits_of(found);
        unsettled |= bits_of(unclear);
        hn::Store(hn::IfThenElse(unclear, hn::Zero(d), hn::Load(d, side)), d, side);
        const V out = hn::Load(d, k_out);
        hn::Store(hn::IfThenElse(found, from, hn::Load(d, hit_from)), d, hit_from);
        hn::Store(hn::IfThenElse(found, to, hn::Load(d, hit_to)), d, hit_to);
        hn::Store(hn::IfThenElse(found, out, hn::Load(d, hit_limit)), d, hit_limit);
        hn::Store(hn::IfThenElse(found, hn::Set(d, no_k), hn::Load(d, k_in)), d, k_in);
        hn::Store(hn::IfThenElse(found, hn::Set(d, -no_k), out), d, k_out);
    }
    static unsigned bits_of(M mask) {
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(d, mask, bytes);
        return bytes[0] | static_cast<unsigned>(bytes[1]) << 8U;
    }
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
    void set_up_lanes(Packet& packet, const glm::dvec3& block_direction, std::size_t half) const;
    [[nodiscard]] unsigned fitting_lanes(const Packet& packet) const;
    /// Chooses the grid; false when no ray of the packet meets the clip box.
    bool set_up_grid(Packet& packet) const;
    [[nodiscard]] double stop_width(const Packet& packet, double k_min, double k_max) const;

    const TraceFrame& frame_;
    Tile tile_;
    glm::dvec3 step_col_, step_row_, corner_;  ///< directions: per pixel, and of the tile's first
    alignas(64) double lane_offset_[3][lanes];
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
        const auto first = static_cast<std::size_t>(std::countr_zero(pending_));
        choose_axis(packet, block + glm::dvec3(lane_offset_[0][first], lane_offset_[1][first],
                                               lane_offset_[2][first]));
        packet.col = col_;
        packet.row = row_;
        for (std::size_t half = 0; half < lanes; half += lanes / 2) {
            set_up_lanes(packet, block, half);
        }
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
}

/// Lines, entries and exits of half a packet, in double; floats enclose them.
HWY_INLINE void PacketSource::set_up_lanes(Packet& packet, const glm::dvec3& block_direction,
                                           std::size_t half) const {
    const Box& clip = frame_.scene.clip;
    const glm::dvec3& eye = frame_.view.eye;
    const double tiny = 0x1p-45;  // above the relative error of a few operations in double
    V64 direction[3];
    V64 t_in = hn::Zero(d64);
    V64 t_out = hn::Set(d64, std::numeric_limits<double>::infinity());
    for (int i = 0; i < 3; ++i) {
        direction[i] =
            hn::Add(hn::Set(d64, block_direction[i]), hn::Load(d64, lane_offset_[i] + half));
        const V64 nonzero =
            hn::IfThenElse(hn::Eq(direction[i], hn::Zero(d64)), hn::Set(d64, 1e-300), direction[i]);
        const V64 inverse = hn::Div(hn::Set(d64, 1.0), nonzero);
        const V64 a = hn::Mul(hn::Set(d64, clip.lo[i] - eye[i]), inverse);
        const V64 b = hn::Mul(hn::Set(d64, clip.hi[i] - eye[i]), inverse);
        t_in = hn::Max(t_in, hn::Min(a, b));
        t_out = hn::Min(t_out, hn::Max(a, b));
    }
    const int k = packet.axis[0];
    const V64 k_direction = packet.mirrored ? hn::Neg(direction[k]) : direction[k];
    const V64 inverse = hn::Div(hn::Set(d64, 1.0), k_direction);
    const V64 k_eye = hn::Set(d64, packet.k_eye);
    const double k_size = std::max(std::abs(clip.lo[k]), std::abs(clip.hi[k]));
    const V64 k_error = hn::Set(d64, tiny * (k_size + std::abs(packet.k_eye)));
    const auto demote_up = [](V64 value) { return hn::DemoteTo(d_half, value); };
    const auto demote_down = [](V64 value) {
        return hn::Neg(hn::DemoteTo(d_half, hn::Neg(value)));
    };
    const auto misses = hn::Gt(t_in, t_out);
    const V64 k_in = hn::Sub(hn::MulAdd(t_in, k_direction, k_eye), k_error);
    const V64 k_out = hn::Add(hn::MulAdd(t_out, k_direction, k_eye), k_error);
    const V64 never = hn::Set(d64, std::numeric_limits<double>::infinity());
    hn::Store(demote_down(hn::IfThenElse(misses, never, k_in)), d_half, packet.k_in + half);
    hn::Store(demote_up(hn::IfThenElse(misses, hn::Neg(never), k_out)), d_half,
              packet.k_out + half);
    hn::Store(hn::Zero(d_half), d_half, packet.side + half);

    V64 length2 = hn::Mul(k_direction, k_direction);
    for (int i = 0; i < 2; ++i) {
        const int u = packet.axis[i + 1];
        Line& line = packet.line[i];
        const V64 slope = hn::Mul(direction[u], inverse);
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
        length2 = hn::MulAdd(direction[u], direction[u], length2);
    }
    hn::Store(demote_up(hn::Mul(hn::Sqrt(length2), inverse)), d_half, packet.stretch + half);
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

/// The width along K of the cells at which the search stops.
inline double PacketSource::stop_width(const Packet& packet, double k_min, double k_max) const {
    const double domain = frame_.scene.clip.size();
    switch (frame_.stop.rule) {
        case StopRule::DStop: return domain * std::exp2(-frame_.stop.value);
        case StopRule::Delta: return domain * std::exp2(-max_d_stop);
        case StopRule::Epsilon: break;
    }
    double longest = 0.0;  // the packet's Delta [Knoll07, eq. 7]
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const double extent = double{packet.k_out[lane]} - double{packet.k_in[lane]};
        const double u = double{packet.line[0].slope[lane]};
        const double v = double{packet.line[1].slope[lane]};
        if (extent > 0) longest = std::max(longest, extent * (1 + u * u + v * v));
    }
    const double width = (k_max - k_min) * frame_.stop.value / std::max(longest, 1e-300);  // eq. 6
    return std::max(width, domain * std::exp2(-max_d_stop));
}

inline bool PacketSource::set_up_grid(Packet& packet) const {
    const float k_min = hn::GetLane(hn::MinOfLanes(d, hn::Load(d, packet.k_in)));
    const float k_max = hn::GetLane(hn::MaxOfLanes(d, hn::Load(d, packet.k_out)));
    if (!(k_min <= k_max)) return false;
    // Indices stay below 2^23, so that cell ends are exact floats.
    const float largest = std::max(std::abs(k_min), std::abs(k_max));
    const int finest = std::ilogb(std::max(largest, 1e-30F)) + 1 - 23;
    const int exponent =
        std::max(finest, static_cast<int>(std::ilogb(stop_width(packet, double{k_min}, double{k_max}))));
    packet.unit = std::ldexp(1.0F, exponent);
    const float extent = (k_max - k_min) / packet.unit;
    packet.root_size = 1;
    while (static_cast<float>(packet.root_size) < extent) packet.root_size *= 2;
    const auto first = static_cast<std::int32_t>(std::floor(k_min / packet.unit));
    packet.cell = first & ~(packet.root_size - 1);
    packet.size = packet.root_size;
    return true;
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
