#include "app/cli/terminal_picture.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace zeroset {
namespace {

constexpr std::uint32_t nothing = 0;

std::uint32_t pixel(const RgbaImage& image, int x, int y) {
    if (y >= image.height) return nothing;
    const std::uint32_t color =
        image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                     static_cast<std::size_t>(x)];
    return color >> 24U == 0 ? nothing : color;
}

/// The sequence that sets a colour: `part` 38 of the letters, 48 of what is behind them.
std::string color_code(int part, std::uint32_t color) {
    if (color == nothing) return "\x1b[" + std::to_string(part + 1) + "m";
    std::string code = "\x1b[" + std::to_string(part) + ";2";
    for (unsigned channel = 0; channel < 3; ++channel)
        code += ";" + std::to_string(color >> (8 * channel) & 0xFFU);
    return code + "m";
}

}  // namespace

bool has_true_color() {
    const char* const value = std::getenv("COLORTERM");
    if (value == nullptr) return false;
    const std::string_view term(value);
    return term == "truecolor" || term == "24bit";
}

int terminal_lines(const RgbaImage& image) { return (image.height + 1) / 2; }

std::string terminal_picture(const RgbaImage& image) {
    constexpr const char* upper_half = "\xE2\x96\x80";
    constexpr const char* lower_half = "\xE2\x96\x84";
    std::string text;
    for (int y = 0; y < image.height; y += 2) {
        text += "\x1b[K";
        for (int x = 0; x < image.width; ++x) {
            const std::uint32_t upper = pixel(image, x, y);
            const std::uint32_t lower = pixel(image, x, y + 1);
            // Letters have no colour of "nothing", so that the half that is there is the letter.
            const bool flipped = upper == nothing;
            text +=
                color_code(38, flipped ? lower : upper) + color_code(48, flipped ? upper : lower);
            text += upper == lower && flipped ? " " : flipped ? lower_half : upper_half;
        }
        text += "\x1b[0m\n";
    }
    return text;
}

}  // namespace zeroset
