#include "engine/trace/caps.hpp"

#include "engine/kernel/point_batch.hpp"
#include "engine/kernel/range_boxes.hpp"
#include "engine/kernel/surface_facts.hpp"
#include "engine/real/rounding.hpp"
#include "engine/real/scalar.hpp"
#include "engine/trace/tile_costs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>

namespace zeroset {
namespace {

/// The signs of f in a box, as a range kernel tells them.
enum class SignOf : std::uint8_t { Unknown, Nowhere, Negative, Positive };

template <class Real>
SignOf sign_of(Real neg_lo, Real hi) {
    if (neg_lo < 0 && hi < 0) {
        const bool nowhere = std::isinf(neg_lo) && std::isinf(hi);
        return nowhere ? SignOf::Nowhere : SignOf::Unknown;
    }
    if (hi < 0) return SignOf::Negative;
    return neg_lo < 0 ? SignOf::Positive : SignOf::Unknown;
}

constexpr std::size_t boxes_at_once = 256;

/// Boxes for the signs of f at entries.
template <class Real>
struct EntryBoxes : RangeBoxes<Real, boxes_at_once> {
    void set(std::size_t i, const glm::dvec3& middle, const glm::dvec3& radius) {
        for (int k = 0; k < 3; ++k) {
            this->ends[k][i] = upper_end(Real{}, radius[k] - middle[k]);
            this->ends[k + 3][i] = upper_end(Real{}, radius[k] + middle[k]);
        }
    }
    void evaluate(const TraceFrame& frame, std::size_t count) {
        this->pad(count);
        frame.kernel.range(this->batch(padded(count), frame.scene.uniforms.template boxes<Real>()));
    }
};

/// Whether f < 0 on most of a face of the clip box, of where it is defined.
bool is_mostly_negative(const Scene& scene, const KernelFunction<ValueBatchOf<float>>& value,
                        int face) {
    constexpr std::size_t side = 8;
    constexpr std::size_t points = side * side;
    constexpr double most = 0.6;
    PointBatch<float> batch(points);
    const int axis = face / 2;
    for (std::size_t i = 0; i < points; ++i) {
        glm::dvec3 share(0.0);
        const std::size_t col = i % side;
        const std::size_t row = i / side;
        share[axis] = face % 2;
        share[(axis + 1) % 3] = (static_cast<double>(col) + 0.5) / side;
        share[(axis + 2) % 3] = (static_cast<double>(row) + 0.5) / side;
        const glm::dvec3 point = glm::mix(scene.clip.lo, scene.clip.hi, share);
        batch.set(i, static_cast<float>(point.x), static_cast<float>(point.y),
                  static_cast<float>(point.z));
    }
    value(batch.batch(scene.uniforms.points<float>()));
    std::size_t negative = 0;
    std::size_t known = 0;
    for (std::size_t i = 0; i < points; ++i) {
        negative += batch.f(i) < 0 ? 1U : 0U;
        known += std::isnan(batch.f(i)) ? 0U : 1U;
    }
    return static_cast<double>(negative) > most * static_cast<double>(known);
}

}  // namespace

int solid_sign(const Scene& scene, std::size_t surface) {
    const Kernel& kernel = scene.surfaces[surface].kernel;
    const Solid& solid = scene.surfaces[surface].solid;
    if (surface_facts(kernel).is_sheet) return 0;
    if (solid.side != SolidSide::Automatic) return solid.side == SolidSide::Below ? -1 : 1;
    const auto& value = solid.unrestricted ? solid.unrestricted : kernel.in_float.value;
    const UpwardRounding upward;
    for (int face = 0; face < 6; ++face) {
        if (!is_mostly_negative(scene, value, face)) return -1;
    }
    return 1;
}

bool has_caps(const Scene& scene) {
    return std::ranges::any_of(scene.region.sections, [&](const Section& section) {
        return is_filled(section) && cuts(section, scene.clip);
    });
}

CapFinder::CapFinder() { limits_.resize(tile_pixels); }

void CapFinder::enter(const TraceFrame& frame, const Tile& tile) {
    entries_.clear();
    sections_.clear();
    Tile whole = tile;
    whole.limits = nullptr;
    const TileRays rays(frame, whole);
    const double half = 0.5 * (tile_size - 1);
    const double radius = half * rays.pixel();
    const DepthRange uncut = rays.depths_uncut(rays.u(half), rays.v(half), radius, radius);
    for (const Section& section : frame.scene.region.sections) {
        if (!is_filled(section) || !cuts(section, frame.scene.clip)) continue;
        const DepthRange kept =
            rays.depths_kept(section, rays.u(half), rays.v(half), radius, radius);
        if (kept.enter_hi >= uncut.enter_lo && kept.enter_lo <= uncut.exit_hi)
            sections_.push_back(&section);
    }
    for (int row = 0; row < tile.rows && !sections_.empty(); ++row) {
        for (int col = 0; col < tile.cols; ++col)
            enter_pixel(rays, col, row);
    }
}

void CapFinder::enter_pixel(const TileRays& rays, int col, int row) {
    const double u = rays.u(col);
    const double v = rays.v(row);
    const DepthRange uncut = rays.depths_uncut(u, v, 0.0, 0.0);
    if (uncut.empty()) return;
    for (const Section* section : sections_) {
        const DepthRange kept = rays.depths_kept(*section, u, v, 0.0, 0.0);
        DepthRange others = uncut;
        for (const Section& other : rays.region().sections) {
            if (&other == section) continue;
            others = both(others, rays.depths_kept(other, u, v, 0.0, 0.0));
        }
        const bool bounded = std::isfinite(kept.enter_lo) && std::isfinite(kept.enter_hi);
        const bool possible = kept.enter_hi >= others.enter_lo && kept.enter_lo <= others.exit_hi;
        if (!bounded || !possible) continue;
        const double s = 0.5 * kept.enter_lo + 0.5 * kept.enter_hi;
        const glm::dvec3 along = glm::abs(rays.point(col, row, s + 1.0) - rays.point(col, row, s));
        const glm::dvec3 radius = 0.5 * (kept.enter_hi - kept.enter_lo) * (along + 0x1p-20) +
                                  glm::dvec3(rays.depth_error());
        entries_.push_back(
            {.pixel = static_cast<std::uint16_t>(row * tile_size + col),
             .sure = kept.enter_lo >= others.enter_hi && kept.enter_hi <= others.exit_lo,
             .section = section,
             .point = rays.point(col, row, s),
             .radius = radius,
             .distance = static_cast<float>(rays.distance_at(s, u, v)),
             .before = rays.distance_before(s, u, v)});
        return;
    }
}

template <class Sign>
bool CapFinder::Entry::settle(Sign found, int solid_sign, bool continuous) {
    const State seen = sure && continuous ? State::Certain : State::Possible;
    if (section->values && !section->cap) {
        // Where f jumps or may end it is drawn, too, but not certain.
        state = found == Sign::Nowhere ? State::Empty : seen;
        return found == Sign::Nowhere || continuous;
    }
    if (found == Sign::Unknown) {
        state = State::Unknown;
        return false;
    }
    const bool inside = found == (solid_sign < 0 ? Sign::Negative : Sign::Positive);
    state = inside ? seen : State::Empty;
    return true;
}

template <class Real>
void CapFinder::ask(const TraceFrame& surface, int sign, std::vector<Entry*>& open) {
    thread_local const auto memory = std::make_unique<EntryBoxes<Real>>();
    EntryBoxes<Real>& boxes = *memory;
    std::size_t kept = 0;
    for (std::size_t first = 0; first < open.size(); first += boxes_at_once) {
        if (surface.stopped()) {
            for (Entry* const entry : std::span(open).subspan(first))
                entry->state = State::Unknown;
            break;
        }
        const std::size_t count = std::min(boxes_at_once, open.size() - first);
        for (std::size_t i = 0; i < count; ++i)
            boxes.set(i, open[first + i]->point, open[first + i]->radius);
        boxes.evaluate(surface, count);
        for (std::size_t i = 0; i < count; ++i) {
            Entry& entry = *open[first + i];
            const SignOf found = sign_of(boxes.f_neg_lo[i], boxes.f_hi[i]);
            if (!entry.settle(found, sign, boxes.continuous[i] != 0)) open[kept++] = &entry;
        }
    }
    open.resize(kept);
}

void CapFinder::fill(const TraceFrame& surface, int sign, Counters& counters) {
    if (entries_.empty()) return;
    thread_local std::vector<Entry*> open;
    open.clear();
    for (Entry& entry : entries_)
        open.push_back(&entry);
    const auto count = [&] {
        counters.range += open.size();
        for (const Entry* const entry : open) {
            if (counters.costs != nullptr) counters.costs->add(entry->pixel);
        }
    };
    count();
    if (surface.precision == Precision::Float) {
        ask<float>(surface, sign, open);
        count();
    }
    ask<double>(surface, sign, open);
}

const float* CapFinder::limits(const float* limits) {
    if (entries_.empty()) return limits;
    if (limits != nullptr) {
        std::copy_n(limits, tile_pixels, limits_.begin());
    } else {
        std::ranges::fill(limits_, std::numeric_limits<float>::infinity());
    }
    for (const Entry& entry : entries_) {
        if (entry.state >= State::Possible)
            limits_[entry.pixel] = std::min(limits_[entry.pixel], entry.distance);
    }
    return limits_.data();
}

void CapFinder::put(TileHits& hits) const {
    for (const Entry& entry : entries_) {
        const TileHits::Pixel pixel{.col = static_cast<std::int16_t>(entry.pixel % tile_size),
                                    .row = static_cast<std::int16_t>(entry.pixel / tile_size)};
        if (entry.state == State::Empty) continue;
        if (entry.state == State::Unknown) {
            hits.mark_unsettled(pixel, entry.before);
            hits.certificate[entry.pixel] = Certificate::Undecided;
            continue;
        }
        const bool certain = entry.state == State::Certain;
        hits.put_cap(
            pixel, entry.distance, certain ? Certificate::Certified : Certificate::Undecided,
            entry.section->normal, entry.section->values ? CapKind::Values : CapKind::Solid);
    }
    if (hits.any_cap) {
        std::erase_if(hits.points,
                      [&hits](const TileHits::Point& point) { return hits.is_cap(point.pixel); });
    }
}

}  // namespace zeroset
