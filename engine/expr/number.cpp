#include "engine/expr/number.hpp"

#include "engine/real/rounding.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace zeroset {
namespace {

constexpr std::size_t exact_digits = 15;  // every whole number of so many is a double

// strtod rounds correctly in the current mode (glibc, IEEE 754-2008).
double parse_upward(const std::string& digits) {
    const UpwardRounding upward;
    return std::strtod(digits.c_str(), nullptr);
}

double parse_downward(const std::string& digits) {
    const DownwardRounding downward;
    return std::strtod(digits.c_str(), nullptr);
}

std::string shortest(double value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

std::string with_digits(long double value, int digits) {
    std::array<char, 1100> buffer{};
    const int length = std::snprintf(buffer.data(), buffer.size(), "%.*Lg", digits, value);
    return {buffer.data(), static_cast<std::size_t>(length)};
}

}  // namespace

NumberEnclosure enclose_number(std::string_view digits) {
    std::uint64_t whole = 0;
    const char* const end = digits.data() + digits.size();
    const bool is_whole =
        digits.size() <= exact_digits && std::from_chars(digits.data(), end, whole).ptr == end;
    if (is_whole) return {.lo = static_cast<double>(whole), .hi = static_cast<double>(whole)};
    const std::string text(digits);
    return {.lo = parse_downward(text), .hi = parse_upward(text)};
}

std::string number_text(const NumberEnclosure& number) {
    std::string best;
    for (const double candidate : {number.hi, number.lo}) {
        std::string text = shortest(candidate);
        const bool shorter = best.empty() || text.size() < best.size();
        if (shorter && enclose_number(text) == number) best = std::move(text);
    }
    if (!best.empty()) return best;
    const long double middle =
        0.5L * (static_cast<long double>(number.lo) + static_cast<long double>(number.hi));
    for (int digits = 17; digits < 1000; ++digits) {
        std::string text = with_digits(middle, digits);
        if (enclose_number(text) == number) return text;
    }
    return shortest(number.hi);
}

}  // namespace zeroset
