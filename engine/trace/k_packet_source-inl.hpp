// The rays of a tile as packets for K-bisection.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_K_PACKET_SOURCE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_K_PACKET_SOURCE_INL
#undef ZEROSET_K_PACKET_SOURCE_INL
#else
#define ZEROSET_K_PACKET_SOURCE_INL
#endif

#include "engine/num/scalar.hpp"
#include "engine/trace/k_packet-inl.hpp"
#include "engine/trace/tolerance.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Makes the packets of a tile, block of pixels by block of pixels. Must outlive them.
class PacketSource {
public:
    PacketSource(const TraceFrame& frame, const Tile& tile);
    /// Sets up the next packet, with the top slices that its rays meet; false when there is none
    /// left.
    bool next(Packet& packet);
    /// The axes for a ray; they live as long as the source.
    const Axes& axes_for(const glm::dvec3& direction);
    /// The direction of the ray of a pixel of the tile.
    [[nodiscard]] glm::dvec3 direction(int col, int row) const {
        return corner_ + static_cast<double>(col) * step_col_ +
               static_cast<double>(row) * step_row_;
    }

private:
    struct HalfPacket;
    struct HalfLines;

    bool next_block();
    void make_axes(Axes& axes, int k, const glm::bvec3& negative) const;
    HalfPacket half_of(const Axes& axes, const glm::dvec3& block, std::size_t half) const;
    static HalfLines lines_of(const Axes& axes, const HalfPacket& rays);
    /// Makes the rays of `bits` alive that meet the clip box.
    static void set_up_lanes(Packet& packet, const HalfLines& low, const HalfLines& high,
                             unsigned bits);
    /// Ends the rays at the tile's limits.
    void limit_lanes(Packet& packet) const;
    /// Chooses the packet's slices; false when no ray is alive.
    bool set_up_slices(Packet& packet) const;
    [[nodiscard]] int epsilon_depth(const Packet& packet, float k_min, float k_max) const;

    const TraceFrame& frame_;
    Tile tile_;
    glm::dvec3 step_col_, step_row_, corner_;  ///< directions: per pixel, and of the tile's first
    int col_ = -block_cols, row_ = 0;
    unsigned pending_ = 0;    ///< rays of the current block not yet in a packet
    Axes axes_[24];           ///< by dominant axis and signs of the direction
    std::uint32_t made_ = 0;  ///< bits of the axes that are made
};

inline PacketSource::PacketSource(const TraceFrame& frame, const Tile& tile)
    : frame_(frame), tile_(tile) {
    const ViewFrame& view = frame.view;
    const double pixel = view.pixel_size(frame.height);
    step_col_ = pixel * view.right;
    step_row_ = -pixel * view.up;
    corner_ = view.direction(tile.col + 0.5, tile.row + 0.5, frame.width, frame.height);
}

inline void PacketSource::make_axes(Axes& axes, int k, const glm::bvec3& negative) const {
    constexpr double tiny = 0x1p-45;
    constexpr double steepest = 4.0;  // slopes of fitting rays
    const Box& clip = frame_.scene.clip;
    for (int i = 0; i < 3; ++i) {
        const int world = (k + i) % 3;
        const bool mirrored = negative[world];
        const double sign = mirrored ? -1.0 : 1.0;
        const double lo = mirrored ? -clip.hi[world] : clip.lo[world];
        const double hi = mirrored ? -clip.lo[world] : clip.hi[world];
        const std::size_t neg_lo_offset = static_cast<std::size_t>(world) * batch_capacity;
        const std::size_t hi_offset = neg_lo_offset + 3 * batch_capacity;
        axes.world[i] = world;
        axes.mirrored[i] = mirrored;
        axes.from_offset[i] = mirrored ? hi_offset : neg_lo_offset;
        axes.to_offset[i] = mirrored ? neg_lo_offset : hi_offset;
        axes.eye[i] = sign * frame_.view.eye[world];
        axes.to_lo[i] = lo - axes.eye[i];
        axes.to_hi[i] = hi - axes.eye[i];
        if (i == 0) axes.k_size = std::max(std::abs(lo), std::abs(hi));
        axes.error[i] =
            tiny * (steepest * (std::abs(axes.eye[0]) + axes.k_size) + std::abs(axes.eye[i]));
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const auto col = static_cast<double>(lane % block_cols);
            const auto row = static_cast<double>(lane / block_cols);
            axes.lane_offset[i][lane] = sign * (col * step_col_[world] + row * step_row_[world]);
        }
    }
    const int depth = bisections(clip, axes.k_size, frame_.stop);
    const int top_depth = std::min(max_top_depth, depth - 1);
    axes.unit = float_above(std::ldexp(clip.size(), -depth));
    axes.origin = -float_above(-(axes.to_lo[0] + axes.eye[0]));
    axes.slice_cells = 1 << (depth - top_depth);
    const float slice = axes.unit * static_cast<float>(axes.slice_cells);
    const float extent = float_above(axes.to_hi[0] + axes.eye[0]) - axes.origin;
    axes.slice_count = static_cast<int>(std::floor(extent / slice)) + 1;
}

