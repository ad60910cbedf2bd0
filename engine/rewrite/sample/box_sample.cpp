#include "engine/rewrite/sample/box_sample.hpp"

#include "engine/algebra/algebra.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace zeroset {
namespace {

constexpr int first_level = 2;  ///< cells of an edge of 2^-2 of the region
constexpr int last_level = 9;
constexpr std::size_t cells_a_level = 48;
// A search goes on below the last level; there, enclosures behave as at the last.
constexpr double last_level_weight = 4.0;

/// Well mixed bits of a number [Steele14, splitmix64].
std::uint64_t mixed(std::uint64_t n) {
    n += 0x9e3779b97f4a7c15ULL;
    n = (n ^ (n >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    n = (n ^ (n >> 27U)) * 0x94d049bb133111ebULL;
    return n ^ (n >> 31U);
}

/// In [0, 1).
double fraction(std::uint64_t n) { return static_cast<double>(mixed(n) >> 11U) * 0x1p-53; }

Interval<float> float_interval(double lo, double hi) {
    return {.neg_lo = float_above(-lo), .hi = float_above(hi)};
}

bool is_rejected(const Enclosure<float>& f) {
    const Interval<float> range = answer(f);
    return range.neg_lo < 0 || range.hi < 0;
}

float width_of(const Enclosure<float>& f) {
    return std::min(f.range.neg_lo + f.range.hi, std::numeric_limits<float>::max());
}

/// A node's enclosures over all cells.
struct Column {
    const Enclosure<float>* values;
    const Facts& facts;

    Operand<Enclosure<float>> operator[](std::size_t i) const {
        return {.value = values[i], .facts = facts};
    }
};

template <class Function>
void for_all(std::span<Enclosure<float>> out, Function function) {
    IntervalAlgebra<float> algebra;
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = function(algebra, i);
}

/// The common operators are chosen outside of the loop, which is twice as fast.
void apply_to_all(const Node& node, const Column& a, const Column& b, const Column& c,
                  std::span<Enclosure<float>> out) {
    if (node.op == Op::Add) {
        for_all(out, [&](auto& algebra, std::size_t i) { return algebra.add(a[i], b[i]); });
    } else if (node.op == Op::Subtract) {
        for_all(out, [&](auto& algebra, std::size_t i) { return algebra.subtract(a[i], b[i]); });
    } else if (node.op == Op::Multiply) {
        for_all(out, [&](auto& algebra, std::size_t i) { return algebra.multiply(a[i], b[i]); });
    } else {
        for_all(out, [&](auto& algebra, std::size_t i) {
            return apply(algebra, node, a[i], b[i], c[i]);
        });
    }
}

}  // namespace

BoxSample::BoxSample(const Expr& expr, std::span<const Facts> facts, const SampleRegion& region)
    : uniforms_(region.uniforms) {
    std::vector<Cell> level_cells = first_cells(region);
    double reached = 1.0;  // the share of the region's cells at this level that are looked at
    for (int level = first_level; level <= last_level && !level_cells.empty(); ++level) {
        const auto count = level_cells.size();
        const auto values = evaluate(expr, facts, level_cells);
        const double below = level == last_level ? last_level_weight : 1.0;
        std::vector<Cell> kept;
        for (std::size_t i = 0; i < count; ++i) {
            const Enclosure<float>& f = values[expr.root() * count + i];
            level_cells[i].width = width_of(f);
            // A ray meets about 2^level cells of a level.
            level_cells[i].weight = std::ldexp(reached, level) * below / static_cast<double>(count);
            if (!is_rejected(f)) kept.push_back(level_cells[i]);
        }
        cells_.insert(cells_.end(), level_cells.begin(), level_cells.end());
        reached *= static_cast<double>(kept.size()) / static_cast<double>(count);
        level_cells = children(kept, cells_a_level);
    }
    share_with_zeros_ = reached;
}

std::vector<BoxSample::Cell> BoxSample::first_cells(const SampleRegion& region) const {
    constexpr auto n = std::size_t{1} << static_cast<unsigned>(first_level);
    std::vector<Cell> cells;
    for (std::size_t i = 0; i < n * n * n; ++i) {
        Cell cell{.axes = {}, .slot = mixed(i) % slots};
        const std::array<std::size_t, 3> at{i % n, i / n % n, i / (n * n)};
        for (std::size_t v = 0; v < 3; ++v) {
            const double step = (region.hi[v] - region.lo[v]) / static_cast<double>(n);
            const double lo = region.lo[v] + step * static_cast<double>(at[v]);
            cell.axes[v] = float_interval(lo, lo + step);
        }
        cells.push_back(cell);
    }
    return cells;
}

std::vector<BoxSample::Cell> BoxSample::children(std::span<const Cell> parents,
                                                 std::size_t count) const {
    std::vector<Cell> cells;
    for (std::size_t i = 0; i < count && !parents.empty(); ++i) {
        const std::uint64_t random = mixed(i);
        Cell cell =
            parents[(i * parents.size() + random % parents.size()) / count % parents.size()];
        for (std::size_t v = 0; v < 3; ++v) {
            Interval<float>& axis = cell.axes[v];
            const float middle = 0.5F * (axis.hi - axis.neg_lo);
            const bool upper = ((random >> (8 + v)) & 1U) != 0;
            axis = upper ? Interval<float>{.neg_lo = -middle, .hi = axis.hi}
                         : Interval<float>{.neg_lo = axis.neg_lo, .hi = middle};
        }
        cells.push_back(cell);
    }
    return cells;
}

Interval<float> BoxSample::variable(const Cell& cell, int index) const {
    const auto v = static_cast<std::size_t>(index);
    if (v < 3) return cell.axes[v];
    const std::size_t item = v - 3;
    const std::array<double, 2> ends =
        item < uniforms_.size() ? uniforms_[item] : std::array<double, 2>{0.0, 1.0};
    const double at = ends[0] + (ends[1] - ends[0]) * fraction(item * slots + cell.slot);
    return float_interval(at, at);
}

std::vector<Enclosure<float>> BoxSample::evaluate(const Expr& expr, std::span<const Facts> facts,
                                                  std::span<const Cell> cells) const {
    const std::size_t count = cells.size();
    std::vector<Enclosure<float>> values(expr.nodes().size() * count);
    const auto column = [&](NodeId id) {
        return Column{.values = values.data() + id * count, .facts = facts[id]};
    };
    for (NodeId id = 0; id <= expr.root(); ++id) {
        const Node& node = expr.node(id);
        Enclosure<float>* const out = values.data() + id * count;
        if (facts[id].constant) {
            const Interval<double>& c = *facts[id].constant;
            std::fill_n(out, count,
                        Enclosure<float>{
                            .range = {.neg_lo = float_above(c.neg_lo), .hi = float_above(c.hi)}});
        } else if (node.op == Op::Variable) {
            for (std::size_t i = 0; i < count; ++i)
                out[i] = {.range = variable(cells[i], node.number)};
        } else {
            const int operands = arity(node.op);
            apply_to_all(node, column(node.a), column(operands < 2 ? node.a : node.b),
                         column(operands < 3 ? node.a : node.c), {out, count});
        }
    }
    return values;
}

std::vector<BoxSample::Work> BoxSample::work(const Expr& expr, std::span<const Facts> facts,
                                             std::span<const NodeId> nodes,
                                             std::size_t stride) const {
    std::vector<Cell> cells;
    for (std::size_t i = 0; i < cells_.size(); i += stride)
        cells.push_back(cells_[i]);
    const auto values = evaluate(expr, facts, cells);
    std::vector<Work> result;
    for (const NodeId id : nodes) {
        Work work{.boxes = 0.0, .width = 0.0};
        double weights = 0.0;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const Enclosure<float>& f = values[id * cells.size() + i];
            const double weight = cells[i].weight;
            weights += weight;
            if (!is_rejected(f)) work.boxes += weight;
            const bool comparable = cells[i].width > 0;
            work.width +=
                comparable ? weight * static_cast<double>(width_of(f) / cells[i].width) : weight;
        }
        work.width /= weights;
        result.push_back(work);
    }
    return result;
}

}  // namespace zeroset
