#include "engine/draw/draw_scene.hpp"

#include "engine/base/parallel.hpp"
#include "engine/draw/bezier_fit.hpp"
#include "engine/draw/curve_tasks.hpp"
#include "engine/draw/hidden_points.hpp"
#include "engine/draw/page_curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace zeroset {
namespace {

/// Curves that are shorter on the page are left out.
constexpr double least_length_pt = 0.02;

bool is_in(const Region& region, const glm::dvec3& point) {
    constexpr double slack = 1e-9;
    const double size = glm::length(point);
    if (region.ball && glm::distance(point, region.ball->centre) >
                           region.ball->radius * (1.0 + slack) + slack * size)
        return false;
    return std::ranges::all_of(region.sections, [&](const Section& section) {
        return glm::dot(section.normal, point) <=
               section.offset + slack * (size + std::abs(section.offset));
    });
}

/// The curve's points on the page, with its directions there.
std::vector<PagePoint> page_points(const SpaceCurve& curve, const Page& page) {
    // Where a curve points to the eye its motion on the page says nothing of its direction.
    constexpr double least_motion = 0.05;
    std::vector<PagePoint> points;
    for (const CurvePoint& at : curve.points) {
        const glm::dvec2 motion = page.motion(at.place, at.tangent);
        const double length = glm::length(motion);
        const bool is_known = length > least_motion * page.scale(at.place);
        const PagePoint point{.place = page.place(at.place),
                              .tangent = is_known ? motion / length : glm::dvec2(0.0)};
        if (!points.empty() && glm::distance(points.back().place, point.place) < 1e-7) continue;
        points.push_back(point);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].tangent != glm::dvec2(0.0)) continue;
        const glm::dvec2 chord =
            points[std::min(i + 1, points.size() - 1)].place - points[i > 0 ? i - 1 : 0].place;
        if (glm::length(chord) > 0.0) points[i].tangent = glm::normalize(chord);
    }
    return points;
}

double length_of(const std::vector<PagePoint>& points) {
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += glm::distance(points[i].place, points[i - 1].place);
    return length;
}

/// Gives runs that are too short to be seen the state of the run beside: a surface does not hide
/// what is nearest to it.
void forget_short_runs(std::vector<CurveRun>& runs, const Page& page) {
    constexpr double seen_pt = 0.15;
    for (std::size_t i = 0; i < runs.size() && runs.size() > 1; ++i) {
        if (length_of(page_points(runs[i].curve, page)) < seen_pt)
            runs[i].state = runs[i > 0 ? i - 1 : 1].state;
    }
}

/// Draws the curves of one task.
class TaskDrawer {
public:
    TaskDrawer(const CurveTask& task, const DrawOptions& options, const Page& page,
               const HiddenPoints& hidden)
        : task_(task), options_(options), page_(page), hidden_(hidden), system_(task.equations) {}

    LineDrawing run(const TimeLimit& limit) {
        const SearchLimits limits{.smallest_pt = options_.tolerance_pt, .time = limit};
        const CurveDomain domain{.box = task_.box, .region = task_.region, .page = page_};
        const FoundCurves found = find_curves(system_, domain, limits);
        drawing_.report = found.report;
        for (const SpaceCurve& curve : found.curves) {
            if (!limit.over()) add_curve(refined(system_, curve, page_));
        }
        return std::move(drawing_);
    }

private:
    void add_curve(const SpaceCurve& curve);
    void add_shown(const SpaceCurve& curve);
    void add_run(const CurveRun& run);
    [[nodiscard]] bool is_shown(const CurvePoint& point) const {
        return is_in(task_.region, point.place) && (!task_.is_shown || task_.is_shown(point));
    }
    /// 1 or 0: which way a silhouette's ray touches the surface; changes at cusps.
    [[nodiscard]] int touch(const CurvePoint& point) const;
    [[nodiscard]] std::vector<int> states_of(const SpaceCurve& curve) const;

