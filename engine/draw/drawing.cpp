#include "engine/draw/drawing.hpp"

#include <algorithm>
#include <cstddef>

namespace zeroset {
namespace {

constexpr std::array<CurveKind, 5> all_kinds{CurveKind::Silhouette, CurveKind::Crease,
                                             CurveKind::Boundary, CurveKind::Intersection,
                                             CurveKind::Contour};
constexpr std::array<std::string_view, 5> all_names{"silhouette", "crease", "boundary",
                                                    "intersection", "contour"};

}  // namespace

std::span<const CurveKind> curve_kinds() { return all_kinds; }

std::string_view name_of(CurveKind kind) { return all_names.at(static_cast<std::size_t>(kind)); }

std::optional<CurveKind> curve_kind_named(std::string_view name) {
    const auto* const found = std::ranges::find(all_names, name);
    if (found == all_names.end()) return std::nullopt;
    return all_kinds.at(static_cast<std::size_t>(found - all_names.begin()));
}

}  // namespace zeroset
