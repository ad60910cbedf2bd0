#include "engine/draw/curve_tasks.hpp"

#include "engine/draw/seams.hpp"
#include "engine/draw/shown_points.hpp"
#include "engine/draw/smooth_pieces.hpp"
#include "engine/expr/copy.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/expr/vector_nodes.hpp"
#include "engine/rewrite/differences/derivatives.hpp"
#include "engine/rewrite/polynomial/tighten.hpp"
#include "engine/rewrite/surface_functions.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace zeroset {
namespace {

std::array<double, 3> numbers_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

VectorNodes constant_vector(ExprBuilder& builder, const glm::dvec3& v) {
    return {builder.constant(v.x), builder.constant(v.y), builder.constant(v.z)};
}

/// dot(normal, p) - offset
Expr plane(const glm::dvec3& normal, double offset) {
    ExprBuilder builder;
    const NodeId height = make_dot(builder, constant_vector(builder, normal), make_place(builder));
    return builder.finish(make_subtract(builder, height, builder.constant(offset)));
}

/// |p - centre|^2 - radius^2
Expr sphere(const Ball& ball) {
    ExprBuilder builder;
    const VectorNodes off =
        make_difference(builder, make_place(builder), constant_vector(builder, ball.centre));
    const NodeId radius = make_int_power(builder, builder.constant(ball.radius), 2);
    return builder.finish(make_subtract(builder, make_dot(builder, off, off), radius));
}

Expr constant(double value) {
    ExprBuilder builder;
    return builder.finish(builder.constant(value));
}

Expr difference(const Expr& a, const Expr& b) {
    ExprBuilder builder;
    const NodeId first = copy_nodes(builder, a).back();
    const NodeId second = copy_nodes(builder, b).back();
    return builder.finish(make_subtract(builder, first, second), a.parameter_names());
}

glm::dvec3 axis_vector(int axis) {
    glm::dvec3 vector(0.0);
    vector[axis] = 1.0;
    return vector;
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

/// Makes the tasks of one surface after the other.
class TaskMaker {
public:
    TaskMaker(const DrawnScene& input, const DrawOptions& options, const TimeLimit& limit)
        : input_(input), options_(options), limit_(limit), view_(input.camera) {
        for (std::size_t i = 0; i < input.surfaces.size(); ++i) {
            const auto whole = unrestricted(input.surfaces[i]);
            Surface& surface = surfaces_.emplace_back();
            surface.is_restricted = whole.has_value();
            surface.whole = whole.value_or(input.surfaces[i]);
            surface.zero = function(surface.whole);
            for (const Expr& piece : smooth_pieces(surface.whole))
                surface.pieces.push_back({.surface = i, .f = piece, .zero = function(piece)});
        }
    }

    CurveTasks run();

private:
    using Function = std::shared_ptr<const SpaceFunction>;

    [[nodiscard]] Function function(const Expr& f) const {
        return std::make_shared<const SpaceFunction>(f, input_.scene.uniforms, input_.scene.clip,
                                                     input_.make_kernel);
    }
    /// The function in the form in which it is enclosed most tightly.
    [[nodiscard]] Function tight(const Expr& f) const {
        return function(tightened(f, sample_region_of(input_.scene.clip)));
    }

    /// A part of a surface without edges.
    struct Piece {
        std::size_t surface;
        Expr f;
        Function zero;  ///< f
    };
    struct Surface {
        Expr whole;     ///< without restrictions
        Function zero;  ///< the same
        std::vector<Piece> pieces;
        bool is_restricted = false;
    };

    /// Calls `add_lines` for each piece of a surface while there is time.
    void for_pieces(const Surface& surface, CurveKind kind,
                    void (TaskMaker::*add_lines)(const Piece&));
    /// A task in the clip box and the region.
    CurveTask& add_task(CurveKind kind, std::size_t surface, CurveEquations equations) {
        tasks_.list.push_back({.kind = kind,
                               .surface = surface,
                               .equations = std::move(equations),
                               .box = input_.scene.clip,
                               .region = input_.scene.region});
        return tasks_.list.back();
    }
    CurveTask& add(CurveKind kind, const Piece& piece, CurveEquations equations);
    void require_piece(CurveTask& task, const Piece& piece);
    void add_silhouette(const Piece& piece);
    void add_double_curves(const Piece& piece);
    void add_boundaries(const Piece& piece);
    void add_intersections(const Piece& piece);
    void add_contours(const Piece& piece);
    void add_level(const Piece& piece, const ContourNumber& number, double level);
    void add_in_plane(CurveKind kind, const Piece& piece, int axis, double at);
    void add_edge(std::size_t i, CurveEquations equations, const Expr& border);
    void add_edges(std::size_t i);
    void add_ends(std::size_t i);
    void add_seams(std::size_t i);

    const DrawnScene& input_;
    const DrawOptions& options_;
    const TimeLimit& limit_;
    ViewFrame view_;
    std::vector<Surface> surfaces_;
    CurveTasks tasks_;
};

void TaskMaker::for_pieces(const Surface& surface, CurveKind kind,
                           void (TaskMaker::*add_lines)(const Piece&)) {
    if (!options_.wants(kind)) return;
    for (const Piece& piece : surface.pieces) {
        if (limit_.over()) return;
        (this->*add_lines)(piece);
    }
}

CurveTasks TaskMaker::run() {
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        const Surface& surface = surfaces_[i];
        for_pieces(surface, CurveKind::Silhouette, &TaskMaker::add_silhouette);
        if (options_.wants(CurveKind::Crease) && !limit_.over()) add_edges(i);
        if (options_.wants(CurveKind::Boundary) && !limit_.over()) add_ends(i);
        if (!limit_.over()) add_seams(i);
        for_pieces(surface, CurveKind::Boundary, &TaskMaker::add_boundaries);
        for_pieces(surface, CurveKind::Intersection, &TaskMaker::add_intersections);
        for_pieces(surface, CurveKind::Crease, &TaskMaker::add_double_curves);
        for_pieces(surface, CurveKind::Contour, &TaskMaker::add_contours);
    }
    tasks_.in_time = !limit_.over();
    return std::move(tasks_);
}

/// Keeps of a task's curves what is on the surface, of which the piece is a part.
void TaskMaker::require_piece(CurveTask& task, const Piece& piece) {
    const Scene& scene = input_.scene;
    const Surface& surface = surfaces_[piece.surface];
    const bool is_whole = surface.pieces.size() == 1;
    if (is_whole && !surface.is_restricted) return;
    ShownAt shown = is_whole
                        ? where_defined(scene, piece.surface)
                        : where_piece_counts(scene, piece.surface, piece.f, input_.make_kernel);
    if (!is_whole) task.equations.also.push_back(surface.zero);
    if (!task.is_shown) {
        task.is_shown = std::move(shown);
        return;
    }
    task.is_shown = [first = std::move(task.is_shown), second = std::move(shown)](
                        const CurvePoint& point) { return first(point) && second(point); };
}

CurveTask& TaskMaker::add(CurveKind kind, const Piece& piece, CurveEquations equations) {
    CurveTask& task = add_task(kind, piece.surface, std::move(equations));
    require_piece(task, piece);
    return task;
}

void TaskMaker::add_silhouette(const Piece& piece) {
    const Expr slope = view_.parallel() ? slope_along(piece.f, numbers_of(view_.forward))
                                        : slope_from(piece.f, numbers_of(view_.eye));
    add(CurveKind::Silhouette, piece, {.zero = {piece.zero, tight(slope)}});
}

/// Where the surface meets itself all three derivatives vanish.
void TaskMaker::add_double_curves(const Piece& piece) {
    CurveEquations equations{.zero = {}, .also = {piece.zero}};
    for (const Expr& slope : gradient_of(piece.f))
        equations.zero.push_back(tight(slope));
    CurveTask& task = add_task(CurveKind::Crease, piece.surface, std::move(equations));
    task.is_shown = where_branches_meet(input_.scene, piece.f, input_.make_kernel);
    require_piece(task, piece);
}

void TaskMaker::add_edge(std::size_t i, CurveEquations equations, const Expr& border) {
    const Expr& whole = surfaces_[i].whole;
    equations.also = {surfaces_[i].zero};
    CurveTask& task = add_task(CurveKind::Crease, i, std::move(equations));
    task.is_shown = where_edge(input_.scene, i, whole, border, input_.make_kernel);
}

/// Edges, where two pieces meet; or where the sides of an abs, min or max are equal.
void TaskMaker::add_edges(std::size_t i) {
    const std::vector<Piece>& pieces = surfaces_[i].pieces;
    if (pieces.size() == 1) {
        for (const CreaseBorder& kink : kinks_of(surfaces_[i].whole))
            add_edge(i, {.zero = {function(kink.beside), function(kink.border)}}, kink.border);
    }
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        for (std::size_t m = k + 1; m < pieces.size(); ++m) {
            add_edge(i, {.zero = {pieces[k].zero, pieces[m].zero}},
                     difference(pieces[k].f, pieces[m].f));
        }
    }
}

