#include "papers/compare/plot.hpp"

#include "engine/annotate/label_font.hpp"
#include "engine/annotate/paint_shapes.hpp"
#include "engine/annotate/shapes_svg.hpp"
#include "engine/export/file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace zeroset {
namespace {

constexpr std::uint32_t rgb(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
    return red | green << 8U | blue << 16U | 0xff000000U;
}
constexpr std::uint32_t ground = rgb(255, 255, 255);
constexpr std::uint32_t ink = rgb(34, 38, 46);
constexpr std::uint32_t soft_ink = rgb(104, 110, 122);
constexpr std::uint32_t grid = rgb(226, 229, 234);
constexpr std::uint32_t here = rgb(31, 101, 176);
constexpr std::uint32_t beams = rgb(217, 95, 14);
constexpr std::uint32_t printed_color = rgb(128, 134, 146);
constexpr std::uint32_t wrong = rgb(190, 30, 45);

constexpr double canvas_width = 920.0;
constexpr double axis_left = 172.0, axis_right = 800.0;
constexpr double row_height = 17.0, group_gap = 10.0, group_title = 20.0;
constexpr double top = 92.0;
constexpr double em = 11.0, small_em = 10.0;
constexpr double dot = 4.2;

/// A time in milliseconds, in three digits and the unit that suits it.
std::string time_text(double ms) {
    std::array<char, 40> text{};
    if (ms < 1000.0) {
        std::snprintf(text.data(), text.size(), "%.3g ms", ms);
    } else {
        std::snprintf(text.data(), text.size(), ms < 1e6 ? "%.3g s" : "%.0f s", 1e-3 * ms);
    }
    return text.data();
}

std::string ratio_text(double times) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.2g", times);
    return std::string("\u00d7") +
           (times < 99.5 ? text.data() : std::to_string(std::lround(times)));
}

class PlotMaker {
public:
    PlotMaker(const Comparison& comparison, const std::vector<ComparedRow>& rows,
              const TextWidth& width)
        : comparison_(comparison), rows_(rows), width_(width) {
        double least = rows.front().median_ms;
        double most = least;
        for (const ComparedRow& row : rows) {
            least = std::min({least, row.median_ms, row.printed_ms.value_or(least)});
            most = std::max({most, row.median_ms, row.printed_ms.value_or(most)});
            has_depths_ |= row.wanted_d_stop != rows.front().wanted_d_stop;
            has_mirrors_ |= row.reflections != rows.front().reflections;
        }
        first_decade_ = static_cast<int>(std::floor(std::log10(least)));
        last_decade_ = std::max(first_decade_ + 1, static_cast<int>(std::ceil(std::log10(most))));
    }

    ComparisonPlot run() {
        double y = top;
        const ComparedRow* before = nullptr;
        for (const ComparedRow& row : rows_) {
            if (before == nullptr || !row.same_case(*before)) {
                y += before == nullptr ? 0.0 : group_gap;
                write(title_of(row), {16.0, y}, Anchor::TopLeft, 12.0, ink);
                y += group_title;
            }
            add_row(row, y + 0.5 * row_height);
            y += row_height;
            before = &row;
        }
        Shapes all;
        std::swap(all, shapes_);
        add_axis(y + 6.0);
        append(shapes_, std::move(all));
        add_heading();
        return {.shapes = std::move(shapes_), .size = {canvas_width, y + 44.0}};
    }

private:
    [[nodiscard]] double place(double ms) const {
        return axis_left + (std::log10(ms) - first_decade_) / (last_decade_ - first_decade_) *
                               (axis_right - axis_left);
    }
    [[nodiscard]] std::string title_of(const ComparedRow& row) const {
        std::string title = row.surface;
        if (has_depths_) title += ", d_stop " + std::to_string(row.wanted_d_stop);
        if (has_mirrors_)
            title += row.reflections == 0
                         ? ", ray casting"
                         : ", " + std::to_string(row.reflections) + " levels of reflections";
        return title;
    }
    void write(const std::string& words, const glm::dvec2& at, Anchor anchor, double size,
               std::uint32_t color) {
        shapes_.emplace_back(
            Text{.words = words, .at = at, .anchor = anchor, .em = size, .color = color});
    }
    [[nodiscard]] bool counts_voxels() const {
        return comparison_.table->unit == PrintedUnit::MillionsPerSecond;
    }
    [[nodiscard]] const char* lost_words_for(std::size_t lost) const {
        if (counts_voxels()) return lost == 1 ? " wrong voxel" : " wrong voxels";
        return lost == 1 ? " pixel wrong" : " pixels wrong";
    }
    /// A text whose digits' middle is at a height; returns its right end.
    double write_at(const std::string& words, double x, double y, std::uint32_t color) {
        write(words, {x, y - digits_middle_em * small_em}, Anchor::TopLeft, small_em, color);
        return x + width_(words, small_em);
    }
    void add_row(const ComparedRow& row, double y);
    void add_axis(double bottom);
    void add_heading();

    const Comparison& comparison_;
    const std::vector<ComparedRow>& rows_;
    const TextWidth& width_;
    int first_decade_ = 0, last_decade_ = 1;
    bool has_depths_ = false, has_mirrors_ = false;
    Shapes shapes_;
};

