#include "app/cli/options/view_options.hpp"
#include "engine/base/text.hpp"
#include "pipeline/input_error.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

constexpr double largest = 1e9;

OrInputError<Ball> read_ball(const std::string& text) {
    const bool centred = !text.contains(',');
    const auto numbers = read_numbers("--sphere", text, centred ? 1 : 4);
    if (!numbers) return std::unexpected(numbers.error());
    const std::vector<double>& n = *numbers;
    const Ball ball = centred ? Ball{.centre = glm::dvec3(0.0), .radius = n[0]}
                              : Ball{.centre = {n[0], n[1], n[2]}, .radius = n[3]};
    if (!(ball.radius > 0)) return wrong_input("--sphere " + text + ": the radius must be above 0");
    if (std::ranges::any_of(n, [](double x) { return std::abs(x) > largest; }))
        return wrong_input("--sphere " + text + ": stay between -1e9 and 1e9");
    return ball;
}

/// Reads "x<0.3", "x>0.3" or "x=0.3"; `sign` is the index of the sign.
OrInputError<Section> read_axis_section(const std::string& text, std::size_t sign,
                                        const glm::dvec3& eye) {
    const std::string name(trimmed(text.substr(0, sign)));
    const std::size_t axis = std::string("xyz").find(name);
    if (name.size() != 1 || axis == std::string::npos) {
        return wrong_input("--section " + text + ": '" + name +
                           "' is none of x, y and z; type x<0.3, or nx,ny,nz,d for any plane");
    }
    const std::size_t equals = text[sign] != '=' && text[sign + 1] == '=' ? 2 : 1;
    const auto place =
        read_number("--section " + text.substr(0, sign + equals), text.substr(sign + equals));
    if (!place) return std::unexpected(place.error());
    glm::dvec3 normal(0.0);
    const auto i = static_cast<int>(axis);
    const bool keeps_above = text[sign] == '>' || (text[sign] == '=' && eye[i] < *place);
    normal[i] = keeps_above ? -1.0 : 1.0;
    return Section{.normal = normal, .offset = normal[i] * *place};
}

OrInputError<Section> read_section(const std::string& text, const glm::dvec3& eye) {
    const std::size_t sign = text.find_first_of("<>=");
    if (sign != std::string::npos) return read_axis_section(text, sign, eye);
    if (std::ranges::count(text, ',') != 3) {
        return wrong_input("--section " + text +
                           ": type x<0.3, y>0, z=1, or nx,ny,nz,d to keep nx x + ny y + nz z <= d");
    }
    const auto numbers = read_numbers("--section", text, 4);
    if (!numbers) return std::unexpected(numbers.error());
    const std::vector<double>& n = *numbers;
    const glm::dvec3 normal(n[0], n[1], n[2]);
    const double length = glm::length(normal);
    if (!(length > 1e-150 && length < 1e150)) {
        return wrong_input("--section " + text + ": the normal " +
                           (length > 1 ? "is too long" : "must not be 0,0,0"));
    }
    return make_section(normal, n[3]);
}

}  // namespace

OrInputError<Region> read_region(const ViewText& view, const Region& base, const glm::dvec3& eye) {
    Region region = base;
    if (view.sphere) {
        const auto ball = read_ball(*view.sphere);
        if (!ball) return std::unexpected(ball.error());
        region.ball = *ball;
    }
    if (!view.sections.empty()) region.sections.clear();
    for (const std::string& text : view.sections) {
        const auto section = read_section(std::string(trimmed(text)), eye);
        if (!section) return std::unexpected(section.error());
        if (std::abs(section->offset) > largest)
            return wrong_input("--section " + text + ": stay between -1e9 and 1e9");
        region.sections.push_back(*section);
    }
    if (region.sections.size() > max_sections) {
        return wrong_input("--section: at most " + std::to_string(max_sections) + " of them");
    }
    for (Section& section : region.sections)
        section.cap = section.cap && !view.hollow;
    return region;
}

OrInputError<std::optional<glm::dvec3>> read_aspect(const std::string& text) {
    if (trimmed(text) == "auto") return std::nullopt;
    std::string listed = text;
    std::ranges::replace(listed, ':', ',');
    const auto numbers = read_numbers("--aspect", listed, 3);
    if (!numbers) return std::unexpected(numbers.error());
    const glm::dvec3 aspect((*numbers)[0], (*numbers)[1], (*numbers)[2]);
    const bool are_lengths = glm::all(glm::greaterThanEqual(aspect, glm::dvec3(1.0 / largest))) &&
                             glm::all(glm::lessThanEqual(aspect, glm::dvec3(largest)));
    if (!are_lengths) return wrong_input("--aspect " + text + ": type lengths from 1e-9 to 1e9");
    return aspect;
}

OrInputError<Box> read_box(const std::string& option, const std::string& text) {
    const bool cube = !text.contains(',');
    const auto numbers = read_numbers(option, text, cube ? 1 : 6);
    if (!numbers) return std::unexpected(numbers.error());
    const std::vector<double>& n = *numbers;
    const Box box =
        cube ? Box::cube(n[0]) : Box{.lo = {n[0], n[2], n[4]}, .hi = {n[1], n[3], n[5]}};
    for (int i = 0; i < 3; ++i) {
        if (!(box.lo[i] < box.hi[i])) {
            return wrong_input(
                cube ? option + " " + text + ": the half edge must be above 0"
                     : option + " " + text + ": the lower bound " + short_number(box.lo[i]) +
                           " is not below the upper bound " + short_number(box.hi[i]) +
                           "; type x0,x1,y0,y1,z0,z1 with x0 < x1, y0 < y1, z0 < z1");
        }
        if (std::max(std::abs(box.lo[i]), std::abs(box.hi[i])) > largest) {
            return wrong_input(option + " " + text + ": stay between -1e9 and 1e9");
        }
    }
    // Smaller boxes cannot be decided even in double.
    const double reach = std::max(glm::length(box.lo), glm::length(box.hi));
    if (box.size() < 1e-15 * reach || box.size() < 1e-30) {
        return wrong_input(option + " " + text +
                           ": the box is too small for its distance from the origin; " +
                           "its edge must be at least 1e-15 of it");
    }
    return box;
}

}  // namespace zeroset
