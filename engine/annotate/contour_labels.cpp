#include "engine/annotate/contour_labels.hpp"

#include "engine/annotate/ticks.hpp"
#include "engine/kernel/point_batch.hpp"
#include "engine/real/rounding.hpp"
#include "engine/view/pixel_ray.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace zeroset {
namespace {

constexpr std::size_t most_labels = 80;
/// Canvas pixels between points at which numbers are asked for, and how many of those there are
/// along the canvas's height at most.
constexpr double least_cell = 3.0;
constexpr double most_cells = 220.0;
/// Lengths in units of the letters' size.
constexpr double spacing_across_em = 1.3;   ///< from line to line
constexpr double spacing_along_em = 16.0;   ///< between labels of one line
constexpr double margin_em = 0.35;          ///< about a label
constexpr double half_height_em = 0.5;      ///< of a label
constexpr std::uint32_t ink = 0xFF1C1816U;  ///< as dark as lines are
constexpr std::uint32_t halo = 0xE0FFFFFFU;

/// A point of the grid, if a surface is seen there.
struct GridPoint {
    glm::dvec3 at;
    double pixel = 0.0;  ///< how wide a pixel of the canvas is there, world units
    std::uint8_t surface = no_surface;
};

/// A place on a contour line where a label might be.
struct Candidate {
    glm::dvec2 at;
    std::size_t number;  ///< index among the contours
    double multiple;     ///< of the step
    double cost;         ///< the lower, the better to be read
};

/// A label, by its middle and half its size.
struct Placed {
    Candidate candidate;
    glm::dvec2 half;
};

/// The power of ten, at most 1, of which a step is a whole multiple, to some digits.
double last_digit_of(double step) {
    double digit = std::min(1.0, std::pow(10.0, std::floor(std::log10(step) + 1e-9)));
    for (int more = 0; more < 6; ++more, digit /= 10.0) {
        const double count = step / digit;
        if (std::abs(count - std::round(count)) < 1e-6 * count) break;
    }
    return digit;
}

class LabelPlacer {
public:
    LabelPlacer(const ContouredPicture& picture, const CardStyle& style)
        : picture_(picture),
          style_(style),
          cell_(std::max(least_cell, std::ceil(picture.size.y / most_cells))),
          cols_(static_cast<std::size_t>(picture.size.x / cell_)),
          rows_(static_cast<std::size_t>(picture.size.y / cell_)) {
        list_points();
        for (std::size_t number = 0; number < picture.lines.contours.size(); ++number)
            list_candidates(number);
    }
    Shapes place();

private:
    [[nodiscard]] glm::dvec2 place_of(std::size_t col, std::size_t row) const {
        return cell_ * glm::dvec2(static_cast<double>(col) + 0.5, static_cast<double>(row) + 0.5);
    }
    /// Index in the frame of the pixel at a place of the canvas.
    [[nodiscard]] std::size_t pixel_at(const glm::dvec2& at) const;
    void list_points();
    [[nodiscard]] std::vector<double> values_of(const PointNumber& number) const;
    void list_candidates(std::size_t number);
    /// Adds the place where the number is a multiple of the step between two points of the grid.
    void add_crossing(const std::vector<double>& values, std::size_t number, std::size_t col,
                      std::size_t row, bool down);
    [[nodiscard]] bool are_neighbours(const GridPoint& a, const GridPoint& b) const {
        constexpr double steepest = 6.0;
        return a.surface != no_surface && a.surface == b.surface &&
               glm::distance(a.at, b.at) < steepest * cell_ * a.pixel;
    }
    [[nodiscard]] std::string words_of(const Candidate& candidate) const;
    [[nodiscard]] bool fits(const Placed& label) const;

