#include "engine/draw/curve_index.hpp"

#include <algorithm>

namespace zeroset {

void CurveIndex::add(const SpaceCurve& curve, std::size_t number) {
    for (int level = first_level_; level <= last_level_; ++level) {
        std::uint64_t last = ~std::uint64_t{0};
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            const std::uint64_t key = key_of(place_of(domain_, level, curve.points[i].place));
            if (key != last) points_[key].push_back({.curve = number, .point = i});
            last = key;
        }
    }
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
