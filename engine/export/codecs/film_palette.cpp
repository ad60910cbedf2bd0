#include "engine/export/codecs/film_palette.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace zeroset {
namespace {

using Color = std::array<double, 3>;

/// Rounds of k-means; more change little.
constexpr int rounds = 6;

/// Weight of a difference in each channel, about as the eye sees it.
constexpr Color color_weights{0.5, 1.0, 0.35};

double distance(const Color& a, const Color& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += color_weights[i] * (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

bool is_transparent(const VideoFrame& frame, std::uint32_t pixel) {
    return frame.alpha && channel_of(pixel, 3) < 128;
}

/// A colour and how often it occurs.
struct Counted {
    Color color;
    double count;
};

/// Colours that share a place in the palette.
struct ColorBox {
    std::span<Counted> colors;
    Color mean{};
    double error = 0.0;    ///< weighted sum of squares about the mean
    std::size_t axis = 0;  ///< along which it is largest

    explicit ColorBox(std::span<Counted> in) : colors(in) {
        double count = 0.0;
        for (const Counted& c : colors) {
            count += c.count;
            for (std::size_t i = 0; i < 3; ++i)
                mean[i] += c.count * c.color[i];
        }
        for (double& channel : mean)
            channel /= count;
        Color squares{};
        for (const Counted& c : colors) {
            for (std::size_t i = 0; i < 3; ++i)
                squares[i] +=
                    color_weights[i] * c.count * (c.color[i] - mean[i]) * (c.color[i] - mean[i]);
        }
        axis = static_cast<std::size_t>(std::ranges::max_element(squares) - squares.begin());
        error = squares[0] + squares[1] + squares[2];
    }
};

/// Halves a box at its mean along its longest axis.
std::pair<ColorBox, ColorBox> halves(const ColorBox& box) {
    const auto below = [&](const Counted& c) { return c.color[box.axis] < box.mean[box.axis]; };
    const auto upper = std::ranges::partition(box.colors, below);
    const auto count = static_cast<std::size_t>(upper.begin() - box.colors.begin());
    return {ColorBox(box.colors.first(count)), ColorBox(box.colors.subspan(count))};
}

std::size_t nearest_of(std::span<const Color> palette, const Color& color) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < palette.size(); ++i) {
        const double d = distance(palette[i], color);
        if (d < least) {
            least = d;
            best = i;
        }
    }
    return best;
}

/// Moves each colour to the mean of what it is nearest to.
void improve(std::vector<Color>& palette, std::span<const Counted> colors) {
    std::vector<Counted> sums(palette.size(), Counted{});
    for (const Counted& c : colors) {
        Counted& sum = sums[nearest_of(palette, c.color)];
        sum.count += c.count;
        for (std::size_t i = 0; i < 3; ++i)
            sum.color[i] += c.count * c.color[i];
    }
    for (std::size_t k = 0; k < palette.size(); ++k) {
        for (std::size_t i = 0; i < 3 && sums[k].count > 0; ++i)
            palette[k][i] = sums[k].color[i] / sums[k].count;
    }
}

Color color_of(std::uint32_t rgb) {
    return {static_cast<double>(rgb >> 16U & 0xFFU), static_cast<double>(rgb >> 8U & 0xFFU),
            static_cast<double>(rgb & 0xFFU)};
}

/// The nearest colours of a palette, remembered for colours of 6 bits a channel.
class NearestColors {
public:
    explicit NearestColors(const FilmPalette& palette) : known_(std::size_t{1} << 18U, unknown) {
        for (const std::uint32_t rgb : palette)
            colors_.push_back(color_of(rgb));
    }
    std::size_t operator()(const Color& color) {
        std::size_t key = 0;
        Color middle;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto step = static_cast<std::size_t>(std::clamp(color[i], 0.0, 255.0)) >> 2U;
            key = key << 6U | step;
            middle[i] = 4.0 * static_cast<double>(step) + 1.5;
        }
        std::int16_t& known = known_[key];
        if (known == unknown) known = static_cast<std::int16_t>(nearest_of(colors_, middle));
        return static_cast<std::size_t>(known);
    }
    [[nodiscard]] const Color& color(std::size_t i) const { return colors_[i]; }

private:
    static constexpr std::int16_t unknown = -1;
    std::vector<Color> colors_;
    std::vector<std::int16_t> known_;
};

