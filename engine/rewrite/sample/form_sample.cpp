#include "engine/rewrite/sample/form_sample.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/kernel/form_cells.hpp"
#include "engine/real/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>

namespace zeroset {
namespace {

constexpr int first_form_level = 2;  ///< cells of an edge of 2^-2 of the region's longest
constexpr int last_form_level = 7;
constexpr std::size_t first_side = std::size_t{1} << static_cast<unsigned>(first_form_level);

constexpr double distance = 4;  ///< of the eye, in halves of the longest edge
constexpr double right[] = {0.848, 0.530, 0.0};
constexpr double up[] = {-0.228, 0.365, 0.9026};
constexpr double forward[] = {-0.4784, 0.7654, -0.4305};

/// Where |c + k[0] eu + k[1] ev + k[2] et| <= e in one quarter of a cell's width: the share of et.
double open_share(const auto& cells, std::size_t i) {
    const auto sizes = [&](std::size_t k) { return std::abs(static_cast<double>(cells.k[k][i])); };
    const double e = static_cast<double>(cells.e[i]);
    const double aside = 0.5 * (sizes(0) + sizes(1)) + e;
    if (cells.nowhere[i] != 0) return 0.0;
    if (std::abs(static_cast<double>(cells.c[i])) > sizes(0) + sizes(1) + sizes(2) + e) return 0.0;
    return aside < sizes(2) ? aside / sizes(2) : 1.0;
}

FrustumOf<float> frustum_of(const std::array<double, 3>& middle, double half, double radius) {
    FrustumOf<float> frustum{};
    const double from_eye = distance * half;
    frustum.distance = static_cast<float>(from_eye);
    frustum.u_radius = frustum.v_radius = static_cast<float>(radius / from_eye);
    for (std::size_t i = 0; i < 3; ++i) {
        frustum.base[i] = static_cast<float>(middle[i]);
        frustum.right[i] = static_cast<float>(right[i]);
        frustum.up[i] = static_cast<float>(up[i]);
        frustum.forward[i] = static_cast<float>(forward[i]);
        frustum.size[i] = static_cast<float>(std::abs(middle[i]) + from_eye);
        frustum.direction_size[i] = 2.0F;
    }
    return frustum;
}

}  // namespace

FormSample::FormSample(const Expr& expr, const SampleRegion& region) {
    for (std::size_t i = 0; i < 3; ++i) {
        middle_[i] = 0.5 * (region.lo[i] + region.hi[i]);
        half_ = std::max(half_, 0.5 * (region.hi[i] - region.lo[i]));
    }
    for (std::size_t i = 0; i <= expr.parameters().size(); ++i) {
        const bool known = i < region.uniforms.size();
        uniforms_.set(i, known ? 0.5 * (region.uniforms[i][0] + region.uniforms[i][1]) : 0.5);
    }
    const Kernel kernel = interpret(expr);
    static_assert(cells_a_level == first_side * first_side * first_side);
    static_assert(cells_a_level % batch_multiple == 0);
    Level level{.half = half_ / first_side, .cells = {}};
    for (std::size_t i = 0; i < cells_a_level; ++i) {
        const auto at = [&](std::size_t n) {
            return half_ * ((2.0 * static_cast<double>(n % first_side) + 1.0) / first_side - 1.0);
        };
        level.cells.push_back({at(i), at(i / first_side), at(i / (first_side * first_side))});
    }
    double sum = 0;
    for (int l = first_form_level;; ++l) {
        levels_.push_back(level);
        const std::vector<double> share = shares(kernel, level);
        sum += std::accumulate(share.begin(), share.end(), 0.0);
        std::vector<Place> kept;
        for (std::size_t i = 0; i < cells_a_level; ++i) {
            if (share[i] > 0) kept.push_back(level.cells[i]);
        }
        if (l == last_form_level || kept.empty()) break;
        level.half /= 2;
        for (std::size_t i = 0; i < cells_a_level; ++i) {
            // An eighth of each in turn, no two of them the same.
            Place& cell = level.cells[i] = kept[i * kept.size() / cells_a_level];
            for (std::size_t k = 0; k < 3; ++k)
                cell[k] += (i >> k & 1U) != 0 ? level.half : -level.half;
        }
    }
    open_ = sum / cells();
}

void FormSample::place(const Level& level, FormCells<float, cells_a_level>& cells) const {
    for (std::size_t i = 0; i < cells_a_level; ++i) {
        const Place& place = level.cells[i];
        const double from_eye = distance * half_ + place[2];
        cells.u[i] = static_cast<float>(place[0] / from_eye);
        cells.v[i] = static_cast<float>(place[1] / from_eye);
        cells.s[i] = static_cast<float>(place[2]);
        cells.s_radius[i] = static_cast<float>(level.half);
    }
}

std::vector<double> FormSample::shares(const Kernel& kernel, const Level& level) const {
    const UpwardRounding upward;
    const FrustumOf<float> frustum = frustum_of(middle_, half_, level.half);
    FormCells<float, cells_a_level> cells;
    place(level, cells);
    kernel.form(cells.batch(cells_a_level, frustum, uniforms_.boxes<float>()));
    std::vector<double> result;
    result.reserve(cells_a_level);
    for (std::size_t i = 0; i < cells_a_level; ++i)
        result.push_back(open_share(cells, i));
    return result;
}

double FormSample::open(const Expr& expr) const {
    const Kernel kernel = interpret(expr);
    double sum = 0;
    for (const Level& level : levels_) {
        const std::vector<double> share = shares(kernel, level);
        sum += std::accumulate(share.begin(), share.end(), 0.0);
    }
    return sum / cells();
}

double FormSample::steps_left(const Kernel& kernel) const {
    const auto all = static_cast<double>(kernel.steps);
    if (kernel.specializer == nullptr) return all;
    const UpwardRounding upward;
    const Level& level = levels_.back();
    const FrustumOf<float> frustum = frustum_of(middle_, half_, level.half);
    FormCells<float, cells_a_level> cells;
    place(level, cells);
    ChoiceRecord record;
    kernel.specializer->form(cells.batch(cells_a_level, frustum, uniforms_.boxes<float>()), record);
    double sum = 0;
    double count = 0;
    for (std::size_t i = 0; i < cells_a_level; ++i) {
        if (open_share(cells, i) == 0) continue;
        const auto specialized = kernel.specializer->specialized(record, std::span(&i, 1));
        sum += specialized ? static_cast<double>(specialized->steps) : all;
        ++count;
    }
    return count > 0 ? sum / count : all;
}

double FormSample::cells() const { return static_cast<double>(levels_.size() * cells_a_level); }

}  // namespace zeroset
