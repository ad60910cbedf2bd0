#include "engine/mesh/field_at_points.hpp"

#include "engine/mesh/parallel.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace zeroset {
namespace {

constexpr std::size_t points_at_once = 512;
// A level where the gradient vanishes: farther than anything.
constexpr double far_level = 1e30;

/// f divided by the length of its gradient: about the distance from its zeros; `far_level` where
/// that is not known, +inf where f is not defined.
double level_of(double f, double slope) {
    const double level = f / slope;
    if (std::isfinite(level) && std::isfinite(slope)) return level;
    if (std::isnan(f)) return std::numeric_limits<double>::infinity();
    return f == 0.0 ? 0.0 : std::copysign(far_level, f);
}

/// The direction of a gradient; 0 where it, or the level, is not known.
glm::dvec3 direction_of(const glm::dvec3& gradient, double level) {
    const double slope = glm::length(gradient);
    const bool known = std::abs(level) < far_level && slope > 0 && std::isfinite(slope);
    return known ? gradient / slope : glm::dvec3(0.0);
}

SolidValue value_of(double f, const glm::dvec3& gradient, std::size_t part) {
    const double level = level_of(f, glm::length(gradient));
    return {.level = level,
            .normal = direction_of(gradient, level),
            .part = static_cast<std::uint32_t>(part)};
}

/// Values of all parts at some points, one array for each part and node; one for each thread.
class PartValues {
public:
    void evaluate(const MeshSolid& solid, std::span<const glm::dvec3> points,
                  std::span<SolidValue> values, Normals normals);

private:
    /// Levels of a part or a node at all points, and whose they are.
    struct Levels {
        std::array<double, points_at_once> level;
        std::array<std::uint32_t, points_at_once> part;
    };

    void evaluate_part(const MeshSolid& solid, std::size_t part);
    void join(const MeshSolid& solid, std::size_t node);
    void take_cut(const MeshSolid& solid, std::size_t cut, std::span<const glm::dvec3> points);
    [[nodiscard]] glm::dvec3 normal(const MeshSolid& solid, std::size_t i,
                                    const glm::dvec3& point) const;

    PointBatch<double> batch_;
    std::size_t count_ = 0;
    std::vector<std::array<double, points_at_once>> levels_;         ///< of parts
    std::vector<std::array<glm::dvec3, points_at_once>> gradients_;  ///< of parts
    std::vector<Levels> nodes_;
};

void PartValues::evaluate_part(const MeshSolid& solid, std::size_t part) {
    solid.parts[part].value(batch_.batch(solid.uniforms.points<double>()));
    for (std::size_t i = 0; i < count_; ++i) {
        const glm::dvec3 gradient(batch_.gradient(0, i), batch_.gradient(1, i),
                                  batch_.gradient(2, i));
        gradients_[part][i] = gradient;
        levels_[part][i] = level_of(batch_.f(i), glm::length(gradient));
    }
}

/// Makes a node's levels of the part's or of its two nodes'.
void PartValues::join(const MeshSolid& solid, std::size_t node) {
    const SolidNode& own = solid.nodes[node];
    Levels& result = nodes_[node];
    if (own.kind == SolidNode::Kind::Leaf) {
        const std::array<double, points_at_once>& levels = levels_[own.a];
        for (std::size_t i = 0; i < count_; ++i) {
            const bool turned = own.sign < 0 && std::isfinite(levels[i]);
            result.level[i] = turned ? -levels[i] : levels[i];
        }
        std::fill_n(result.part.begin(), count_, own.a);
        return;
    }
    const Levels& a = nodes_[own.a];
    const Levels& b = nodes_[own.b];
    const bool is_max = own.kind == SolidNode::Kind::Max;
    for (std::size_t i = 0; i < count_; ++i) {
        const bool takes_a = (a.level[i] >= b.level[i]) == is_max;
        result.level[i] = takes_a ? a.level[i] : b.level[i];
        result.part[i] = takes_a ? a.part[i] : b.part[i];
    }
}

void PartValues::take_cut(const MeshSolid& solid, std::size_t cut,
                          std::span<const glm::dvec3> points) {
    const SolidCut& own = solid.cuts[cut];
    Levels& result = nodes_.back();
    const auto part = static_cast<std::uint32_t>(solid.parts.size() + cut);
    for (std::size_t i = 0; i < count_; ++i) {
        // A plane's slope is 1, so that its value is its level.
        const double f = own.value(points[i]);
        const double level = own.is_ball ? level_of(f, glm::length(own.gradient(points[i]))) : f;
        if (!(level > result.level[i])) continue;
        result.level[i] = level;
        result.part[i] = part;
    }
}

/// The direction of the gradient of the part that the solid is at point i.
glm::dvec3 PartValues::normal(const MeshSolid& solid, std::size_t i,
                              const glm::dvec3& point) const {
    const Levels& root = nodes_.back();
    if (!(std::abs(root.level[i]) < far_level)) return glm::dvec3(0.0);
    const std::uint32_t part = root.part[i];
    const bool is_cut = part >= solid.parts.size();
    const glm::dvec3 gradient =
        is_cut ? solid.cuts[part - solid.parts.size()].gradient(point) : gradients_[part][i];
    // A leaf turns its part's level, and so its slope.
    const bool turned = !is_cut && std::signbit(root.level[i]) != std::signbit(levels_[part][i]);
    const glm::dvec3 direction = direction_of(gradient, root.level[i]);
    return turned ? -direction : direction;
}

void PartValues::evaluate(const MeshSolid& solid, std::span<const glm::dvec3> points,
                          std::span<SolidValue> values, Normals normals) {
    count_ = points.size();
    batch_.resize(count_);
    for (std::size_t i = 0; i < count_; ++i)
        batch_.set(i, points[i].x, points[i].y, points[i].z);
    batch_.pad();
    levels_.resize(solid.parts.size());
    gradients_.resize(solid.parts.size());
    nodes_.resize(solid.nodes.size());
    for (std::size_t p = 0; p < solid.parts.size(); ++p)
        evaluate_part(solid, p);
    for (std::size_t n = 0; n < solid.nodes.size(); ++n)
        join(solid, n);
    for (std::size_t c = 0; c < solid.cuts.size(); ++c)
        take_cut(solid, c, points);
    for (std::size_t i = 0; i < count_; ++i)
        values[i] = {.level = nodes_.back().level[i], .part = nodes_.back().part[i]};
    if (normals == Normals::Without) return;
    for (std::size_t i = 0; i < count_; ++i)
        values[i].normal = normal(solid, i, points[i]);
}

}  // namespace