inline const Axes& PacketSource::axes_for(const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    const int longest_of_xy = size.x >= size.y ? 0 : 1;
    const int k = size[longest_of_xy] >= size.z ? longest_of_xy : 2;
    const glm::bvec3 negative(direction.x < 0, direction.y < 0, direction.z < 0);
    const int key = 8 * k + (negative.x ? 1 : 0) + (negative.y ? 2 : 0) + (negative.z ? 4 : 0);
    Axes& axes = axes_[key];
    if ((made_ >> key & 1U) == 0) {
        make_axes(axes, k, negative);
        made_ |= 1U << key;
    }
    return axes;
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
            const bool inside =
                col_ + lane % block_cols < tile_.cols && row_ + lane / block_cols < tile_.rows;
            if (!inside) pending_ &= ~(1U << lane);
        }
    }
    return true;
}

/// Half a packet in double: directions, and where the rays enter and leave the clip box.
struct PacketSource::HalfPacket {
    V64 direction[3];
    V64 inverse_k;
    V64 t_in, t_out;

    [[nodiscard]] HWY_INLINE bool all_miss() const { return hn::AllTrue(d64, hn::Gt(t_in, t_out)); }
    /// Bits of the rays for which the axes are good ones: K no shorter than a quarter of the
    /// others, none falling.
    [[nodiscard]] HWY_INLINE unsigned fitting() const {
        const V64 steepest = hn::Mul(hn::Set(d64, 4.0), direction[0]);
        const auto shallow = hn::Le(hn::Max(direction[1], direction[2]), steepest);
        const auto rising = hn::Ge(hn::Min(direction[1], direction[2]), hn::Zero(d64));
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d64, hn::And(shallow, rising), bits);
        return bits[0];
    }
};

HWY_INLINE PacketSource::HalfPacket PacketSource::half_of(const Axes& axes, const glm::dvec3& block,
                                                          std::size_t half) const {
    HalfPacket rays{};
    V64 inverse[3];
    for (int i = 0; i < 3; ++i) {
        const int world = axes.world[i];
        const double first = axes.mirrored[i] ? -block[world] : block[world];
        rays.direction[i] = hn::Add(hn::Set(d64, first), hn::Load(d64, axes.lane_offset[i] + half));
        // Negative directions are of rays that do not fit.
        inverse[i] = hn::Div(hn::Set(d64, 1.0), hn::Max(rays.direction[i], hn::Set(d64, 1e-300)));
    }
    rays.inverse_k = inverse[0];
    rays.t_in = hn::Mul(hn::Set(d64, axes.to_lo[0]), inverse[0]);
    rays.t_out = hn::Mul(hn::Set(d64, axes.to_hi[0]), inverse[0]);
    for (int i = 1; i < 3; ++i) {
        rays.t_in = hn::Max(rays.t_in, hn::Mul(hn::Set(d64, axes.to_lo[i]), inverse[i]));
        rays.t_out = hn::Min(rays.t_out, hn::Mul(hn::Set(d64, axes.to_hi[i]), inverse[i]));
    }
    rays.t_in = hn::Max(rays.t_in, hn::Zero(d64));
    return rays;
}

/// Entries, exits and lines of half a packet: floats that enclose the doubles.
struct PacketSource::HalfLines {
    VHalf k_in, k_out, stretch;
    VHalf slope[2], neg_lo[2], hi[2];
};

