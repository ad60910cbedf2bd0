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
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        const int level = first_level_ + static_cast<int>(i);
        add(at, key_of(place_of(domain_, level, point)), levels_[i]);
    }
}

void CurveIndex::add(const PlaceOnCurve& at, std::uint64_t key, Level& level) {
    const bool is_same_way = level.last.curve == at.curve && level.last.point == at.point;
    if (is_same_way && level.last_key == key) return;
    level.last = at;
    level.last_key = key;
    const auto entry = static_cast<std::uint32_t>(entries_.size());
    entries_.push_back({.at = at, .next = none});
    const auto [cell, is_new] = level.cells.try_emplace(key, Chain{.first = entry, .last = entry});
    if (is_new) return;
    entries_[cell->second.last].next = entry;
    cell->second.last = entry;
}

template <class Visit>
bool CurveIndex::visit_near(const CellPlace& place, Visit visit) const {
    constexpr int neighbours = 27;
    const int last_level = first_level_ + static_cast<int>(levels_.size()) - 1;
    const int level = std::clamp(place.level, first_level_, last_level);
    const auto& in_level = levels_[static_cast<std::size_t>(level - first_level_)].cells;
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
        const auto cell = in_level.find(key_of(next));
        if (cell == in_level.end()) continue;
        for (std::uint32_t k = cell->second.first; k != none; k = entries_[k].next) {
            if (visit(entries_[k].at)) return true;
        }
    }
    return false;
}

void CurveIndex::near(const CellPlace& place, std::vector<PlaceOnCurve>& found) const {
    found.clear();
    visit_near(place, [&](const PlaceOnCurve& at) {
        found.push_back(at);
        return false;
    });
}

bool CurveIndex::has_near(const CellPlace& place) const {
    return visit_near(place, [](const PlaceOnCurve&) { return true; });
}

}  // namespace zeroset
