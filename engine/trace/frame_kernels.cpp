#include "engine/trace/frame_kernels.hpp"

#include "engine/kernel/form_cells.hpp"
#include "engine/real/scalar.hpp"
#include "engine/trace/tile_rays.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <vector>

namespace zeroset {
namespace {

constexpr std::size_t slabs = batch_multiple;

/// Smaller regions are not made: tracers look at their tiles themselves.
constexpr int least_side = 2 * tile_size;

/// A square of pixels times slabs of depth, from the entry of its rays into the clip box to their
/// exit.
template <class Real>
class RegionCells {
public:
    RegionCells(const TraceFrame& frame, const Tile& square, int side);

    /// Whether the rays meet the clip box.
    [[nodiscard]] bool any() const { return any_; }
    /// The kernel for what may hold a root; nullptr where it is not shorter.
    std::shared_ptr<const Kernel> specialized(const Specializer& specializer);

private:
    static constexpr auto unit = static_cast<double>(std::numeric_limits<Real>::epsilon());

    const TraceFrame& frame_;
    bool any_ = false;
    FrustumOf<Real> frustum_{};
    FormCells<Real, slabs> cells_;
};

template <class Real>
RegionCells<Real>::RegionCells(const TraceFrame& frame, const Tile& square, int side)
    : frame_(frame) {
    const TileRays rays(frame, square, side);
    const double half = 0.5 * (side - 1);
    const double radius = half * rays.pixel();
    const DepthRange all = rays.depths(rays.u(half), rays.v(half), radius, radius);
    any_ = !all.empty();
    if (!any_) return;
    const double s_most = std::max(std::abs(all.enter_lo), std::abs(all.exit_hi)) * (1.0 + 0x1p-10);
    frustum_ = rays.frustum<Real>(side);
    const double length = (all.exit_hi - all.enter_lo) / slabs;
    // Longer than all cells of its tiles that end where it does.
    const double margin = 0.01 * length + 256 * s_most * unit + 16 * rays.tolerance();
    for (std::size_t i = 0; i < slabs; ++i) {
        cells_.u[i] = static_cast<Real>(rays.u(half));
        cells_.v[i] = static_cast<Real>(rays.v(half));
        cells_.s[i] = static_cast<Real>(all.enter_lo + (static_cast<double>(i) + 0.5) * length);
        cells_.s_radius[i] = upper_end(Real{}, 0.5 * length + margin);
    }
}

template <class Real>
std::shared_ptr<const Kernel> RegionCells<Real>::specialized(const Specializer& specializer) {
    ChoiceRecord record;
    specializer.form(cells_.batch(slabs, frustum_, frame_.scene.uniforms.template boxes<Real>()),
                     record);
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < slabs; ++i) {
        const bool apart = std::abs(cells_.c[i]) > cells_.spread(i);
        if (cells_.nowhere[i] == 0 && !apart) open.push_back(i);
    }
    if (open.empty()) return nullptr;
    return specializer.specialized(record, open);
}

template <class Real>
std::shared_ptr<const Kernel> specialized_for(const TraceFrame& frame, const Tile& square, int side,
                                              const Specializer& specializer) {
    RegionCells<Real> cells(frame, square, side);
    if (!cells.any()) return nullptr;
    return cells.specialized(specializer);
}

}  // namespace

struct FrameKernels::Region {
    Region(int first_col, int first_row, int pixels)
        : col(first_col), row(first_row), side(pixels) {}

    int col, row, side;  ///< a square of pixels, of which a part may lie outside the image
    std::once_flag made{};
    const Kernel* kernel = nullptr;
    std::shared_ptr<const Kernel> own{};  ///< if it is not that of the region around it
    std::array<std::unique_ptr<Region>, 4> quarters{};
};

FrameKernels::FrameKernels(const TraceFrame& frame) : frame_(frame) {
    const auto longest =
        static_cast<unsigned>(std::max({frame.image.width, frame.image.height, tile_size}));
    whole_ = std::make_unique<Region>(0, 0, static_cast<int>(std::bit_ceil(longest)));
}

FrameKernels::~FrameKernels() = default;

void FrameKernels::make(Region& region, const Kernel& around) const {
    region.kernel = &around;
    if (around.specializer == nullptr) return;
    const Tile square{
        .col = region.col, .row = region.row, .cols = region.side, .rows = region.side};
    auto kernel = frame_.precision == Precision::Double
                      ? specialized_for<double>(frame_, square, region.side, *around.specializer)
                      : specialized_for<float>(frame_, square, region.side, *around.specializer);
    if (kernel) {
        region.own = std::move(kernel);
        region.kernel = region.own.get();
    }
    const int half = region.side / 2;
    if (half < least_side) return;
    for (int i = 0; i < 4; ++i) {
        region.quarters[static_cast<std::size_t>(i)] = std::make_unique<Region>(
            region.col + (i & 1) * half, region.row + (i >> 1) * half, half);
    }
}

const Kernel& FrameKernels::of(const Tile& tile) {
    Region* region = whole_.get();
    const Kernel* kernel = &frame_.kernel;
    while (region != nullptr) {
        std::call_once(region->made, [&] { make(*region, *kernel); });
        kernel = region->kernel;
        const int half = region->side / 2;
        const std::size_t right = tile.col >= region->col + half ? 1 : 0;
        const std::size_t below = tile.row >= region->row + half ? 2 : 0;
        region = region->quarters[right + below].get();
    }
    return *kernel;
}

}  // namespace zeroset