    const ContouredPicture& picture_;
    const CardStyle& style_;
    double cell_;
    std::size_t cols_, rows_;
    std::vector<GridPoint> points_;
    std::vector<Candidate> candidates_;
    std::vector<Placed> placed_;
};

std::size_t LabelPlacer::pixel_at(const glm::dvec2& at) const {
    const Framebuffer& frame = picture_.frame;
    const auto clamped = [](double place, int end) {
        return std::clamp(static_cast<int>(place), 0, end - 1);
    };
    return frame.index(clamped(at.x * frame.width / picture_.size.x, frame.width),
                       clamped(at.y * frame.height / picture_.size.y, frame.height));
}

void LabelPlacer::list_points() {
    const ViewFrame view(picture_.camera);
    const Framebuffer& frame = picture_.frame;
    const ImageSize size{.width = frame.width, .height = frame.height};
    points_.resize(cols_ * rows_);
    for (std::size_t row = 0; row < rows_; ++row) {
        for (std::size_t col = 0; col < cols_; ++col) {
            const std::size_t pixel = pixel_at(place_of(col, row));
            const auto distance = static_cast<double>(frame.depth[pixel]);
            if (!std::isfinite(distance)) continue;
            const auto width = static_cast<std::size_t>(frame.width);
            const PixelRay ray = pixel_ray(
                view,
                pixel_centre(static_cast<int>(pixel % width), static_cast<int>(pixel / width)),
                size);
            GridPoint& point = points_[row * cols_ + col];
            point.at = ray.at(distance);
            point.pixel =
                view.pixel_width(1, glm::dot(point.at - view.eye, view.forward)) / picture_.size.y;
            point.surface = frame.surface[pixel];
        }
    }
}

std::vector<double> LabelPlacer::values_of(const PointNumber& number) const {
    std::vector<double> values(points_.size());
    if (!number.code) {
        for (std::size_t i = 0; i < points_.size(); ++i)
            values[i] = glm::dot(number.along, points_[i].at);
        return values;
    }
    const UpwardRounding upward;
    PointBatch<double> batch(points_.size(), PointBatch<double>::Asks::Value);
    for (std::size_t i = 0; i < points_.size(); ++i)
        batch.set(i, points_[i].at.x, points_[i].at.y, points_[i].at.z);
    batch.pad();
    batch.evaluate(number.code, picture_.uniforms.points<double>(), [] { return false; });
    for (std::size_t i = 0; i < points_.size(); ++i)
        values[i] = batch.f(i);
    return values;
}

void LabelPlacer::list_candidates(std::size_t number) {
    if (points_.empty()) return;
    const std::vector<double> values = values_of(picture_.lines.contours[number]);
    for (std::size_t row = 0; row + 1 < rows_; ++row) {
        for (std::size_t col = 0; col + 1 < cols_; ++col) {
            add_crossing(values, number, col, row, false);
            add_crossing(values, number, col, row, true);
        }
    }
}

void LabelPlacer::add_crossing(const std::vector<double>& values, std::size_t number,
                               std::size_t col, std::size_t row, bool down) {
    const std::size_t here = row * cols_ + col;
    const std::size_t right = here + 1;
    const std::size_t below = here + cols_;
    if (!are_neighbours(points_[here], points_[right]) ||
        !are_neighbours(points_[here], points_[below]))
        return;
    const double step = picture_.lines.step;
    const double a = values[here] / step;
    const double b = values[down ? below : right] / step;
    const double multiple = std::floor(std::max(a, b));
    if (!std::isfinite(a) || !std::isfinite(b) || std::floor(std::min(a, b)) != multiple - 1.0)
        return;
    const glm::dvec2 slope =
        glm::dvec2(values[right] - values[here], values[below] - values[here]) / (cell_ * step);
    const double rate = glm::length(slope);
    if (!(rate * spacing_across_em * style_.em < 1.0)) return;
    const glm::dvec2 at =
        place_of(col, row) +
        (down ? glm::dvec2(0.0, cell_) : glm::dvec2(cell_, 0.0)) * ((multiple - a) / (b - a));
    const double off = glm::distance(at, 0.5 * picture_.size) / picture_.size.y;
    candidates_.push_back(
        {.at = at, .number = number, .multiple = multiple, .cost = std::abs(slope.x) / rate + off});
}

std::string LabelPlacer::words_of(const Candidate& candidate) const {
    const double step = picture_.lines.step;
    std::string number = tick_text(candidate.multiple * step, last_digit_of(step));
    if (picture_.lines.contours.size() < 2) return number;
    const glm::dvec3 along = glm::abs(picture_.lines.contours[candidate.number].along);
    const char* const name = along.x > 0.5 ? "x " : along.y > 0.5 ? "y " : "z ";
    return name + number;
}

bool LabelPlacer::fits(const Placed& label) const {
    const glm::dvec2& at = label.candidate.at;
    const glm::dvec2 space = label.half + margin_em * style_.em;
    const std::uint8_t surface = picture_.frame.surface[pixel_at(at)];
    for (const glm::dvec2 corner : {glm::dvec2(-1, -1), {1, -1}, {-1, 1}, {1, 1}, {0, 0}}) {
        const glm::dvec2 place = at + corner * space;
        const bool inside = place.x >= 0.0 && place.y >= 0.0 && place.x < picture_.size.x &&
                            place.y < picture_.size.y;
        if (!inside || picture_.frame.surface[pixel_at(place)] != surface) return false;
    }
    return std::ranges::none_of(placed_, [&](const Placed& other) {
        const glm::dvec2 off = glm::abs(other.candidate.at - at);
        const bool overlaps = off.x < space.x + other.half.x && off.y < space.y + other.half.y;
        const bool is_same = other.candidate.number == label.candidate.number &&
                             other.candidate.multiple == label.candidate.multiple;
        return overlaps || (is_same && glm::length(off) < spacing_along_em * style_.em);
    });
}

Shapes LabelPlacer::place() {
    std::ranges::stable_sort(candidates_, {}, &Candidate::cost);
    Shapes shapes;
    for (const Candidate& candidate : candidates_) {
        if (placed_.size() == most_labels) break;
        const std::string words = words_of(candidate);
        const Placed label{
            .candidate = candidate,
            .half = {0.5 * style_.width(words, style_.em), half_height_em * style_.em}};
        if (!fits(label)) continue;
        placed_.push_back(label);
        shapes.emplace_back(Text{.words = words,
                                 .at = candidate.at,
                                 .anchor = Anchor::Middle,
                                 .em = style_.em,
                                 .color = ink,
                                 .outline = halo});
    }
    return shapes;
}

}  // namespace

Shapes contour_label_shapes(const ContouredPicture& picture, const CardStyle& style) {
    if (!picture.lines.labels || picture.lines.contours.empty()) return {};
    return LabelPlacer(picture, style).place();
}

}  // namespace zeroset
