#include "engine/trace/caps.hpp"

#include "engine/real/rounding.hpp"
#include "engine/real/scalar.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace zeroset {
namespace {

constexpr std::size_t tile_pixels = static_cast<std::size_t>(tile_size) * tile_size;

/// What a range kernel says of the signs of f in a box.
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

/// Boxes for a range kernel, and its answers.
template <class Real>
struct Boxes {
    static constexpr std::size_t capacity = 256;
    std::array<std::array<Real, capacity>, 3> neg_lo, hi;
    std::array<Real, capacity> f_neg_lo, f_hi;
    std::array<ContinuityMask<Real>, capacity> continuous;

    void set(std::size_t i, const glm::dvec3& middle, const glm::dvec3& radius) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<int>(k);
            neg_lo[k][i] = upper_end(Real{}, radius[axis] - middle[axis]);
            hi[k][i] = upper_end(Real{}, radius[axis] + middle[axis]);
        }
    }
    void evaluate(const TraceFrame& frame, std::size_t count) {
        const std::size_t size = (count + batch_multiple - 1) / batch_multiple * batch_multiple;
        for (std::size_t i = count; i < size; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                neg_lo[k][i] = neg_lo[k][0];
                hi[k][i] = hi[k][0];
            }
        }
        frame.kernel.range(
            RangeBatchOf<Real>{size,
                               {neg_lo[0].data(), neg_lo[1].data(), neg_lo[2].data()},
                               {hi[0].data(), hi[1].data(), hi[2].data()},
                               frame.scene.uniforms.template boxes<Real>(),
                               f_neg_lo.data(),
                               f_hi.data(),
                               continuous.data()});
    }
};

/// Whether f < 0 on most of a face of the clip box, of where it is defined.
bool is_mostly_negative(const Scene& scene, const KernelFunction<ValueBatchOf<float>>& value,
                        int face) {
    constexpr std::size_t side = 8;
    constexpr std::size_t points = side * side;
    static_assert(points % batch_multiple == 0);
    constexpr double most = 0.6;
    std::array<std::array<float, points>, 3> x;
    std::array<std::array<float, points>, 4> out;
    const int axis = face / 2;
    for (std::size_t i = 0; i < points; ++i) {
        glm::dvec3 share(0.0);
        share[axis] = face % 2;
        share[(axis + 1) % 3] = (static_cast<double>(i % side) + 0.5) / side;
        share[(axis + 2) % 3] = (static_cast<double>(i / side) + 0.5) / side;
        const glm::dvec3 point = glm::mix(scene.clip.lo, scene.clip.hi, share);
        for (std::size_t k = 0; k < 3; ++k)
            x[k][i] = static_cast<float>(point[static_cast<int>(k)]);
    }
    value(ValueBatchOf<float>{points,
                              {x[0].data(), x[1].data(), x[2].data()},
                              scene.uniforms.points<float>(),
                              out[3].data(),
                              {out[0].data(), out[1].data(), out[2].data()}});
    const auto negative = std::ranges::count_if(out[3], [](float f) { return f < 0; });
    const auto known = std::ranges::count_if(out[3], [](float f) { return !std::isnan(f); });
    return static_cast<double>(negative) > most * static_cast<double>(known);
}

}  // namespace

int solid_sign(const Scene& scene, std::size_t surface) {
    const Solid solid = surface < scene.solids.size() ? scene.solids[surface] : Solid();
    if (solid.side != SolidSide::Automatic) return solid.side == SolidSide::Below ? -1 : 1;
    const auto& value =
        solid.unrestricted ? solid.unrestricted : scene.surfaces[surface].value_float;
    const UpwardRounding upward;
    for (int face = 0; face < 6; ++face) {
        if (!is_mostly_negative(scene, value, face)) return -1;
    }
    return 1;
}

bool has_caps(const Scene& scene) {
    return std::ranges::any_of(scene.region.sections, [&](const Section& section) {
        return section.cap && cuts(section, scene.clip);
    });
}

float cap_tone(const ViewFrame& view, int height_px, const glm::dvec3& point,
               const glm::dvec3& normal) {
    constexpr double lines_a_height = 72.0;
    constexpr double plain = 0.9;
    constexpr double line = 0.74;
    constexpr double line_share = 0.3;
    const double pixel = view.pixel_at_look(height_px);
    // A power of two, so that lines stay where they are while the view changes a little.
    const double spacing = std::exp2(std::round(std::log2(pixel * height_px / lines_a_height)));
    const glm::dvec3 size = glm::abs(normal);
    const glm::dvec3 aside = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                             : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                  : glm::dvec3(0, 0, 1);
    const glm::dvec3 a = glm::normalize(glm::cross(normal, aside));
    const double place = glm::dot(point, glm::normalize(a + glm::cross(normal, a))) / spacing;
    const double from_line = spacing * std::abs(place - std::round(place));
    const double covered =
        std::clamp((0.5 * line_share * spacing - from_line) / pixel + 0.5, 0.0, 1.0);
    return static_cast<float>(plain + covered * (line - plain));
}