    const CurveTask& task_;
    const DrawOptions& options_;
    const Page& page_;
    const HiddenPoints& hidden_;
    CurveSystem system_;
    LineDrawing drawing_;
    bool goes_on_ = false;  ///< the next run begins where the last path ends
};

int TaskDrawer::touch(const CurvePoint& point) const {
    if (task_.kind != CurveKind::Silhouette) return 0;
    const Linearized there = system_.at(point.place);
    return glm::dot(there.gradients[1], page_.ray_direction(point.place)) > 0.0 ? 1 : 0;
}

void TaskDrawer::add_curve(const SpaceCurve& curve) {
    std::vector<int> shown;
    shown.reserve(curve.points.size());
    for (const CurvePoint& point : curve.points)
        shown.push_back(is_shown(point) ? 1 : 0);
    const auto state = [this](const CurvePoint& point) { return is_shown(point) ? 1 : 0; };
    for (const CurveRun& run : divided(system_, curve, page_, shown, state)) {
        if (run.state == 1) add_shown(run.curve);
    }
}

std::vector<int> TaskDrawer::states_of(const SpaceCurve& curve) const {
    std::vector<glm::dvec3> places;
    places.reserve(curve.points.size());
    for (const CurvePoint& point : curve.points)
        places.push_back(point.place);
    std::vector<std::uint8_t> hidden(places.size());
    hidden_.find(places, hidden);
    std::vector<int> states;
    states.reserve(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        states.push_back(hidden[i] + 2 * touch(curve.points[i]));
    return states;
}

void TaskDrawer::add_shown(const SpaceCurve& curve) {
    const auto state = [this](const CurvePoint& point) {
        return (hidden_.is_hidden(point.place) ? 1 : 0) + 2 * touch(point);
    };
    goes_on_ = false;
    std::vector<CurveRun> runs = divided(system_, curve, page_, states_of(curve), state);
    forget_short_runs(runs, page_);
    for (const CurveRun& run : runs)
        add_run(run);
}

/// Adds a run as a path, or to the last one if it goes on from there.
void TaskDrawer::add_run(const CurveRun& run) {
    const bool hidden = run.state % 2 == 1;
    const bool goes_on = goes_on_ && drawing_.paths.back().hidden == hidden;
    goes_on_ = false;
    if (hidden && !options_.hidden) return;
    std::vector<PagePoint> points = page_points(run.curve, page_);
    if (run.curve.closed) points.push_back(points.front());
    if (points.size() < 2 || length_of(points) < least_length_pt) return;
    std::vector<Bezier> pieces = fitted(points, 0.9 * options_.tolerance_pt);
    goes_on_ = true;
    if (goes_on) {
        DrawnPath& path = drawing_.paths.back();
        path.pieces.insert(path.pieces.end(), pieces.begin(), pieces.end());
        return;
    }
    drawing_.paths.push_back({.kind = task_.kind,
                              .surface = task_.surface,
                              .level = task_.level,
                              .hidden = hidden,
                              .closed = run.curve.closed,
                              .pieces = std::move(pieces)});
}

}  // namespace

LineDrawing draw_scene(const DrawnScene& input, const DrawOptions& options,
                       const TimeLimit& limit) {
    const Page page(input.camera, input.page);
    const HiddenPoints hidden(input.scene, page, limit);
    const std::vector<CurveTask> tasks = curve_tasks(input, options);
    std::vector<LineDrawing> parts(tasks.size());
    parallel_for(tasks.size(), 0, [&](std::size_t i) {
        TaskDrawer drawer(tasks[i], options, page, hidden);
        parts[i] = drawer.run(limit);
    });
    LineDrawing drawing{.size = input.page};
    for (LineDrawing& part : parts) {
        drawing.report += part.report;
        std::ranges::move(part.paths, std::back_inserter(drawing.paths));
    }
    return drawing;
}

}  // namespace zeroset
