#include "engine/draw/draw_scene.hpp"

#include "engine/base/parallel.hpp"
#include "engine/draw/curve_tasks.hpp"
#include "engine/draw/hidden_points.hpp"
#include "engine/draw/page_curve.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

namespace zeroset {
namespace {

/// Curves that are shorter on the page are left out.
constexpr double least_length_pt = 0.02;

/// Whether a point that a curve was found at is in the region, up to rounding.
bool is_in(const Region& region, const glm::dvec3& point) {
    constexpr double slack = 2e-9;
    double size = glm::length(point);
    if (region.ball) size = std::max(size, size_of(*region.ball));
    for (const Section& section : region.sections)
        size = std::max(size, size_of(section));
    return region.contains(point, slack * size);
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

/// Draws curves of one task.
class CurveDrawer {
public:
    CurveDrawer(const CurveTask& task, const CurveSystem& system, const DrawOptions& options,
                const Page& page, const HiddenPoints& hidden)
        : task_(task), system_(system), options_(options), page_(page), hidden_(hidden) {}

    /// The curve as paths; none if the time is over before they are known.
    std::vector<DrawnPath> run(const SpaceCurve& curve, const TimeLimit& limit) {
        add_curve(refined(system_, curve, page_, limit));
        if (limit.over()) return {};
        return std::move(paths_);
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
    const CurveSystem& system_;
    const DrawOptions& options_;
    const Page& page_;
    const HiddenPoints& hidden_;
    std::vector<DrawnPath> paths_;
    bool goes_on_ = false;  ///< the next run begins where the last path ends
};

int CurveDrawer::touch(const CurvePoint& point) const {
    if (task_.kind != CurveKind::Silhouette) return 0;
    const Linearized there = system_.at(point.place);
    return glm::dot(there.gradients[1], page_.ray_direction(point.place)) > 0.0 ? 1 : 0;
}

void CurveDrawer::add_curve(const SpaceCurve& curve) {
    std::vector<int> shown;
    shown.reserve(curve.points.size());
    for (const CurvePoint& point : curve.points)
        shown.push_back(is_shown(point) ? 1 : 0);
    const auto state = [this](const CurvePoint& point) { return is_shown(point) ? 1 : 0; };
    for (const CurveRun& run : divided(system_, curve, page_, shown, state)) {
        if (run.state == 1) add_shown(run.curve);
    }
}

std::vector<int> CurveDrawer::states_of(const SpaceCurve& curve) const {
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

void CurveDrawer::add_shown(const SpaceCurve& curve) {
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
void CurveDrawer::add_run(const CurveRun& run) {
    const bool hidden = run.state % 2 == 1;
    const bool goes_on = goes_on_ && paths_.back().hidden == hidden;
    goes_on_ = false;
    if (hidden && !options_.hidden) return;
    std::vector<PagePoint> points = page_points(run.curve, page_);
    if (run.curve.closed) points.push_back(points.front());
    if (points.size() < 2 || length_of(points) < least_length_pt) return;
    std::vector<Bezier> pieces = fitted(points, 0.9 * options_.tolerance_pt);
    goes_on_ = true;
    if (goes_on) {
        DrawnPath& path = paths_.back();
        path.pieces.insert(path.pieces.end(), pieces.begin(), pieces.end());
        return;
    }
    paths_.push_back({.kind = task_.kind,
                      .surface = task_.surface,
                      .level = task_.level,
                      .hidden = hidden,
                      .closed = run.curve.closed,
                      .pieces = std::move(pieces)});
}

/// A part of the time that is left, from 0 to 1.
TimeLimit part_of(const TimeLimit& limit, double part) {
    if (limit.until == TimeLimit::never) return limit;
    const auto now = TimeLimit::Clock::now();
    const auto left = std::chrono::duration_cast<TimeLimit::Clock::duration>(
        part * std::chrono::duration<double>(limit.until - now));
    return {.cancel = limit.cancel, .until = now + left};
}

/// Finds the curves of all tasks, then draws them one by one.
class SceneDrawer {
public:
    SceneDrawer(const DrawnScene& input, const DrawOptions& options, const TimeLimit& limit,
                const OnPath& on_path)
        : input_(input),
          options_(options),
          limit_(limit),
          on_path_(on_path),
          page_(input.camera, input.page),
          hidden_(input.scene, page_, limit),
          tasks_(curve_tasks(input, options, part_of(limit, part_to_prepare))) {
        for (const CurveTask& task : tasks_.list)
            systems_.emplace_back(task.equations);
    }

    LineDrawing run();

private:
    /// Parts of the time that is left for each step, and for the finding of one task's curves.
    static constexpr double part_to_prepare = 0.3;
    static constexpr double part_to_find = 0.6;
    static constexpr double part_for_others = 0.3;
    static constexpr double part_for_silhouettes = 0.8;

    /// A curve that is to be drawn.
    struct Item {
        std::size_t task;
        const SpaceCurve* curve;
    };

    void find();
    void find(std::size_t i, const TimeLimit& limit);
    [[nodiscard]] std::vector<const SpaceCurve*> double_lines(std::size_t surface) const;
    void draw(LineDrawing& drawing);
    void report(LineDrawing& drawing) const;
    [[nodiscard]] std::array<bool, 5> possible_kinds() const;

    const DrawnScene& input_;
    const DrawOptions& options_;
    const TimeLimit& limit_;
    const OnPath& on_path_;
    Page page_;
    HiddenPoints hidden_;
    CurveTasks tasks_;
    std::vector<CurveSystem> systems_;
    std::vector<FoundCurves> found_;
};

void SceneDrawer::find() {
    const TimeLimit until = part_of(limit_, part_to_find);
    const auto is_silhouette = [](const CurveTask& task) {
        return task.kind == CurveKind::Silhouette;
    };
    found_.resize(tasks_.list.size());
    // Silhouettes take longest, and are better found where double lines are known.
    for (const bool silhouettes : {false, true}) {
        const double part = silhouettes ? part_for_silhouettes : part_for_others;
        parallel_for(tasks_.list.size(), 0, [&](std::size_t i) {
            if (is_silhouette(tasks_.list[i]) == silhouettes) find(i, part_of(until, part));
        });
    }
}

void SceneDrawer::find(std::size_t i, const TimeLimit& limit) {
    const CurveTask& task = tasks_.list[i];
    const CurveDomain domain{.box = task.box, .region = task.region, .page = page_};
    SearchLimits limits{.smallest_pt = options_.tolerance_pt,
                        .time = limit,
                        .singular_pt = 8.0 * options_.tolerance_pt};
    if (task.kind == CurveKind::Silhouette) limits.singular = double_lines(task.surface);
    found_[i] = find_curves(systems_[i], domain, limits);
}

/// The curves found on which a surface meets itself.
std::vector<const SpaceCurve*> SceneDrawer::double_lines(std::size_t surface) const {
    std::vector<const SpaceCurve*> lines;
    for (std::size_t i = 0; i < found_.size(); ++i) {
        const CurveTask& task = tasks_.list[i];
        if (task.surface != surface || task.equations.zero.size() < 3) continue;
        for (const SpaceCurve& curve : found_[i].curves)
            lines.push_back(&curve);
    }
    return lines;
}

void SceneDrawer::draw(LineDrawing& drawing) {
    std::vector<Item> items;
    for (std::size_t i = 0; i < found_.size(); ++i) {
        for (const SpaceCurve& curve : found_[i].curves)
            items.push_back({.task = i, .curve = &curve});
    }
    std::vector<std::vector<DrawnPath>> parts(items.size());
    const auto is_left_out = std::make_unique<bool[]>(items.size());
    parallel_for(items.size(), 0, [&](std::size_t i) {
        const std::size_t task = items[i].task;
        CurveDrawer drawer(tasks_.list[task], systems_[task], options_, page_, hidden_);
        if (!limit_.over()) parts[i] = drawer.run(*items[i].curve, limit_);
        is_left_out[i] = limit_.over() && parts[i].empty();
        if (on_path_) std::ranges::for_each(parts[i], on_path_);
    });
    for (std::size_t i = 0; i < items.size(); ++i) {
        std::ranges::move(parts[i], std::back_inserter(drawing.paths));
        const auto kind = static_cast<std::size_t>(tasks_.list[items[i].task].kind);
        drawing.cut.at(kind) = drawing.cut.at(kind) || is_left_out[i];
    }
}

void SceneDrawer::report(LineDrawing& drawing) const {
    for (std::size_t i = 0; i < found_.size(); ++i) {
        const auto kind = static_cast<std::size_t>(tasks_.list[i].kind);
        drawing.cut.at(kind) = drawing.cut.at(kind) || !found_[i].report.in_time;
        drawing.report += found_[i].report;
    }
    if (!tasks_.in_time) drawing.cut = possible_kinds();
    drawing.all_seams = tasks_.all_seams;
}

/// The kinds of lines that the scene may have.
std::array<bool, 5> SceneDrawer::possible_kinds() const {
    std::array<bool, 5> kinds = options_.kinds;
    const auto drop = [&](CurveKind kind) { kinds.at(static_cast<std::size_t>(kind)) = false; };
    if (options_.contours.empty()) drop(CurveKind::Contour);
    if (input_.surfaces.size() < 2) drop(CurveKind::Intersection);
    return kinds;
}

LineDrawing SceneDrawer::run() {
    LineDrawing drawing{.size = input_.page, .contour_width_pt = options_.contour_width_pt};
    find();
    draw(drawing);
    report(drawing);
    return drawing;
}

}  // namespace

LineDrawing draw_scene(const DrawnScene& input, const DrawOptions& options, const TimeLimit& limit,
                       const OnPath& on_path) {
    return SceneDrawer(input, options, limit, on_path).run();
}

}  // namespace zeroset