CapFinder::CapFinder() { limits_.resize(tile_pixels); }

void CapFinder::enter(const TraceFrame& frame, const Tile& tile) {
    entries_.clear();
    sections_.clear();
    Tile whole = tile;
    whole.limits = nullptr;
    const BeamView view(frame, whole);
    const double half = 0.5 * (tile_size - 1);
    const double radius = half * view.pixel();
    const DepthRange uncut = view.depths_uncut(view.u(half), view.v(half), radius, radius);
    for (const Section& section : frame.scene.region.sections) {
        if (!section.cap || !cuts(section, frame.scene.clip)) continue;
        const DepthRange kept =
            view.depths_kept(section, view.u(half), view.v(half), radius, radius);
        if (kept.enter_hi >= uncut.enter_lo && kept.enter_lo <= uncut.exit_hi)
            sections_.push_back(&section);
    }
    for (int row = 0; row < tile.rows && !sections_.empty(); ++row) {
        for (int col = 0; col < tile.cols; ++col)
            enter_pixel(view, col, row);
    }
}

void CapFinder::enter_pixel(const BeamView& view, int col, int row) {
    const double u = view.u(col);
    const double v = view.v(row);
    const DepthRange uncut = view.depths_uncut(u, v, 0.0, 0.0);
    if (uncut.empty()) return;
    for (const Section* section : sections_) {
        const DepthRange kept = view.depths_kept(*section, u, v, 0.0, 0.0);
        DepthRange others = uncut;
        for (const Section& other : view.region().sections) {
            if (&other == section) continue;
            others = both(others, view.depths_kept(other, u, v, 0.0, 0.0));
        }
        const bool bounded = std::isfinite(kept.enter_lo) && std::isfinite(kept.enter_hi);
        const bool possible = kept.enter_hi >= others.enter_lo && kept.enter_lo <= others.exit_hi;
        if (!bounded || !possible) continue;
        const double s = 0.5 * kept.enter_lo + 0.5 * kept.enter_hi;
        const glm::dvec3 along = glm::abs(view.point(col, row, s + 1.0) - view.point(col, row, s));
        const glm::dvec3 radius = 0.5 * (kept.enter_hi - kept.enter_lo) * (along + 0x1p-20) +
                                  glm::dvec3(view.depth_error());
        entries_.push_back({static_cast<std::uint16_t>(row * tile_size + col),
                            kept.enter_lo >= others.enter_hi && kept.enter_hi <= others.exit_lo,
                            section, view.point(col, row, s), radius,
                            static_cast<float>(view.distance_at(s, u, v)),
                            view.distance_before(s, u, v)});
        return;
    }
}

template <class Real>
void CapFinder::ask(const TraceFrame& surface, int sign, std::vector<Entry*>& open) {
    static thread_local Boxes<Real> boxes;
    std::size_t kept = 0;
    for (std::size_t first = 0; first < open.size(); first += Boxes<Real>::capacity) {
        if (surface.stopped()) {
            for (Entry* const entry : std::span(open).subspan(first))
                entry->state = State::Unknown;
            break;
        }
        const std::size_t count = std::min(Boxes<Real>::capacity, open.size() - first);
        for (std::size_t i = 0; i < count; ++i)
            boxes.set(i, open[first + i]->point, open[first + i]->radius);
        boxes.evaluate(surface, count);
        for (std::size_t i = 0; i < count; ++i) {
            Entry& entry = *open[first + i];
            const SignOf found = sign_of(boxes.f_neg_lo[i], boxes.f_hi[i]);
            if (found == SignOf::Unknown) {
                entry.state = State::Unknown;
                open[kept++] = &entry;
                continue;
            }
            const bool inside = found == (sign < 0 ? SignOf::Negative : SignOf::Positive);
            const bool certain = entry.sure && boxes.continuous[i] != 0;
            entry.state = !inside ? State::Empty : certain ? State::Certain : State::Possible;
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
    counters.range += open.size();
    if (surface.precision == Precision::Float) {
        ask<float>(surface, sign, open);
        counters.range += open.size();
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
        const TileHits::Pixel pixel{static_cast<std::int16_t>(entry.pixel % tile_size),
                                    static_cast<std::int16_t>(entry.pixel / tile_size)};
        switch (entry.state) {
            case State::Empty: break;
            case State::Unknown:
                hits.pass(pixel, entry.before);
                hits.certificate[entry.pixel] = Certificate::Undecided;
                break;
            case State::Possible:
                hits.put_cap(pixel, entry.distance, Certificate::Undecided, entry.section->normal);
                break;
            case State::Certain:
                hits.put_cap(pixel, entry.distance, Certificate::Certified, entry.section->normal);
                break;
        }
    }
    if (hits.any_cap) {
        std::erase_if(hits.points,
                      [&hits](const TileHits::Point& point) { return hits.cap[point.pixel] != 0; });
    }
}

}  // namespace zeroset