/// Where the surface's restrictions begin to hold.
void TaskMaker::add_ends(std::size_t i) {
    for (const Expr& border : restriction_borders(input_.surfaces[i])) {
        for (const Piece& piece : surfaces_[i].pieces) {
            CurveTask& task =
                add_task(CurveKind::Boundary, i, {.zero = {piece.zero, function(border)}});
            task.is_shown = where_end(input_.scene, i, border, input_.make_kernel);
        }
    }
}

/// Where the surface's function jumps, or has an edge between branches.
void TaskMaker::add_seams(std::size_t i) {
    const Surface& surface = surfaces_[i];
    const auto values = [&](const Expr& number) {
        return values_about(*function(number), *surface.zero, input_.scene.clip);
    };
    const Seams seams = seams_of(surface.whole, values);
    tasks_.all_seams = tasks_.all_seams && seams.complete;
    for (const Seam& seam : seams.list) {
        const Function border = function(seam.border);
        for (const Expr& beside : seam.beside) {
            const CurveEquations equations{.zero = {function(beside), border},
                                           .also = {surface.zero}};
            if (options_.wants(CurveKind::Crease)) add_edge(i, equations, seam.border);
            if (!options_.wants(CurveKind::Boundary)) continue;
            CurveTask& task = add_task(CurveKind::Boundary, i, equations);
            task.is_shown = where_jump(input_.scene, i, seam.border, input_.make_kernel);
        }
    }
}