HWY_INLINE PacketSource::HalfLines PacketSource::lines_of(const Axes& axes,
                                                          const HalfPacket& rays) {
    const auto demote_up = [](V64 value) { return hn::DemoteTo(d_half, value); };
    const V64 k_eye = hn::Set(d64, axes.eye[0]);
    const V64 k_error = hn::Set(d64, axes.error[0]);
    HalfLines lines{};
    lines.k_in =
        hn::Neg(demote_up(hn::Sub(k_error, hn::MulAdd(rays.t_in, rays.direction[0], k_eye))));
    lines.k_out = demote_up(hn::Add(k_error, hn::MulAdd(rays.t_out, rays.direction[0], k_eye)));
    V64 length2 = hn::Mul(rays.direction[0], rays.direction[0]);
    for (int i = 0; i < 2; ++i) {
        const V64 slope = hn::Mul(rays.direction[i + 1], rays.inverse_k);
        lines.slope[i] = demote_up(slope);
        const V64 slope_error = hn::Abs(hn::Sub(slope, hn::PromoteTo(d64, lines.slope[i])));
        const V64 base = hn::NegMulAdd(slope, k_eye, hn::Set(d64, axes.eye[i + 1]));
        const V64 error =
            hn::MulAdd(slope_error, hn::Set(d64, axes.k_size), hn::Set(d64, axes.error[i + 1]));
        lines.hi[i] = demote_up(hn::Add(base, error));
        lines.neg_lo[i] = demote_up(hn::Sub(error, base));
        length2 = hn::MulAdd(rays.direction[i + 1], rays.direction[i + 1], length2);
    }
    lines.stretch = hn::Div(hn::Sqrt(demote_up(length2)), demote_up(rays.direction[0]));
    return lines;
}

inline bool PacketSource::next(Packet& packet) {
    for (;;) {
        if (pending_ == 0 && !next_block()) return false;
        const glm::dvec3 block = direction(col_, row_);
        const int first = std::countr_zero(pending_);
        const Axes& axes =
            axes_for(direction(col_ + first % block_cols, row_ + first / block_cols));
        const HalfPacket low = half_of(axes, block, 0);
        const HalfPacket high = half_of(axes, block, lanes / 2);
        const unsigned fitting = low.fitting() | high.fitting() << (lanes / 2);
        // The first pending ray always fits; rays that do not share its axes make packets of
        // their own.
        const unsigned mine = pending_ & (fitting | 1U << first);
        pending_ &= ~mine;
        if (low.all_miss() && high.all_miss()) continue;
        packet.axes = &axes;
        packet.col = col_;
        packet.row = row_;
        set_up_lanes(packet, lines_of(axes, low), lines_of(axes, high), mine);
        if (tile_.limits != nullptr) limit_lanes(packet);
        if (set_up_slices(packet)) return true;
    }
}

HWY_INLINE void PacketSource::set_up_lanes(Packet& packet, const HalfLines& low,
                                           const HalfLines& high, unsigned bits) {
    for (int i = 0; i < 2; ++i) {
        Line& line = packet.line[i];
        hn::Store(hn::Combine(d, high.slope[i], low.slope[i]), d, line.slope);
        hn::Store(hn::Combine(d, high.neg_lo[i], low.neg_lo[i]), d, line.neg_lo);
        hn::Store(hn::Combine(d, high.hi[i], low.hi[i]), d, line.hi);
    }
    hn::Store(hn::Combine(d, high.stretch, low.stretch), d, packet.stretch);
    const V in = hn::Combine(d, high.k_in, low.k_in);
    const V out = hn::Combine(d, high.k_out, low.k_out);
    M alive = hn::Le(in, out);
    if (bits != all_lanes) alive = hn::And(alive, mask_of(bits));
    // The other rays stand still at one place, so that they have finite boxes.
    const V anywhere = hn::Set(d, packet.axes->origin);
    hn::Store(hn::VecFromMask(d, alive), d, packet.alive);
    hn::Store(hn::IfThenElse(alive, in, anywhere), d, packet.k_in);
    hn::Store(hn::IfThenElse(alive, out, anywhere), d, packet.k_out);
    hn::Store(hn::Zero(d), d, packet.hit_from);
    hn::Store(hn::Zero(d), d, packet.hit_to);
    packet.hit = 0;
    packet.unsettled = 0;
}

