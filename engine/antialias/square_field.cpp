#include "engine/antialias/square_field.hpp"

#include "engine/antialias/cover_rules.hpp"
#include "engine/antialias/square_depths.hpp"

namespace zeroset {

auto SquareField::kept_scratch() -> Scratch& {
    thread_local Scratch scratch;
    return scratch;
}

void SquareField::Scratch::clear() {
    squares.clear();
    next_squares.clear();
    ray_squares.clear();
    fronts.clear();
    next_fronts.clear();
    ray_fronts.clear();
    rests.clear();
    reopened.clear();
}

void SquareField::place_hits(std::size_t first, std::size_t count, SquareDepths& depths) {
    for (std::size_t i = 0; i < count; ++i)
        depths.hit[i] = static_cast<double>(in_.squares[first + i].whole->hit);
    find_hits(rays_, count, depths);
    for (std::size_t i = 0; i < count; ++i)
        in_.squares[first + i].hit = depths.hit[i];
}

void SquareField::place_all() {
    const auto depths = [&](std::size_t first, std::size_t count) -> const SquareDepths& {
        thread_local SquareDepths kept;
        for (std::size_t i = 0; i < count; ++i) {
            const CoverSquare& square = in_.squares[first + i];
            kept.u[i] = rays_.u(col_of(square, square_middle));
            kept.v[i] = rays_.v(row_of(square, square_middle));
        }
        find_depths(rays_, 0.5 * in_.squares[first].side * rays_.pixel(), count, kept);
        if (in_.squares[first].whole != nullptr) place_hits(first, count, kept);
        return kept;
    };
    for (std::size_t first = 0; first < in_.squares.size(); first += SquareDepths::capacity) {
        const std::size_t count = std::min(SquareDepths::capacity, in_.squares.size() - first);
        const SquareDepths& of_squares = depths(first, count);
        for (std::size_t i = 0; i < count; ++i) {
            for (Front& front : fronts(first + i)) {
                if (!front.placed) place(in_.squares[first + i], of_squares.range(i), front);
            }
        }
    }
}

void SquareField::place(const CoverSquare& square, const DepthRange& depths, Front& front) const {
    front.placed = true;
    front.at = std::max(front.at, depths.enter_lo);
    front.end = std::min(front.end, depths.exit_hi);
    front.inside_from = depths.enter_hi;
    front.inside_to = depths.exit_lo;
    if (square.whole != nullptr) {
        // The first cell goes behind the hit of the pixel's own ray, if there is one.
        const double fair = width_of(1.0, front.at);
        // A little more, so that roots end before the last cell.
        front.end = std::min(front.end, static_cast<double>(square.whole->to) + 2.0 * fair);
        front.step = square.hit < front.end ? std::max(2.0 * (square.hit - front.at), fair)
                                            : first_widths * fair;
    }
    begin_part(square, front);
}

void SquareField::begin_part(const CoverSquare& square, Front& front) const {
    front.step = std::max(front.step, fair_length(square, front.at));
    // Cells of rays have no width: long ones tell as much.
    if (square.is_ray()) front.step = std::max(front.step, 0.25 * (front.end - front.at));
    if (!(front.at < front.end)) front.state = Front::State::Gone;
}

void SquareField::add(MixedPixel& pixel) {
    in_.squares.push_back(
        {.pixel = pixel.pixel, .least_level = pixel.least_level, .whole = &pixel});
    for (std::size_t i = 0; i < surfaces_; ++i) {
        Front& front = in_.fronts.emplace_back();
        front.at = static_cast<double>(pixel.from);
        front.calm = pixel.is_calm;
    }
}

void SquareField::divide(std::size_t square) {
    if (in_.squares[square].rest != nullptr) return divide_rest(square, *in_.squares[square].rest);
    for (const SquareRay& middle : std::span(square_rays).subspan(1))
        add_part(square, in_.squares[square].quarter(middle));
}

void SquareField::divide_into_rays(std::size_t square) {
    for (const SquareRay& ray : square_rays)
        add_part(square, in_.squares[square].ray(ray, 1.0 / square_ray_count));
}

void SquareField::add_part(std::size_t square, const CoverSquare& part) {
    std::vector<Front>& of_part = part.is_ray() ? in_.ray_fronts : in_.next_fronts;
    const std::size_t first = of_part.size();
    bool any = false;
    for (const Front& of_whole : fronts(square)) {
        Front& front = of_part.emplace_back();
        front.at = of_whole.at;
        front.end = of_whole.end;
        front.step = of_whole.state == Front::State::Going ? of_whole.step
                                                           : 1.1 * (of_whole.to - of_whole.at);
        if (of_whole.state == Front::State::Gone) front.state = Front::State::Gone;
        const bool goes = of_whole.state == Front::State::Going;
        front.placed = !goes && of_whole.is_inside(of_whole.at, of_whole.to);
        if (front.placed) {
            front.inside_from = of_whole.inside_from;
            front.inside_to = of_whole.inside_to;
            begin_part(part, front);
        }
        any = any || front.state != Front::State::Gone;
    }
    if (any) {
        (part.is_ray() ? in_.ray_squares : in_.next_squares).push_back(part);
    } else {
        of_part.resize(first);
    }
}

void SquareField::keep_rest(std::size_t square, std::size_t surface, const SquareRest& rest) {
    if (!(rest.share > least_share)) return;
    fronts(square)[surface].pass();
    // There is often nothing behind an edge: long cells tell so at once.
    for (Front& front : fronts(square))
        front.step = std::max(front.step, 0.25 * (front.end - front.at));
    in_.squares[square].rest = &in_.rests.emplace_back(rest);
    in_.reopened.push_back(square);
}

void SquareField::divide_whole_rest(std::size_t square, const SquareRest& rest) {
    if (rest.share > least_share) divide_rest(square, rest);
}

void SquareField::reopen(std::vector<std::size_t>& open) {
    open.insert(open.end(), in_.reopened.begin(), in_.reopened.end());
    in_.reopened.clear();
}

void SquareField::divide_rest(std::size_t square, const SquareRest& rest) {
    const CoverSquare& at = in_.squares[square];
    const auto count = static_cast<double>(std::ranges::count(rest.misses, true));
    // Where the rest is large, or not known, several rays stand for it.
    const bool is_large = at.level == 0 || (at.level == 1 && rest.share > 0.5);
    const bool several = count > 0.0 && (is_large || !(rest.part.share > 0.0));
    if (!several) return add_part(square, at.ray(rest.middle(), rest.share));
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        if (rest.misses[i]) add_part(square, at.ray(square_rays[i], rest.share / count));
    }
}

bool SquareField::go_down() {
    in_.squares.swap(in_.next_squares);
    in_.fronts.swap(in_.next_fronts);
    in_.next_squares.clear();
    in_.next_fronts.clear();
    in_.rests.clear();
    if (in_.squares.empty()) {
        in_.squares.swap(in_.ray_squares);
        in_.fronts.swap(in_.ray_fronts);
    }
    place_all();
    return !in_.squares.empty();
}

}  // namespace zeroset
