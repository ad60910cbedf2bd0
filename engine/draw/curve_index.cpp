#include "engine/draw/curve_index.hpp"

#include <algorithm>

namespace zeroset {
namespace {

/// Bounds of the points that are kept from one point of a curve to the next.
constexpr double most_share = 0.25;
constexpr double least_share = 1.0 / 256.0;

}  // namespace

void CurveIndex::add(const SpaceCurve& curve, std::size_t number,
                     const std::function<double(const glm::dvec3&)>& spacing) {
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const bool is_last = i + 1 == curve.points.size();
        if (is_last && !curve.closed)
            return add({.curve = number, .point = i}, curve.points[i].place);
        const CurvePoint& next = curve.points[is_last ? 0 : i + 1];
        const double length = glm::distance(curve.points[i].place, next.place);
        for (double share = 0.0; share < 1.0;) {
            const glm::dvec3 point = between(curve.points[i], next, share);
            add({.curve = number, .point = i, .share = share}, point);
            share += std::clamp(spacing(point) / length, least_share, most_share);
        }
    }
}

void CurveIndex::add(const PlaceOnCurve& at, const glm::dvec3& point) {
    for (int level = first_level_; level <= last_level_; ++level)
        points_[key_of(place_of(domain_, level, point))].push_back(at);
}

std::vector<PlaceOnCurve> CurveIndex::near(const CellPlace& place) const {
    constexpr int neighbours = 27;
    std::vector<PlaceOnCurve> found;
    const int level = std::clamp(place.level, first_level_, last_level_);
    const int shift = place.level - level;
    const int cells = 1 << level;
    for (int i = 0; i < neighbours; ++i) {
        CellPlace next{.level = level, .at = {i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1}};
        bool exists = true;
        for (int axis = 0; axis < 3; ++axis) {
            if (domain_.is_flat(axis)) {
                exists = exists && next.at[axis] == 0;
            } else {
                next.at[axis] += place.at[axis] >> shift;
                exists = exists && next.at[axis] >= 0 && next.at[axis] < cells;
            }
        }
        if (!exists) continue;
        const auto points = points_.find(key_of(next));
        if (points != points_.end())
            found.insert(found.end(), points->second.begin(), points->second.end());
    }
    return found;
}

}  // namespace zeroset
