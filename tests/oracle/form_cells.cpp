#include "tests/oracle/form_cells.hpp"

#include "engine/trace/tile_rays.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

namespace zeroset::test {
namespace {

glm::dvec3 random_vector(RandomNumbers& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

/// A place where formulas often have poles, jumps or ends of domains, or any other nearby.
glm::dvec3 random_target(RandomNumbers& random) {
    if (random.one_in(3)) return glm::dvec3(0.0);
    if (random.one_in(2)) return random_vector(random, 3);
    return {random.between(-2, 2), random.between(-2, 2), random.between(-2, 2)};
}

Camera random_camera(RandomNumbers& random) {
    Camera camera;
    camera.look_at = random_target(random);
    const bool deep = random.one_in(4);
    const double distance = std::exp2(deep ? random.uniform(-38, 0) : random.uniform(-2, 4));
    glm::dvec3 towards = random_vector(random, 1) + glm::dvec3(0.01, 0.02, 0.03);
    if (random.one_in(4)) towards = glm::dvec3(random.one_in(2) ? 1 : -1, 0, 0);
    camera.eye = camera.look_at + distance * glm::normalize(towards);
    camera.fov_rad = random.uniform(0.05, 2.2);
    return camera;
}

/// A view with a clip box about the place looked at, now and then far from the origin or enormous.
struct RandomView {
    Scene scene;
    Camera camera;

    explicit RandomView(RandomNumbers& random) : camera(random_camera(random)) {
        const double distance = glm::distance(camera.eye, camera.look_at);
        double half = distance * random.uniform(0.1, 2);
        if (random.one_in(3)) half = std::max(half, random.uniform(1, 4));
        const double scale = random.one_in(8) ? std::exp2(random.uniform(-60, 60)) : 1.0;
        camera.eye *= scale;
        camera.look_at *= scale;
        scene.clip = {camera.look_at - glm::dvec3(scale * half),
                      camera.look_at + glm::dvec3(scale * half)};
    }
};

template <class Real>
Real inside(Real value, double lo, double hi) {
    return static_cast<Real>(std::clamp(static_cast<double>(value), lo, hi));
}

/// A place in the cell: the centre of a pixel on its rim or inside, at any depth.
RayPlace random_place(RandomNumbers& random, const TileRays& view, const Tile& cell, double s_lo,
                      double s_hi) {
    const auto along = [&](int first, int pixels) {
        const int eighths = 8 * (pixels - 1);
        const int at =
            random.one_in(2) ? 8 * random.between(0, pixels - 1) : random.between(0, eighths);
        return static_cast<float>(first) + 0.125F * static_cast<float>(at);
    };
    const float col = along(cell.col, cell.cols);
    const float row = along(cell.row, cell.rows);
    const double t = random.one_in(3) ? random.between(0, 1) : random.uniform();
    return {col, row, view.u(static_cast<double>(col)), view.v(static_cast<double>(row)),
            std::clamp(s_lo + t * (s_hi - s_lo), s_lo, s_hi)};
}

template <class Real>
void make_cell(RandomNumbers& random, const TileRays& view, int pixels, const DepthRange& depths,
               FormCells<Real>& cells, std::size_t i) {
    constexpr int smallest = sizeof(Real) == 4 ? -22 : -44;
    const int places = tile_size / pixels;
    const Tile cell{pixels * random.between(0, places - 1), pixels * random.between(0, places - 1),
                    pixels, pixels};
    const double middle = 0.5 * (pixels - 1);
    cells.u[i] = static_cast<Real>(view.u(cell.col + middle));
    cells.v[i] = static_cast<Real>(view.v(cell.row + middle));
    const double length = depths.exit_hi - depths.enter_lo;
    const double size = length * std::exp2(random.one_in(3) ? random.uniform(smallest, -3)
                                                            : random.uniform(-10, -1));
    const double at = random.one_in(4) ? 0.0 : random.uniform(depths.enter_lo, depths.exit_hi);
    cells.s[i] = inside(static_cast<Real>(at), depths.enter_lo + size, depths.exit_hi - size);
    cells.s_radius[i] = static_cast<Real>(size);
    const auto s = static_cast<double>(cells.s[i]);
    const auto reach = static_cast<double>(cells.s_radius[i]);
    // Round the places inward unless the sums are exact.
    const double lo = std::nextafter(s - reach, s);
    const double hi = std::nextafter(s + reach, s);
    cells.near[i] = random_place(random, view, cell, lo, hi);
    cells.far[i] = cells.near[i];
    cells.far[i].s = random_place(random, view, cell, cells.near[i].s, hi).s;
}

}  // namespace

template <class Real>
FormCells<Real> random_cells(RandomNumbers& random) {
    static constexpr std::array sides{64, 32, 16, 8, 4, 1};
    for (;;) {
        RandomView seen(random);
        const int height = random.between(64, 2000);
        if (height % 3 == 0) seen.camera.projection = Projection::Orthographic;
        const ViewFrame view(seen.camera);
        const TraceFrame frame = trace_frame(seen.scene, Surface{}, view,
                                             {.width = height, .height = height}, StopCriterion{});
        const int first = random.between(0, height - tile_size);
        const Tile tile{first, random.between(0, height - tile_size), tile_size, tile_size};
        const TileRays beams(frame, tile);
        const double middle = 0.5 * (tile_size - 1);
        const double radius = middle * beams.pixel();
        const DepthRange depths = beams.depths(beams.u(middle), beams.v(middle), radius, radius);
        if (depths.empty()) continue;
        FormCells<Real> cells;
        cells.view = view;
        cells.base = beams.base();
        cells.distance = beams.distance();
        std::memcpy(&cells.rays, beams.kernel_rays<double>(), sizeof cells.rays);
        const int pixels = sides.at(random.below(sides.size()));
        cells.frustum = beams.frustum<Real>(pixels);
        for (std::size_t i = 0; i < cells_a_batch; ++i)
            make_cell(random, beams, pixels, depths, cells, i);
        const double w = static_cast<double>(random.number<float>());
        cells.w = w;
        cells.uniforms.set(0, w, random.one_in(3) ? w + random.uniform() : w);
        return cells;
    }
}

template FormCells<float> random_cells(RandomNumbers&);
template FormCells<double> random_cells(RandomNumbers&);

}  // namespace zeroset::test
