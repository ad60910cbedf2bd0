#pragma once

#include "engine/draw/curve_finder.hpp"
#include "engine/draw/page.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// The kinds of drawn curves.
enum class CurveKind : std::uint8_t {
    Silhouette,    ///< where rays from the eye touch the surface
    Crease,        ///< where the surface has an edge, or meets itself
    Boundary,      ///< where the surface ends, or is cut by the clip box or the region
    Intersection,  ///< where two surfaces meet
    Contour,       ///< where a number on the surface is a whole multiple of a step
};
std::span<const CurveKind> curve_kinds();
/// "silhouette", "crease", "boundary", "intersection", "contour".
std::string_view name_of(CurveKind kind);
std::optional<CurveKind> curve_kind_named(std::string_view name);

/// A cubic Bezier curve by its four control points, in points of the page.
using Bezier = std::array<glm::dvec2, 4>;

/// A curve of a drawing: pieces that begin where the one before ends.
struct DrawnPath {
    CurveKind kind = CurveKind::Silhouette;
    std::size_t surface = 0;           ///< index of the surface; of intersections the first
    std::optional<double> level = {};  ///< of a contour line
    bool hidden = false;               ///< a surface lies before it
    bool closed = false;
    std::vector<Bezier> pieces = {};
};

/// A straight line of axes, box or grid, in points of the page; one of no length is a dot.
struct DrawnLine {
    glm::dvec2 from, to;
    double width_pt = 1.0;
    std::uint32_t color = 0;  ///< 0xRRGGBB
    bool hidden = false;      ///< a surface lies before it
};

/// A number, a name or a label.
struct DrawnText {
    std::string words;  ///< one line of UTF-8
    glm::dvec2 middle;  ///< of its width, half as high as its digits, in points of the page
    double em_pt = 10.0;
    std::uint32_t color = 0;  ///< 0xRRGGBB
};

/// Lines and letters beside and behind the curves of a drawing.
struct DrawnMarks {
    std::vector<DrawnLine> lines = {};  ///< below the curves
    std::vector<DrawnText> texts = {};  ///< over them
};

/// Curves on a page, as plain numbers.
struct LineDrawing {
    PageSize size;
    std::vector<DrawnPath> paths = {};
    DrawnMarks marks = {};
    FindingReport report = {};
    std::array<bool, 5> cut{};  ///< by CurveKind: the time did not suffice for all of them
    bool all_seams = true;      ///< false: some jumps are left out, as there were too many
    std::optional<double> contour_width_pt = {};  ///< if one was asked for with the contour lines
    /// A surface is of a volume between whose samples f is no smooth function: it has corners
    /// there, in place of the lines that are followed.
    bool has_linear_volume = false;

    /// "some silhouettes may be missing": one line on what it may lack where lines are to be within
    /// `tolerance_pt`; empty if nothing.
    [[nodiscard]] std::string lacks(double tolerance_pt) const;
    [[nodiscard]] bool in_time() const { return std::ranges::find(cut, true) == cut.end(); }
};

}  // namespace zeroset
