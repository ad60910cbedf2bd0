#include "engine/antialias/square_cells.hpp"

#include "engine/antialias/cover_rules.hpp"
#include "engine/kernel/form_cells.hpp"
#include "engine/real/scalar.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace zeroset {
namespace {

constexpr std::size_t cells_at_once = 128;

template <class Real>
class SquareCells {
public:
    SquareCells(const TraceFrame& frame, std::size_t surface, SquareField& field)
        : frame_(frame),
          surface_(surface),
          field_(field),
          rays_(field.rays()),
          margin_(std::max(field.width_of(cell_margin, 0.0), 2.0 * rays_.depth_error())) {}

    void evaluate(std::span<const std::size_t> squares, Counters& counters);

private:
    void fill_cells(std::span<const std::size_t> squares, std::size_t size);
    [[nodiscard]] FrustumOf<Real> frustum_of(const CoverSquare& square) const;
    [[nodiscard]] CellVerdict verdict_of(const CoverSquare& square, const Front& front,
                                         std::size_t cell) const;

    const TraceFrame& frame_;
    std::size_t surface_;
    SquareField& field_;
    const TileRays& rays_;
    double margin_;  ///< cells are longer than their slabs by this at both ends
    FormCells<Real, cells_at_once> cells_;
    std::array<ContinuityMask<Real>, cells_at_once> branches_;
};

template <class Real>
CellVerdict SquareCells<Real>::verdict_of(const CoverSquare& square, const Front& front,
                                          std::size_t cell) const {
    const auto number = [](Real value) { return static_cast<double>(value); };
    const double c = number(cells_.c[cell]);
    const double along = number(cells_.k[2][cell]);
    const double aside = std::abs(number(cells_.k[0][cell])) + std::abs(number(cells_.k[1][cell]));
    const double error = number(cells_.e[cell]);
    const double middle = number(cells_.s[cell]);
    const double radius = number(cells_.s_radius[cell]);
    const bool known = std::isfinite(error);
    const BranchBits branches{frame_.kernel.branches ? static_cast<std::uint32_t>(branches_[cell])
                                                     : 0U};
    CellVerdict verdict{
        .from = front.at,
        .to = front.next(),
        .rejected = cells_.nowhere[cell] != 0 || std::abs(c) > aside + error + std::abs(along),
        .continuous = known && cells_.continuous[cell] != 0,
        .monotone = cells_.slope_hi[cell] < 0 || cells_.slope_neg_lo[cell] < 0,
        .kinked = branches.may_hold_kink(),
        .precise = known && error <= most_cell_error * aside,
        .root_from = -Front::none,
        .root_to = Front::none,
        .turn = 0.0,
        .growth = 1.0};
    // The error goes with the square of the length, or nearly so.
    if (verdict.rejected) {
        verdict.growth = std::abs(c) / (aside + error + std::abs(along));
        return verdict;
    }
    if (!known) return verdict;
    if (!verdict.precise) verdict.growth = std::sqrt(most_cell_error * aside / error);
    if (along == 0.0) return verdict;
    constexpr double slack = 16 * std::numeric_limits<Real>::epsilon();
    const double per_along = 1.0 / along;
    const double at = -c * per_along;
    const double spare =
        (aside + error) * std::abs(per_along) * (1.0 + slack) + slack * (1.0 + std::abs(at));
    verdict.root_from = middle + radius * (at - spare);
    verdict.root_to = middle + radius * (at + spare);
    if (!(verdict.root_from > verdict.from && verdict.root_to < verdict.to)) return verdict;
    // The form's linear part is f's gradient, in parts of the cell's radii.
    const double across =
        square.is_ray() ? 0.0 : aside / (0.5 * field_.width_of(square.side, middle));
    const double size = std::max(across, std::abs(along) / radius);
    verdict.turn = (number(cells_.slope_hi[cell]) + number(cells_.slope_neg_lo[cell])) / size;
    return verdict;
}

template <class Real>
FrustumOf<Real> SquareCells<Real>::frustum_of(const CoverSquare& square) const {
    FrustumOf<Real> frustum = rays_.frustum<Real>(1);
    // The squares may reach half a pixel beyond the tile, and one of the tile's corners is 32
    // pixels from the image's middle or more.
    for (int i = 0; i < 3; ++i) {
        frustum.size[i] *= static_cast<Real>(1.0 + 1.0 / 16);
        frustum.direction_size[i] *= static_cast<Real>(1.0 + 1.0 / 16);
    }
    if (square.is_ray()) return frustum;
    constexpr double unit = std::numeric_limits<Real>::epsilon();
    const auto most = [](double a, double b) { return std::max(std::abs(a), std::abs(b)); };
    const double radius = 0.5 * square.side * rays_.pixel();
    frustum.u_radius = upper_end(Real{}, radius + unit * most(rays_.u(-1), rays_.u(tile_size)));
    frustum.v_radius = upper_end(Real{}, radius + unit * most(rays_.v(-1), rays_.v(tile_size)));
    return frustum;
}

template <class Real>
void SquareCells<Real>::fill_cells(std::span<const std::size_t> squares, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
        const std::size_t at = squares[std::min(i, squares.size() - 1)];
        const CoverSquare& square = field_.square(at);
        const Front& front = field_.fronts(at)[surface_];
        const double to = front.next();
        cells_.u[i] = static_cast<Real>(rays_.u(SquareField::col_of(square, square_middle)));
        cells_.v[i] = static_cast<Real>(rays_.v(SquareField::row_of(square, square_middle)));
        cells_.s[i] = static_cast<Real>(0.5 * front.at + 0.5 * to);
        const auto middle = static_cast<double>(cells_.s[i]);
        cells_.s_radius[i] = upper_end(Real{}, std::max(to - middle, middle - front.at) + margin_);
    }
}

template <class Real>
void SquareCells<Real>::evaluate(std::span<const std::size_t> squares, Counters& counters) {
    const CoverSquare& model = field_.square(squares.front());
    const FrustumOf<Real> frustum = frustum_of(model);
    for (std::size_t first = 0; first < squares.size() && !frame_.stopped();
         first += cells_at_once) {
        const auto some = squares.subspan(first, std::min(cells_at_once, squares.size() - first));
        const std::size_t size = padded(some.size(), frame_.kernel.lane_multiple);
        fill_cells(some, size);
        counters.form += some.size();
        auto batch = cells_.batch(size, frustum, frame_.scene.uniforms.template boxes<Real>());
        batch.branches = branches_.data();
        if (model.is_ray()) {
            frame_.kernel.ray_form(batch);
        } else {
            frame_.kernel.form(batch);
        }
        for (std::size_t i = 0; i < some.size(); ++i) {
            const CoverSquare& square = field_.square(some[i]);
            Front& front = field_.fronts(some[i])[surface_];
            front.advance(verdict_of(square, front, i),
                          {.fair_length = field_.fair_length(square, front.at), .margin = margin_});
        }
    }
}

}  // namespace

void advance_fronts(const TraceFrame& frame, std::size_t surface, SquareField& field,
                    std::span<const std::size_t> squares, Counters& counters) {
    if (squares.empty()) return;
    if (frame.precision == Precision::Double) {
        SquareCells<double>(frame, surface, field).evaluate(squares, counters);
    } else {
        SquareCells<float>(frame, surface, field).evaluate(squares, counters);
    }
}

}  // namespace zeroset
