#include "engine/draw/curve_tasks.hpp"

#include "engine/expr/copy.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/rewrite/differences/derivatives.hpp"
#include "engine/rewrite/unrestricted.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace zeroset {
namespace {

std::array<double, 3> numbers_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

/// dot(normal, p) - offset
Expr plane(const glm::dvec3& normal, double offset) {
    ExprBuilder builder;
    NodeId sum = builder.constant(-offset);
    for (int axis = 0; axis < 3; ++axis) {
        if (normal[axis] == 0.0) continue;
        const NodeId term =
            make_multiply(builder, builder.constant(normal[axis]), builder.variable(axis));
        sum = make_add(builder, term, sum);
    }
    return builder.finish(sum);
}

/// |p - centre|^2 - radius^2
Expr sphere(const Ball& ball) {
    ExprBuilder builder;
    NodeId sum = make_negate(builder, make_int_power(builder, builder.constant(ball.radius), 2));
    for (int axis = 0; axis < 3; ++axis) {
        const NodeId off =
            make_subtract(builder, builder.variable(axis), builder.constant(ball.centre[axis]));
        sum = make_add(builder, make_int_power(builder, off, 2), sum);
    }
    return builder.finish(sum);
}

glm::dvec3 axis_vector(int axis) {
    glm::dvec3 vector(0.0);
    vector[axis] = 1.0;
    return vector;
}

/// Makes the tasks of one surface after the other.
class TaskMaker {
public:
    TaskMaker(const DrawnScene& input, const DrawOptions& options)
        : input_(input), options_(options), view_(input.camera) {
        for (const Expr& f : input.surfaces)
            whole_.push_back(unrestricted(f).value_or(f));
    }

    std::vector<CurveTask> run() {
        for (std::size_t i = 0; i < whole_.size(); ++i) {
            if (options_.wants(CurveKind::Silhouette)) add_silhouette(i);
            if (options_.wants(CurveKind::Crease)) add_double_curves(i);
            if (options_.wants(CurveKind::Boundary)) add_boundaries(i);
            if (options_.wants(CurveKind::Intersection)) add_intersections(i);
            if (options_.wants(CurveKind::Contour)) add_contours(i);
        }
        return std::move(tasks_);
    }

private:
    /// A task in the clip box and the region.
    CurveTask& add(CurveKind kind, std::size_t surface, CurveEquations equations) {
        tasks_.push_back({.kind = kind,
                          .surface = surface,
                          .equations = std::move(equations),
                          .box = input_.scene.clip,
                          .region = input_.scene.region});
        return tasks_.back();
    }
    void add_silhouette(std::size_t i);
    void add_double_curves(std::size_t i);
    void add_boundaries(std::size_t i);
    void add_intersections(std::size_t i);
    void add_contours(std::size_t i);
    void add_level(std::size_t i, const ContourNumber& number, double level);
    void add_in_plane(CurveKind kind, std::size_t i, int axis, double at);

    const DrawnScene& input_;
    const DrawOptions& options_;
    ViewFrame view_;
    std::vector<Expr> whole_;
    std::vector<CurveTask> tasks_;
};

void TaskMaker::add_silhouette(std::size_t i) {
    const Expr slope = view_.parallel() ? slope_along(whole_[i], numbers_of(view_.forward))
                                        : slope_from(whole_[i], numbers_of(view_.eye));
    add(CurveKind::Silhouette, i, {.zero = {whole_[i], slope}});
}

/// Where the surface meets itself all three derivatives vanish.
void TaskMaker::add_double_curves(std::size_t i) {
    const std::array<Expr, 3> gradient = gradient_of(whole_[i]);
    add(CurveKind::Crease, i, {.zero = {gradient.begin(), gradient.end()}, .also = {whole_[i]}});
}

void TaskMaker::add_in_plane(CurveKind kind, std::size_t i, int axis, double at) {
    CurveTask& task = add(kind, i, {.zero = {whole_[i], plane(axis_vector(axis), at)}});
    task.box.lo[axis] = task.box.hi[axis] = at;
}

void TaskMaker::add_boundaries(std::size_t i) {
    const Scene& scene = input_.scene;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double at : {scene.clip.lo[axis], scene.clip.hi[axis]})
            add_in_plane(CurveKind::Boundary, i, axis, at);
    }
    for (std::size_t k = 0; k < scene.region.sections.size(); ++k) {
        const Section& section = scene.region.sections[k];
        if (!cuts(section, scene.clip)) continue;
        CurveTask& task = add(CurveKind::Boundary, i,
                              {.zero = {whole_[i], plane(section.normal, section.offset)}});
        task.region.sections.erase(task.region.sections.begin() + static_cast<std::ptrdiff_t>(k));
    }
    if (!scene.region.ball) return;
    CurveTask& task =
        add(CurveKind::Boundary, i, {.zero = {whole_[i], sphere(*scene.region.ball)}});
    task.region.ball.reset();
}

