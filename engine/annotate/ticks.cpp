#include "engine/annotate/ticks.hpp"

#include "engine/base/translation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

namespace zeroset {
namespace {

const char* const minus_sign = "\xE2\x88\x92";

/// Width of a letter, or of one that begins with this byte.
double width_em(char letter) {
    switch (letter) {
        case '.':
        case ' ': return 0.318;
        case '-': return 0.361;
        case '/': return 0.337;
        case 'm':
        case 'w':
        case 'M':
        case 'W': return 0.989;
        default: break;
    }
    if (letter == '+' || letter == minus_sign[0]) return 0.838;
    return letter >= 'A' && letter <= 'Z' ? 0.787 : 0.636;
}

}  // namespace

double tick_step(double length) {
    const double power = std::pow(10.0, std::floor(std::log10(length)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= length * (1.0 - 1e-9)) return factor * power;
    }
    return 10.0 * power;
}

std::string tick_text(double value, double step) {
    constexpr double most = 1e6;
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    const double size = std::abs(value);
    std::array<char, 64> digits{};
    if (size < 0.5 * step) return "0";
    if (size >= most || (decimals > 5 && size < 1e-3)) {
        const int more = static_cast<int>(std::floor(std::log10(size) + 1e-9)) -
                         static_cast<int>(std::floor(std::log10(step) + 1e-9));
        std::snprintf(digits.data(), digits.size(), "%.*e", std::clamp(more, 0, 16), size);
    } else {
        std::snprintf(digits.data(), digits.size(), "%.*f", std::min(decimals, 17), size);
    }
    return (value < 0 ? minus_sign : "") + std::string(digits.data());
}

double TickStep::length() const { return num / den * (of_pi ? std::numbers::pi : 1.0); }

TickStep tick_step_of(double length, bool of_pi) {
    constexpr double finest = 1.0 / 12.0;
    const double in_pi = length / std::numbers::pi;
    if (!of_pi || in_pi < 0.25 * finest) return {.num = tick_step(length)};
    for (const double den : {12.0, 6.0, 4.0, 2.0}) {
        if (1.0 / den >= in_pi * (1.0 - 1e-9)) return {.num = 1.0, .den = den, .of_pi = true};
    }
    return {.num = std::max(tick_step(in_pi), 1.0), .of_pi = true};
}

std::string tick_label(double k, const TickStep& step) {
    if (!step.of_pi || k == 0.0) return localized(tick_text(k * step.num, step.num));
    const auto over = static_cast<long long>(std::abs(k) * step.num);
    const auto under = static_cast<long long>(step.den);
    const long long common = std::gcd(over, under);
    std::string text = k < 0 ? minus_sign : "";
    if (over != common) text += std::to_string(over / common);
    text += "\u03C0";
    if (under != common) text += "/" + std::to_string(under / common);
    return text;
}

double label_width_em(const std::string& text) {
    double width = 0.0;
    for (const char letter : text) {
        const bool continues = (static_cast<unsigned char>(letter) & 0xC0U) == 0x80U;
        if (!continues) width += width_em(letter);
    }
    return width;
}

}  // namespace zeroset