void field_here(const MeshSolid& solid, std::span<const glm::dvec3> points,
                std::span<SolidValue> values, Normals normals) {
    static thread_local PartValues parts;
    for (std::size_t first = 0; first < points.size(); first += points_at_once) {
        const std::size_t count = std::min(points_at_once, points.size() - first);
        parts.evaluate(solid, points.subspan(first, count), values.subspan(first, count), normals);
    }
}

std::vector<SolidValue> field_at(const MeshSolid& solid, std::span<const glm::dvec3> points,
                                 const MeshWork& work, Normals normals) {
    std::vector<SolidValue> values(points.size());
    parallel_upward(points.size(), points_at_once, work, [&](std::size_t first, std::size_t last) {
        field_here(solid, points.subspan(first, last - first),
                   std::span(values).subspan(first, last - first), normals);
    });
    return values;
}

std::vector<SolidValue> parts_at(const MeshSolid& solid, std::span<const PartPlace> places) {
    std::vector<SolidValue> values(places.size());
    PointBatch<double> batch;
    for (std::size_t p = 0; p < solid.parts.size(); ++p) {
        std::vector<std::size_t> own;
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (places[i].part == p) own.push_back(i);
        }
        if (own.empty()) continue;
        batch.resize(own.size());
        for (std::size_t k = 0; k < own.size(); ++k) {
            const glm::dvec3& point = places[own[k]].point;
            batch.set(k, point.x, point.y, point.z);
        }
        batch.pad();
        batch.evaluate(solid.parts[p].value, solid.uniforms.points<double>(), [] { return false; });
        const auto leaf = std::ranges::find_if(solid.nodes, [&](const SolidNode& node) {
            return node.kind == SolidNode::Kind::Leaf && node.a == p;
        });
        for (std::size_t k = 0; k < own.size(); ++k) {
            values[own[k]] =
                value_of(leaf->sign * batch.f(k),
                         leaf->sign * glm::dvec3(batch.gradient(0, k), batch.gradient(1, k),
                                                 batch.gradient(2, k)),
                         p);
        }
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i].part < solid.parts.size()) continue;
        const SolidCut& cut = solid.cuts[places[i].part - solid.parts.size()];
        values[i] =
            value_of(cut.value(places[i].point), cut.gradient(places[i].point), places[i].part);
    }
    return values;
}

}  // namespace zeroset
