#include "engine/mesh/field_at_points.hpp"

#include "engine/mesh/parallel.hpp"

#include <algorithm>
#include <limits>

namespace zeroset {
namespace {

constexpr std::size_t points_at_once = 512;
// A level where the gradient vanishes: farther than anything.
constexpr double far_level = 1e30;

SolidValue value_of(double f, const glm::dvec3& gradient, std::size_t part) {
    SolidValue value{.part = static_cast<std::uint32_t>(part)};
    const double slope = glm::length(gradient);
    if (std::isnan(f)) {
        value.level = std::numeric_limits<double>::infinity();
    } else if (slope > 0 && std::isfinite(slope) && std::isfinite(f / slope)) {
        value.level = f / slope;
        value.normal = gradient / slope;
    } else {
        value.level = f == 0.0 ? 0.0 : std::copysign(far_level, f);
    }
    return value;
}

/// Values of all parts at some points; one for each thread.
class PartValues {
public:
    void evaluate(const MeshSolid& solid, std::span<const glm::dvec3> points);
    /// The solid's value at point i: what the nodes make of the parts' values there.
    [[nodiscard]] SolidValue at(const MeshSolid& solid, std::size_t i);

private:
    PointBatch<double> batch_;
    std::vector<SolidValue> values_;  ///< of part p and point i at p * points_at_once + i
    std::vector<SolidValue> nodes_;
};

void PartValues::evaluate(const MeshSolid& solid, std::span<const glm::dvec3> points) {
    batch_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        batch_.set(i, points[i].x, points[i].y, points[i].z);
    batch_.pad();
    values_.resize(solid.parts.size() * points_at_once);
    for (std::size_t p = 0; p < solid.parts.size(); ++p) {
        solid.parts[p].value(batch_.batch(solid.uniforms.points<double>()));
        for (std::size_t i = 0; i < points.size(); ++i) {
            values_[p * points_at_once + i] =
                value_of(batch_.f(i),
                         {batch_.gradient(0, i), batch_.gradient(1, i), batch_.gradient(2, i)}, p);
        }
    }
}

SolidValue PartValues::at(const MeshSolid& solid, std::size_t i) {
    nodes_.resize(solid.nodes.size());
    for (std::size_t n = 0; n < solid.nodes.size(); ++n) {
        const SolidNode& node = solid.nodes[n];
        if (node.kind == SolidNode::Kind::Leaf) {
            nodes_[n] = values_[node.a * points_at_once + i];
            if (node.sign < 0 && std::isfinite(nodes_[n].level)) {
                nodes_[n].level = -nodes_[n].level;
                nodes_[n].normal = -nodes_[n].normal;
            }
            continue;
        }
        const SolidValue& a = nodes_[node.a];
        const SolidValue& b = nodes_[node.b];
        const bool takes_a = (a.level >= b.level) == (node.kind == SolidNode::Kind::Max);
        nodes_[n] = takes_a ? a : b;
    }
    return nodes_.back();
}

void take_cuts(const MeshSolid& solid, const glm::dvec3& point, SolidValue& value) {
    for (std::size_t c = 0; c < solid.cuts.size(); ++c) {
        const SolidCut& cut = solid.cuts[c];
        const double f = cut.value(point);
        // A plane's slope is 1, so that its value is its level.
        if (!cut.is_ball && !(f > value.level)) continue;
        const SolidValue own = value_of(f, cut.gradient(point), solid.parts.size() + c);
        if (own.level > value.level) value = own;
    }
}

}  // namespace

std::vector<SolidValue> field_at(const MeshSolid& solid, std::span<const glm::dvec3> points,
                                 const MeshWork& work) {
    std::vector<SolidValue> values(points.size());
    parallel_upward(points.size(), points_at_once, work, [&](std::size_t first, std::size_t last) {
        static thread_local PartValues parts;
        parts.evaluate(solid, points.subspan(first, last - first));
        for (std::size_t i = first; i < last; ++i) {
            values[i] = parts.at(solid, i - first);
            take_cuts(solid, points[i], values[i]);
        }
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
