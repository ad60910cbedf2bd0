// Bisection of packets of rays in the ray parameter [Knoll07, sec. 6.5 and table 1]: what
// K-bisection is compared with there.
//   T       the packet's stretch [t1, t2]      F       the interval extension of f over T of a ray
// All rays of a packet share the halvings of T, of which each looks at the part where it is seen;
// T is rejected where F excludes 0 on all rays that have got there.
//
// Differs from the paper:
// - A packet is a square of 4 x 4 rays, and 16 packets take each step together, so that the kernel
//   works on a batch.
// - T is that between the rays' first entry and last exit, for all the same; t is the depth along
//   the view axis.
// - Rays on whose part of T an earlier F excluded 0 do not keep T alive.
// - The threshold is the finest one of the packet's rays; what is that narrow is decided by
//   RootDecision.

#include "engine/trace/in_precision.hpp"
#include "papers/along_rays/hit_writer.hpp"
#include "papers/along_rays/ray_field.hpp"
#include "papers/along_rays/root_decision.hpp"
#include "papers/along_rays/tracers_along_rays.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace zeroset {
namespace {

constexpr std::uint32_t packet_side = 4;
constexpr std::size_t packet_rays = std::size_t{packet_side} * packet_side;
constexpr std::size_t most_packets = most_tasks / packet_rays;

/// A bit for each ray of a packet.
using RayBits = std::uint32_t;

/// A stretch that all rays of a packet share, and the rays that may have a root in it.
struct SharedStretch {
    double from, to;
    RayBits rays;
};

struct Packet {
    std::array<std::uint32_t, packet_rays> pixels;
    std::size_t count = 0;
    RayBits alive = 0;
    double finest = std::numeric_limits<double>::infinity();
    std::vector<SharedStretch> stretches;  ///< the nearest is the last
};

template <class Real>
struct PacketMemory {
    RayField<Real> field;
    std::vector<Packet> packets;
    std::vector<std::size_t> active;
    std::vector<RayTask> last;
};

template <class Real>
class PacketSearch {
public:
    PacketSearch(const TileRays& rays, TileHits& hits, PacketMemory<Real>& memory)
        : field_(memory.field),
          memory_(memory),
          decision_(memory.field),
          writer_(rays, memory.field.lines, hits) {}

    void run() {
        begin();
        std::vector<std::size_t>& active = memory_.active;
        while (!active.empty()) {
            for (std::size_t first = 0; first < active.size(); first += most_packets) {
                if (field_.frame->stopped()) return leave();
                const std::size_t count = std::min(most_packets, active.size() - first);
                step(std::span(active).subspan(first, count));
            }
            std::erase_if(active, [&](std::size_t i) { return !has_next(memory_.packets[i]); });
        }
    }

private:
    void begin();
    void add(std::uint32_t pixel);
    /// Drops stretches that no living ray needs; false when none is left.
    static bool has_next(Packet& packet);
    void leave();
    void step(std::span<const std::size_t> which);
    /// Takes F over the packet's nearest stretch; `box`: of its first ray.
    void take(Packet& packet, std::size_t box);
    [[nodiscard]] Stretch part_of(std::uint32_t pixel, const SharedStretch& shared) const {
        const RayLine& line = field_.lines.of(pixel);
        return {.from = std::clamp(shared.from, line.from, line.to),
                .to = std::clamp(shared.to, line.from, line.to)};
    }

