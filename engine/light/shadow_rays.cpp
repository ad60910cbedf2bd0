#include "engine/light/shadow_cells.hpp"
#include "engine/light/shadow_search.hpp"
#include "engine/real/scalar.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace zeroset {
namespace {

constexpr std::size_t cells_at_once = 256;

/// A ray on its way from the hit to the light.
struct Path {
    LightRay ray;
    double step;            ///< of the next cell, in front of ray.to, or of the hit
    bool unproved = false;  ///< a part of the ray could not be decided

    [[nodiscard]] double next() const {
        return std::max(ray.from, (ray.left ? ray.to : std::min(ray.to, ray.s)) - step);
    }
    [[nodiscard]] double length() const { return ray.to - next(); }
};

template <class Real>
class RaySearch {
public:
    RaySearch(const ShadowSearch& search, Counters& counters)
        : search_(search),
          counters_(counters),
          frustum_(search.rays.frustum<Real>(1)),
          margin_(search.rays.depth_error()) {}

    void search(const std::vector<LightRay>& rays, ShadowBits& found);

private:
    void evaluate(std::span<const Path> paths);
    [[nodiscard]] Start start_of(const LightRay& ray) const {
        if (ray.left) return Start::Behind;
        if (!ray.is_root) return Start::Others;
        return search_.is_member ? Start::Above : Start::Roots;
    }
    /// Takes what is known of the next cell; whether the path goes on.
    bool advance(Path& path, const ShadeVerdict& verdict, bool continuous, ShadowBits& found) const;

    const ShadowSearch& search_;
    Counters& counters_;
    FrustumOf<Real> frustum_;
    double margin_;  ///< cells are longer than their part of the ray
    FormCells<Real, cells_at_once> cells_;
};

template <class Real>
void RaySearch<Real>::evaluate(std::span<const Path> paths) {
    const std::size_t size = padded(paths.size());
    for (std::size_t i = 0; i < size; ++i) {
        const Path& path = paths[std::min(i, paths.size() - 1)];
        const double next = path.next();
        cells_.u[i] = static_cast<Real>(path.ray.u);
        cells_.v[i] = static_cast<Real>(path.ray.v);
        cells_.s[i] = static_cast<Real>(0.5 * next + 0.5 * path.ray.to);
        const auto middle = static_cast<double>(cells_.s[i]);
        cells_.s_radius[i] =
            upper_end(Real{}, std::max(path.ray.to - middle, middle - next) + margin_);
    }
    counters_.form += paths.size();
    search_.light.kernel.ray_form(
        cells_.batch(size, frustum_, search_.light.scene.uniforms.template boxes<Real>()));
}

template <class Real>
bool RaySearch<Real>::advance(Path& path, const ShadeVerdict& verdict, bool continuous,
                              ShadowBits& found) const {
    LightRay& ray = path.ray;
    const bool open = verdict.shade == Shade::Open;
    const double length = ray.left ? path.length() : path.step;
    if (open && length > search_.finest) {
        path.step = 0.5 * length;
        return true;
    }
    path.unproved = path.unproved || open;
    const bool at_hit = open && !ray.left && ray.is_root;
    const std::size_t row = ray.pixel / tile_size;
    const std::uint64_t hit = std::uint64_t{1} << ray.pixel % tile_size;
    if (verdict.shade == Shade::Dark || (open && !at_hit && continuous)) {
        if (!path.unproved) {
            found.prove_dark(row, hit);
            return false;
        }
        found.doubt(row, hit);
        found.dark[row] |= hit;
        return false;
    }
    ray.to = at_hit ? ray.s - search_.bias : path.next();
    path.step = at_hit ? search_.bias : 2.0 * path.step;
    ray.left = true;
    ray.sign = verdict.sign;
    if (ray.from < ray.to) return true;
    if (path.unproved) found.doubt(row, hit);
    return false;
}

template <class Real>
void RaySearch<Real>::search(const std::vector<LightRay>& rays, ShadowBits& found) {
    std::vector<Path> paths;
    paths.reserve(rays.size());
    for (const LightRay& ray : rays)
        paths.push_back({.ray = ray, .step = 0.125 * (ray.to - ray.from)});
    while (!paths.empty()) {
        std::size_t kept = 0;
        for (std::size_t first = 0; first < paths.size(); first += cells_at_once) {
            if (search_.light.stopped()) return;
            const std::size_t count = std::min(cells_at_once, paths.size() - first);
            evaluate(std::span(paths).subspan(first, count));
            for (std::size_t i = 0; i < count; ++i) {
                Path path = paths[first + i];
                const ShadeVerdict verdict =
                    judge(line_of(cells_, i), start_of(path.ray), path.ray.sign);
                if (advance(path, verdict, cells_.continuous[i] != 0, found)) paths[kept++] = path;
            }
        }
        paths.resize(kept);
    }
}

}  // namespace

void search_rays(const ShadowSearch& search, const std::vector<LightRay>& rays, ShadowBits& found,
                 Counters& counters) {
    if (rays.empty()) return;
    if (search.light.precision == Precision::Double) {
        RaySearch<double>(search, counters).search(rays, found);
    } else {
        RaySearch<float>(search, counters).search(rays, found);
    }
}

}  // namespace zeroset