void TaskMaker::add_in_plane(CurveKind kind, const Piece& piece, int axis, double at) {
    CurveTask& task =
        add(kind, piece, {.zero = {piece.zero, function(plane(axis_vector(axis), at))}});
    task.box.lo[axis] = task.box.hi[axis] = at;
}

void TaskMaker::add_boundaries(const Piece& piece) {
    const Scene& scene = input_.scene;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double at : {scene.clip.lo[axis], scene.clip.hi[axis]})
            add_in_plane(CurveKind::Boundary, piece, axis, at);
    }
    for (std::size_t k = 0; k < scene.region.sections.size(); ++k) {
        const Section& section = scene.region.sections[k];
        if (!cuts(section, scene.clip)) continue;
        CurveTask& task =
            add(CurveKind::Boundary, piece,
                {.zero = {piece.zero, function(plane(section.normal, section.offset))}});
        task.region.sections.erase(task.region.sections.begin() + static_cast<std::ptrdiff_t>(k));
    }
    if (!scene.region.ball) return;
    CurveTask& task = add(CurveKind::Boundary, piece,
                          {.zero = {piece.zero, function(sphere(*scene.region.ball))}});
    task.region.ball.reset();
}

void TaskMaker::add_intersections(const Piece& piece) {
    for (std::size_t k = piece.surface + 1; k < surfaces_.size(); ++k) {
        for (const Piece& other : surfaces_[k].pieces) {
            CurveTask& task =
                add(CurveKind::Intersection, piece, {.zero = {piece.zero, other.zero}});
            require_piece(task, other);
        }
    }
}

void TaskMaker::add_level(const Piece& piece, const ContourNumber& number, double level) {
    if (number.axis) {
        add_in_plane(CurveKind::Contour, piece, *number.axis, level);
    } else {
        add(CurveKind::Contour, piece,
            {.zero = {piece.zero, function(difference(number.formula, constant(level)))}});
    }
    tasks_.list.back().level = level;
}

void TaskMaker::add_contours(const Piece& piece) {
    constexpr double most_levels = 1000.0;
    const Scene& scene = input_.scene;
    for (const ContourNumber& number : options_.contours) {
        Bounds range{.lo = 0.0, .hi = -1.0};
        if (number.axis) {
            range = {.lo = scene.clip.lo[*number.axis], .hi = scene.clip.hi[*number.axis]};
        } else {
            range = values_about(*function(number.formula), *piece.zero, scene.clip);
        }
        const double first = std::ceil(range.lo / options_.contour_step);
        const double last = std::floor(range.hi / options_.contour_step);
        for (double k = first; k <= std::min(last, first + most_levels); k += 1.0) {
            // A level in a face of the box is its boundary.
            const double level = k * options_.contour_step;
            if (number.axis && !(level > range.lo && level < range.hi)) continue;
            add_level(piece, number, level);
        }
    }
}

}  // namespace

CurveTasks curve_tasks(const DrawnScene& input, const DrawOptions& options,
                       const TimeLimit& limit) {
    return TaskMaker(input, options, limit).run();
}

}  // namespace zeroset