    RayField<Real>& field_;
    PacketMemory<Real>& memory_;
    RootDecision<Real> decision_;
    HitWriter writer_;
    struct Owner {
        std::size_t packet;
        RayBits ray;
    };
    std::array<std::size_t, std::size_t{tile_size} * tile_size / packet_rays> packet_at_{};
    std::array<Owner, std::size_t{tile_size} * tile_size> owners_{};
};

template <class Real>
void PacketSearch<Real>::add(std::uint32_t pixel) {
    constexpr std::uint32_t across = tile_size / packet_side;
    const std::uint32_t col = pixel % tile_size / packet_side;
    const std::uint32_t row = pixel / tile_size / packet_side;
    std::size_t& at = packet_at_[row * across + col];
    if (at == 0) {
        memory_.packets.emplace_back();
        at = memory_.packets.size();
    }
    Packet& packet = memory_.packets[at - 1];
    const RayLine& line = field_.lines.of(pixel);
    const RayBits bit = RayBits{1} << packet.count;
    if (packet.stretches.empty())
        packet.stretches.push_back({.from = line.from, .to = line.to, .rays = 0});
    SharedStretch& whole = packet.stretches.front();
    whole.from = std::min(whole.from, line.from);
    whole.to = std::max(whole.to, line.to);
    whole.rays |= bit;
    packet.alive |= bit;
    packet.finest = std::min(packet.finest, field_.lines.finest(line, line.from));
    owners_[pixel] = {.packet = at - 1, .ray = bit};
    packet.pixels[packet.count++] = pixel;
}

template <class Real>
void PacketSearch<Real>::begin() {
    memory_.packets.clear();
    for (const std::uint32_t pixel : field_.lines.pixels())
        add(pixel);
    memory_.active.resize(memory_.packets.size());
    for (std::size_t i = 0; i < memory_.active.size(); ++i)
        memory_.active[i] = i;
}

template <class Real>
bool PacketSearch<Real>::has_next(Packet& packet) {
    while (!packet.stretches.empty()) {
        SharedStretch& next = packet.stretches.back();
        next.rays &= packet.alive;
        if (next.rays != 0) return true;
        packet.stretches.pop_back();
    }
    return false;
}

template <class Real>
void PacketSearch<Real>::leave() {
    for (Packet& packet : memory_.packets) {
        if (!has_next(packet)) continue;
        RayBits waiting = 0;
        for (const SharedStretch& stretch : packet.stretches)
            waiting |= stretch.rays & packet.alive;
        const double from = packet.stretches.back().from;
        for (; waiting != 0; waiting &= waiting - 1) {
            const auto ray = static_cast<std::size_t>(std::countr_zero(waiting));
            writer_.leave_unsettled(packet.pixels[ray], from);
        }
    }
}

template <class Real>
void PacketSearch<Real>::take(Packet& packet, std::size_t box) {
    const SharedStretch shared = packet.stretches.back();
    packet.stretches.pop_back();
    const bool is_finest = shared.to - shared.from <= packet.finest;
    RayBits open = 0;
    for (RayBits bits = shared.rays & packet.alive; bits != 0; bits &= bits - 1) {
        const auto ray = static_cast<std::size_t>(std::countr_zero(bits));
        TaskOutcome outcome;
        outcome.stop();
        const bool stays = field_.take_range(box + ray, outcome);
        if (outcome.kind != TaskOutcome::Kind::Stop) continue;
        if (stays && !is_finest) {
            open |= RayBits{1} << ray;
            continue;
        }
        memory_.last.push_back({.pixel = packet.pixels[ray],
                                .stretch = part_of(packet.pixels[ray], shared),
                                .finest = packet.finest});
    }
    if (open == 0) return;
    const double middle = 0.5 * shared.from + 0.5 * shared.to;
    const auto push = [&](double from, double to) {
        RayBits rays = 0;
        for (RayBits bits = open; bits != 0; bits &= bits - 1) {
            const auto ray = static_cast<std::size_t>(std::countr_zero(bits));
            const RayLine& line = field_.lines.of(packet.pixels[ray]);
            if (line.from <= to && line.to >= from) rays |= RayBits{1} << ray;
        }
        if (rays != 0) packet.stretches.push_back({.from = from, .to = to, .rays = rays});
    };
    push(middle, shared.to);
    push(shared.from, middle);
}

template <class Real>
void PacketSearch<Real>::step(std::span<const std::size_t> which) {
    field_.ranges.clear();
    std::array<std::size_t, most_packets> first{};
    for (std::size_t k = 0; k < which.size(); ++k) {
        const Packet& packet = memory_.packets[which[k]];
        first[k] = field_.ranges.size();
        for (std::size_t ray = 0; ray < packet.count; ++ray) {
            const Stretch part = part_of(packet.pixels[ray], packet.stretches.back());
            field_.ranges.push(packet.pixels[ray], part.from, part.to);
        }
    }
    field_.ranges.evaluate();
    memory_.last.clear();
    for (std::size_t k = 0; k < which.size(); ++k)
        take(memory_.packets[which[k]], first[k]);
    if (memory_.last.empty()) return;
    const auto answers = decision_.decide(memory_.last);
    for (std::size_t i = 0; i < memory_.last.size(); ++i) {
        if (!writer_.take(memory_.last[i], answers[i])) continue;
        const Owner& owner = owners_[memory_.last[i].pixel];
        memory_.packets[owner.packet].alive &= ~owner.ray;
    }
}

}  // namespace

void trace_tile_t_bisection(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                            Counters& counters) {
    in_precision(frame, [&](auto real) {
        using Real = decltype(real);
        thread_local const auto kept = std::make_unique<PacketMemory<Real>>();
        PacketMemory<Real>& memory = *kept;
        const TileRays rays(frame, tile);
        memory.field.begin(frame, tile, rays, counters);
        PacketSearch<Real>(rays, hits, memory).run();
    });
}

}  // namespace zeroset