void PlotMaker::add_row(const ComparedRow& row, double y) {
    const bool is_beams = row.tracer == "beams";
    const std::uint32_t color = is_beams ? beams : here;
    write(row.tracer, {axis_left - 10.0, y - digits_middle_em * em}, Anchor::TopRight, em,
          is_beams ? beams : ink);
    const double at = place(row.median_ms);
    std::string words = time_text(row.median_ms);
    if (row.times) words += "  " + ratio_text(*row.times);
    const double gap = dot + 5.0;
    const std::size_t lost = row.wrong.missed + row.wrong.added;
    const std::string lost_words = lost == 0 ? "" : std::to_string(lost) + lost_words_for(lost);
    constexpr double lost_gap = 8.0;
    double end = at + gap + width_(words, small_em);
    if (lost > 0) end += lost_gap + width_(lost_words, small_em);
    if (row.printed_ms) {
        const double ring = place(*row.printed_ms);
        shapes_.emplace_back(Line{.from = {std::min(at, ring) + dot, y},
                                  .to = {std::max(at, ring) - dot, y},
                                  .width = 1.0,
                                  .color = grid});
        shapes_.emplace_back(
            Circle{.middle = {ring, y}, .radius = dot - 0.6, .color = printed_color, .line = 1.4});
        std::string figure = time_text(*row.printed_ms);
        if (row.printed_times) figure += "  " + ratio_text(*row.printed_times);
        write_at(figure, ring + gap, y, soft_ink);
    }
    shapes_.emplace_back(Circle{.middle = {at, y}, .radius = dot, .color = color});
    // The words lie over the line to the ring.
    shapes_.emplace_back(RoundedRectangle{.lo = {at + gap - 2.0, y - 0.5 * row_height + 1.0},
                                          .hi = {end + 2.0, y + 0.5 * row_height - 1.0},
                                          .color = ground});
    end = write_at(words, at + gap, y, color);
    if (lost > 0) write_at(lost_words, end + lost_gap, y, wrong);
}

void PlotMaker::add_axis(double bottom) {
    for (int decade = first_decade_; decade <= last_decade_; ++decade) {
        const double x = place(std::pow(10.0, decade));
        shapes_.emplace_back(
            Line{.from = {x, top - 4.0}, .to = {x, bottom}, .width = 1.0, .color = grid});
        const std::string words = time_text(std::pow(10.0, decade));
        write(words, {x, bottom + 6.0}, Anchor::TopMiddle, em, soft_ink);
        write(words, {x, top - 20.0}, Anchor::TopMiddle, em, soft_ink);
    }
}

void PlotMaker::add_heading() {
    const PrintedTable& table = *comparison_.table;
    const char* const what =
        counts_voxels() ? ": time of a million intersections" : ": time of a frame";
    write(std::string(table.source) + what, {16.0, 12.0}, Anchor::TopLeft, 15.0, ink);
    const double y = 48.0;
    double x = 20.0;
    shapes_.emplace_back(Circle{.middle = {x, y}, .radius = dot, .color = here});
    x = write_at("here, " + std::to_string(comparison_.width) + " x " +
                     std::to_string(comparison_.height) + " pixels, " +
                     std::to_string(comparison_.threads) +
                     (comparison_.threads == 1 ? " thread" : " threads"),
                 x + 10.0, y, ink);
    shapes_.emplace_back(Circle{.middle = {x + 24.0, y}, .radius = dot, .color = beams});
    x = write_at("beams", x + 34.0, y, ink);
    shapes_.emplace_back(
        Circle{.middle = {x + 24.0, y}, .radius = dot - 0.6, .color = printed_color, .line = 1.4});
    x = write_at("as printed (" + std::string(table.machine) + ")", x + 34.0, y, ink);
    write_at("\u00d7  times the paper's first method", x + 20.0, y, ink);
}

}  // namespace

ComparisonPlot comparison_plot(const Comparison& comparison, const std::vector<ComparedRow>& rows,
                               const TextWidth& width) {
    return PlotMaker(comparison, rows, width).run();
}

std::optional<PlotFormat> plot_format(const std::string& path) {
    if (path.size() > 4 && path.ends_with(".svg")) return PlotFormat::Svg;
    if (path.size() > 4 && path.ends_with(".png")) return PlotFormat::Png;
    return std::nullopt;
}

std::expected<void, std::string> write_plot(const std::string& path, PlotFormat format,
                                            const Comparison& comparison,
                                            const std::vector<ComparedRow>& rows) {
    const auto font = LabelFont::load();
    if (!font) return std::unexpected(font.error());
    const auto width = [&](std::string_view words, double size) {
        return font->width(words, size);
    };
    const ComparisonPlot plot = comparison_plot(comparison, rows, width);
    std::expected<void, FileError> written;
    if (format == PlotFormat::Svg) {
        written = write_text(path, svg_of(plot.shapes, plot.size, ground));
    } else {
        Framebuffer picture(static_cast<int>(plot.size.x), static_cast<int>(plot.size.y));
        std::ranges::fill(picture.color, ground);
        paint_shapes(picture, plot.shapes, *font);
        written = write_png(path, picture);
    }
    if (!written) return std::unexpected(written.error().message);
    return {};
}

}  // namespace zeroset