/// Leaves of each ray as many slices behind its limit as its certificate may look at, so that what
/// is found before the limit does not depend on it. With other rules than d_stop slices follow from
/// the rays' ends; those stay.
HWY_NOINLINE void PacketSource::limit_lanes(Packet& packet) const {
    if (frame_.stop.rule != StopRule::DStop) return;
    const Axes& axes = *packet.axes;
    alignas(vector_bytes) float limit[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane)
        limit[lane] = tile_.limits[packet.pixel(static_cast<int>(lane)).index()];
    // Rounded upward, but for the stretch.
    const V grow = hn::Set(d, 1.0F + 0x1p-20F);
    const V along = hn::Mul(hn::Div(hn::Load(d, limit), hn::Load(d, packet.stretch)), grow);
    const V from_eye = hn::Add(along, hn::Set(d, float_above(axes.eye[0])));
    const V spare = hn::Set(d, static_cast<float>(1 + extra_slices) * axes.unit);
    const V in = hn::Load(d, packet.k_in);
    const V out = hn::Min(hn::Load(d, packet.k_out), hn::Add(from_eye, spare));
    const M alive = hn::And(hn::MaskFromVec(hn::Load(d, packet.alive)), hn::Le(in, out));
    const V anywhere = hn::Set(d, axes.origin);
    hn::Store(hn::VecFromMask(d, alive), d, packet.alive);
    hn::Store(hn::IfThenElse(alive, in, anywhere), d, packet.k_in);
    hn::Store(hn::IfThenElse(alive, out, anywhere), d, packet.k_out);
}

/// How often a top slice is halved under the epsilon rule.
inline int PacketSource::epsilon_depth(const Packet& packet, float k_min, float k_max) const {
    float longest = std::numeric_limits<float>::min();  // the packet's Delta [Knoll07, eq. 7]
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const float extent = packet.k_out[lane] - packet.k_in[lane];
        const float u = packet.line[0].slope[lane];
        const float v = packet.line[1].slope[lane];
        longest = std::max(longest, extent * (1 + u * u + v * v));
    }
    const auto packet_share = static_cast<double>((k_max - k_min) / longest);
    const double width = packet_share * frame_.stop.value;  // eq. 6
    const Axes& axes = *packet.axes;
    const auto slice = static_cast<double>(axes.unit * static_cast<float>(axes.slice_cells));
    const int finest = std::countr_zero(static_cast<std::uint32_t>(axes.slice_cells));
    return std::clamp(static_cast<int>(std::ceil(std::log2(slice / width))), 1, finest);
}

inline bool PacketSource::set_up_slices(Packet& packet) const {
    const M alive = hn::MaskFromVec(hn::Load(d, packet.alive));
    if (hn::AllFalse(d, alive)) return false;
    const V far = hn::Set(d, std::numeric_limits<float>::infinity());
    const V in = hn::IfThenElse(alive, hn::Load(d, packet.k_in), far);
    const V out = hn::IfThenElse(alive, hn::Load(d, packet.k_out), hn::Neg(far));
    const float k_min = hn::GetLane(hn::MinOfLanes(d, in));
    const float k_max = hn::GetLane(hn::MaxOfLanes(d, out));
    const Axes& axes = *packet.axes;
    packet.origin = axes.origin;
    packet.unit = axes.unit;
    packet.slice_cells = axes.slice_cells;
    const float slice = axes.unit * static_cast<float>(axes.slice_cells);
    if (frame_.stop.rule == StopRule::Epsilon) {
        packet.slice_cells = 1 << epsilon_depth(packet, k_min, k_max);
        packet.unit = slice / static_cast<float>(packet.slice_cells);
    }
    int first = static_cast<int>((k_min - axes.origin) / slice);
    int last = std::min(axes.slice_count - 1, static_cast<int>((k_max - axes.origin) / slice));
    while (first > 0 && packet.grid(first * packet.slice_cells) > k_min)
        --first;
    while (last < axes.slice_count - 1 && packet.grid((last + 1) * packet.slice_cells) < k_max) {
        ++last;
    }
    const std::uint64_t up_to_last = last >= 63 ? ~0ULL : (2ULL << last) - 1;
    packet.slices = up_to_last & (~0ULL << first);
    packet.pending = 0;
    return true;
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
