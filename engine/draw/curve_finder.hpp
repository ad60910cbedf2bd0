#pragma once

#include "engine/draw/curve_cells.hpp"
#include "engine/draw/space_curve.hpp"

#include <cstddef>
#include <vector>

namespace zeroset {

/// A report on what a search for curves could prove.
struct FindingReport {
    std::size_t cells = 0;     ///< looked at
    std::size_t regular = 0;   ///< in which all of the curve is proved to be what was followed
    std::size_t open = 0;      ///< in which more may be
    std::size_t singular = 0;  ///< on curves where the surface meets itself
    double open_pt = 0.0;      ///< the diameter of the largest of these on the page
    std::size_t stuck = 0;     ///< ends of curves within the domain
    bool in_time = true;       ///< the search was not cut

    FindingReport& operator+=(const FindingReport& other);
};

struct FoundCurves {
    std::vector<SpaceCurve> curves;
    FindingReport report;
};

/// Finds the curves of a system in a domain. Beside the curves and the report's open cells there
/// are none.
FoundCurves find_curves(const CurveSystem& system, const CurveDomain& domain,
                        const SearchLimits& limits);

}  // namespace zeroset