/// Adds a part of an error to the errors of a row, if the column is in it.
void pass_on(std::vector<Color>& errors, int col, const Color& error, double part) {
    if (col < 0 || col >= static_cast<int>(errors.size())) return;
    for (std::size_t i = 0; i < 3; ++i)
        errors[static_cast<std::size_t>(col)][i] += part * error[i];
}

}  // namespace

void ColorCounts::add(const VideoFrame& frame) {
    for (const std::uint32_t pixel : frame.pixels) {
        if (is_transparent(frame, pixel)) continue;
        std::size_t place = 0;
        for (unsigned channel = 0; channel < 3; ++channel)
            place = place << 5U | channel_of(pixel, channel) >> 3U;
        Cell& cell = cells_[place];
        cell.count += 1.0;
        for (unsigned channel = 0; channel < 3; ++channel)
            cell.sum[channel] += channel_of(pixel, channel);
    }
}

FilmPalette ColorCounts::palette(std::size_t colors) const {
    std::vector<Counted> counted;
    for (const Cell& cell : cells_) {
        if (cell.count == 0.0) continue;
        // Rare colours count for more than their number: highlights are small, and seen.
        counted.push_back({.color = {cell.sum[0] / cell.count, cell.sum[1] / cell.count,
                                     cell.sum[2] / cell.count},
                           .count = std::sqrt(cell.count)});
    }
    if (counted.empty()) return {0};
    std::vector<Counted> sorted = counted;
    std::vector<ColorBox> boxes{ColorBox(sorted)};
    while (boxes.size() < colors) {
        const auto worst = std::ranges::max_element(boxes, {}, &ColorBox::error);
        if (!(worst->error > 0)) break;
        auto [lower, upper] = halves(*worst);
        *worst = lower;
        boxes.push_back(upper);
    }
    std::vector<Color> palette;
    palette.reserve(boxes.size());
    for (const ColorBox& box : boxes)
        palette.push_back(box.mean);
    for (int i = 0; i < rounds; ++i)
        improve(palette, counted);
    FilmPalette result;
    result.reserve(palette.size());
    for (const Color& color : palette) {
        std::uint32_t rgb = 0;
        for (const double channel : color)
            rgb = rgb << 8U | static_cast<std::uint32_t>(std::lround(channel));
        result.push_back(rgb);
    }
    return result;
}

std::vector<std::uint8_t> dithered(const VideoFrame& frame, const FilmPalette& palette,
                                   std::uint8_t transparent) {
    NearestColors nearest(palette);
    const auto width = static_cast<std::size_t>(frame.width);
    std::vector<std::uint8_t> numbers(width * static_cast<std::size_t>(frame.height), transparent);
    std::vector<Color> errors(width);
    for (int row = 0; row < frame.height; ++row) {
        std::vector<Color> below(width);
        const int step = row % 2 == 0 ? 1 : -1;
        for (int i = 0; i < frame.width; ++i) {
            const int col = step > 0 ? i : frame.width - 1 - i;
            const std::uint32_t pixel = frame.row(row)[col];
            if (is_transparent(frame, pixel)) continue;
            Color wanted{};
            for (unsigned k = 0; k < 3; ++k)
                wanted[k] = channel_of(pixel, k) + errors[static_cast<std::size_t>(col)][k];
            const std::size_t number = nearest(wanted);
            numbers[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(col)] =
                static_cast<std::uint8_t>(number);
            Color error{};
            for (std::size_t k = 0; k < 3; ++k)
                error[k] = wanted[k] - nearest.color(number)[k];
            pass_on(errors, col + step, error, 7.0 / 16.0);
            pass_on(below, col - step, error, 3.0 / 16.0);
            pass_on(below, col, error, 5.0 / 16.0);
            pass_on(below, col + step, error, 1.0 / 16.0);
        }
        errors = std::move(below);
    }
    return numbers;
}

}  // namespace zeroset