void TaskMaker::add_intersections(std::size_t i) {
    for (std::size_t k = i + 1; k < whole_.size(); ++k)
        add(CurveKind::Intersection, i, {.zero = {whole_[i], whole_[k]}});
}

/// The values that a number has about a surface in the box.
Bounds values_about(const SpaceFunction& number, const SpaceFunction& surface, const Box& box) {
    constexpr int parts = 16;
    std::vector<Box> cells;
    const glm::dvec3 size = (box.hi - box.lo) / static_cast<double>(parts);
    for (int i = 0; i < parts * parts * parts; ++i) {
        const glm::dvec3 at(i % parts, i / parts % parts, i / (parts * parts));
        cells.push_back({.lo = box.lo + at * size, .hi = box.lo + (at + 1.0) * size});
    }
    std::vector<Bounds> of_number(cells.size());
    std::vector<Bounds> of_surface(cells.size());
    number.enclose(cells, of_number);
    surface.enclose(cells, of_surface);
    Bounds all{.lo = 0.0, .hi = -1.0};
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Bounds& here = of_number[i];
        if (of_surface[i].excludes_zero || !std::isfinite(here.lo) || !std::isfinite(here.hi))
            continue;
        all = all.lo > all.hi
                  ? here
                  : Bounds{.lo = std::min(all.lo, here.lo), .hi = std::max(all.hi, here.hi)};
    }
    return all;
}

void TaskMaker::add_level(std::size_t i, const ContourNumber& number, double level) {
    if (number.axis) {
        add_in_plane(CurveKind::Contour, i, *number.axis, level);
    } else {
        ExprBuilder builder;
        const NodeId value = copy_nodes(builder, number.formula).back();
        const NodeId off = make_subtract(builder, value, builder.constant(level));
        const auto names = number.formula.parameters();
        add(CurveKind::Contour, i,
            {.zero = {whole_[i], builder.finish(off, {names.begin(), names.end()})}});
    }
    tasks_.back().level = level;
}

void TaskMaker::add_contours(std::size_t i) {
    constexpr double most_levels = 1000.0;
    const Scene& scene = input_.scene;
    for (const ContourNumber& number : options_.contours) {
        Bounds range{.lo = 0.0, .hi = -1.0};
        if (number.axis) {
            range = {.lo = scene.clip.lo[*number.axis], .hi = scene.clip.hi[*number.axis]};
        } else {
            range = values_about(SpaceFunction(number.formula, scene.uniforms),
                                 SpaceFunction(whole_[i], scene.uniforms), scene.clip);
        }
        const double first = std::ceil(range.lo / options_.contour_step);
        const double last = std::floor(range.hi / options_.contour_step);
        for (double k = first; k <= std::min(last, first + most_levels); k += 1.0) {
            // A level in a face of the box is its boundary.
            const double level = k * options_.contour_step;
            if (number.axis && !(level > range.lo && level < range.hi)) continue;
            add_level(i, number, level);
        }
    }
}

}  // namespace

std::vector<CurveTask> curve_tasks(const DrawnScene& input, const DrawOptions& options) {
    return TaskMaker(input, options).run();
}

}  // namespace zeroset
