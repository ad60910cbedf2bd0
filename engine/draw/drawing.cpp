#include "engine/draw/drawing.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

namespace zeroset {
namespace {

constexpr std::array<CurveKind, 5> all_kinds{CurveKind::Silhouette, CurveKind::Crease,
                                             CurveKind::Boundary, CurveKind::Intersection,
                                             CurveKind::Contour};
constexpr std::array<std::string_view, 5> all_names{"silhouette", "crease", "boundary",
                                                    "intersection", "contour"};
/// More than one line of each kind, in messages.
constexpr std::array<const char*, 5> all_plurals{marked("silhouettes"), marked("creases"),
                                                 marked("boundaries"), marked("intersections"),
                                                 marked("contours")};

}  // namespace

std::span<const CurveKind> curve_kinds() { return all_kinds; }

std::string_view name_of(CurveKind kind) { return all_names.at(static_cast<std::size_t>(kind)); }

std::optional<CurveKind> curve_kind_named(std::string_view name) {
    const auto* const found = std::ranges::find(all_names, name);
    if (found == all_names.end()) return std::nullopt;
    return all_kinds.at(static_cast<std::size_t>(found - all_names.begin()));
}

std::string LineDrawing::lacks(double tolerance_pt) const {
    if (!in_time()) {
        std::string names;
        for (const CurveKind kind : curve_kinds()) {
            const auto index = static_cast<std::size_t>(kind);
            if (cut.at(index))
                names += (names.empty() ? "" : ", ") + std::string(tr(all_plurals.at(index)));
        }
        return filled(tr("some {0} may be missing"), {names});
    }
    if (paths.empty() && has_linear_volume)
        return tr(
            "nothing is drawn: if the volume is in the view, type cubic behind its file's name, as "
            "in volume(\"ct.nrrd\", cubic); interpolated linearly it has corners, no silhouettes");
    if (paths.empty())
        return tr("nothing is drawn: none of the lines that are asked for is in the view");
    if (!all_seams) return tr("lines may be missing where f jumps: there are too many such places");
    if (!(report.open_pt > tolerance_pt)) return "";
    return filled(tr("lines may be missing in {0} places of up to {1} pt, where equations of lines "
                     "could not be told apart"),
                  {std::to_string(report.open), short_number(report.open_pt)});
}

}  // namespace zeroset
