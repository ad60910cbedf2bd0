#include "engine/antialias/edge_verdict.hpp"

#include "engine/antialias/cover_rules.hpp"

#include <algorithm>

namespace zeroset {
namespace {

constexpr SquarePart unknown_part{.share = 0.0, .x = 0.0, .y = 0.0};

constexpr LinearOnSquare all_of_square{.value = -1.0, .by_x = 0.0, .by_y = 0.0};

/// The level of which edges are not divided.
int last_level_of(bool is_inside) { return is_inside ? last_edge_level : last_wall_level; }

std::optional<LinearOnSquare> line_of(const EdgeSamples& samples, const CoverSquare& square,
                                      bool is_inside) {
    const LineRules rules = line_rules(square, is_inside);
    return fit_edge(samples, rules.error, rules.flat_too);
}

/// The edge of a root that rays may miss at their far ends, or have cut away where they enter.
std::optional<LinearOnSquare> line_cut_away(const EdgeSquare& edge) {
    const EdgeSamples entry = entry_samples(edge.stretches);
    const bool is_entry_below = is_all_below(entry);
    const bool is_least_below = is_all_below(edge.samples);
    if (is_entry_below && is_least_below) return all_of_square;
    if (is_entry_below) return line_of(edge.samples, edge.square, false);
    return is_least_below ? line_of(entry, edge.square, false) : std::nullopt;
}

/// Whether f, which is above 0 where samples are, may come to 0 and go away again between the ends
/// of long stretches: it is least at an end of each.
bool may_hide_roots(const EdgeSquare& edge) {
    const bool any_inner =
        std::ranges::any_of(edge.stretches, [](const RayStretch& ray) { return ray.inner; });
    return line_rules(edge.square, true).may_hide && !any_inner && edge.samples.roots() == 0;
}

}  // namespace

LineRules line_rules(const CoverSquare& square, bool is_inside) {
    return {.error = square.level < last_level_of(is_inside)
                         ? std::min(most_error_of_line / square.side, most_error_of_edge)
                         : 2.0 * most_error_of_edge,
            .flat_too = square.level >= first_flat_level,
            .may_hide = square.level < first_one_slope_level};
}

EdgeSamples samples_at_walls(const CoverSquare& square, const Front& front,
                             SquareStretches stretches) {
    if (!front.kinked && square.level >= first_one_end_level) {
        if (const auto at_one_end = one_end_samples(stretches)) return *at_one_end;
    }
    return edge_samples(stretches);
}

std::optional<LinearOnSquare> line_at_walls(const EdgeSquare& edge) {
    auto line = edge.samples.before_end.front() ? line_of(edge.samples, edge.square, false)
                                                : line_cut_away(edge);
    if (line || !edge.all_have_roots()) return line;
    const bool changes = !edge.front.kinked && signs_of(edge.stretches) == Signs::Changed;
    const bool is_covered =
        changes || (is_all_below(edge.samples) && is_all_below(entry_samples(edge.stretches)));
    return is_covered ? std::optional(all_of_square) : std::nullopt;
}

EdgeVerdict inside_verdict(const EdgeSquare& edge, bool has_own_hit) {
    const bool all = edge.all_have_roots();
    if (all && edge.front.calm && has_own_hit) return EdgeStep::LeavePlain;
    // Try a line, then a thread.
    const auto line = line_of(edge.samples, edge.square, true);
    if (!line) {
        const double side = edge.square.side;
        const auto thread = fit_thread(edge.stretches, 0.5 * side, 2.0 * thinnest_thread / side);
        if (thread) return thread_verdict(edge, *thread);
    }
    if (may_hide_roots(edge)) return EdgeStep::Divide;
    const bool one_colored = line && !(edge.front.kinked && is_all_below(edge.samples));
    if (all && !one_colored && edge.square.level < last_color_level) return EdgeStep::SeekCreases;
    return line ? line_verdict(edge, *line) : EdgeStep::Rough;
}

EdgeVerdict line_verdict(const EdgeSquare& edge, const LinearOnSquare& line) {
    const SquarePart part = part_below_zero(line);
    if (!(part.share > 0.0)) return EdgeStep::Pass;
    const int level = edge.square.level;
    const bool kinked =
        edge.front.kinked && (level < first_one_slope_level || !is_one_slope(edge.stretches));
    if (kinked && level < last_kinked_edge_level) return EdgeStep::Divide;
    // The ray in the middle of the part is like most of them; a wall may cut it.
    const SquareRay middle{.x = part.x, .y = part.y};
    const std::size_t nearest = edge.samples.nearest_hit(middle);
    const bool is_sure = edge.is_inside() || edge.samples.height[nearest] > 0.0;
    const RayRoot root = edge.samples.bracket(edge.stretches, nearest);
    return EdgeCover{.place = is_sure ? middle : square_rays[nearest],
                     .share = part.share,
                     .from = root.from,
                     .to = root.to,
                     .certificate = Certificate::Certified,
                     .rest = rest_beside(part, edge.samples.misses())};
}

EdgeVerdict thread_verdict(const EdgeSquare& edge, const Thread& thread) {
    if (thread.empty) return EdgeStep::Pass;
    const bool is_proved = thread.half_width > 0.0;
    const double share =
        thread.share(is_proved ? thread.half_width : thread_width / edge.square.side);
    const RayStretch& ray = edge.stretches[edge.samples.deepest()];
    // Behind the thread, and beside it, is what all rays meet.
    SquareRayFlags beside{};
    beside.fill(true);
    return EdgeCover{.place = thread.middle(),
                     .share = share,
                     .from = ray.from,
                     .to = ray.at,
                     .certificate = is_proved ? Certificate::Certified : Certificate::Undecided,
                     .rest = {.share = 1.0 - share, .part = unknown_part, .misses = beside}};
}

bool may_be_touched(const EdgeSquare& edge) {
    return edge.front.continuous && edge.is_inside() &&
           is_touched_everywhere(edge.samples, edge.stretches);
}

EdgeVerdict rough_verdict(const EdgeSquare& edge, bool is_sheet) {
    const bool is_inside = edge.is_inside();
    const int level = edge.square.level;
    // Divide down to the last level.
    const int last = edge.front.continuous ? last_level_of(is_inside) : last_broken_level;
    const bool all = is_sheet || (edge.all_have_roots() && level >= std::min(last, last_level));
    if (!all && level < last) return EdgeStep::Divide;
    if (!edge.front.continuous) return EdgeStep::DivideIntoRays;
    // The square is as small as squares get: where f comes near to 0 it is drawn
    // [Florez08, sec. 5.5.2].
    const std::size_t roots = edge.samples.roots();
    const bool thread = !is_sheet && roots == 0;
    if (thread && !(is_inside && is_touched(edge.samples, edge.stretches))) return EdgeStep::Pass;
    const std::size_t deepest = edge.samples.deepest();
    const RayRoot root = edge.samples.bracket(edge.stretches, deepest);
    const double rooted = is_sheet ? 1.0 : static_cast<double>(roots) / square_ray_count;
    return EdgeCover{
        .place = square_rays[deepest],
        .share = thread ? thread_width / edge.square.side : rooted,
        .from = root.from,
        .to = root.to,
        .certificate = roots == 0 ? Certificate::Undecided : Certificate::Certified,
        .rest = {.share = 1.0 - rooted, .part = unknown_part, .misses = edge.samples.misses()}};
}

}  // namespace zeroset
