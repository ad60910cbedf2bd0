#include "app/cli/options/light_options.hpp"

#include "app/cli/options/options.hpp"
#include "document/colors.hpp"
#include "engine/base/text.hpp"
#include "engine/image/gamma.hpp"

#include <string_view>

namespace zeroset {
namespace {

constexpr const char* light_help =
    "type X,Y,Z towards the light, or camera X,Y,Z (right, up, back), and after a ; each: power P, "
    "size DEGREES, color #RRGGBB";

std::unexpected<InputError> wrong_light(const std::string& text) {
    return wrong_input("--light " + text + ": " + light_help);
}

/// Takes "power 2" and the like; whether it is one of them.
bool take_part(const std::string& part, Light& light) {
    const auto number = [](const std::string& text, double most) -> std::optional<double> {
        const auto value = read_number("--light", text);
        if (!value || *value < 0.0 || *value > most) return std::nullopt;
        return *value;
    };
    if (const auto power = value_behind(part, "power")) {
        const auto value = number(*power, max_power);
        light.power = value.value_or(0.0);
        return value.has_value();
    }
    if (const auto size = value_behind(part, "size")) {
        const auto value = number(*size, 2.0 * half_sphere_deg);
        light.radius_deg = 0.5 * value.value_or(0.0);
        return value.has_value();
    }
    if (const auto color = value_behind(part, "color")) {
        const auto value = color_from(*color);
        light.color = light_of_color(value.value_or(0));
        return value.has_value();
    }
    return false;
}

}  // namespace

std::string look_words() {
    std::vector<std::string_view> names;
    for (const Look look : looks())
        names.push_back(name_of(look));
    return one_of(names);
}

OrInputError<Light> read_light(const std::string& text) {
    const std::vector<std::string_view> parts = split(text, ';');
    std::string direction(trimmed(parts.front()));
    Light light;
    const auto of_camera = value_behind(direction, "camera");
    light.with_camera = of_camera.has_value();
    if (of_camera) direction = *of_camera;
    const auto numbers = read_numbers("--light", direction, 3);
    if (!numbers) return wrong_light(text);
    light.towards = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
    if (!(glm::length(light.towards) > 0.0)) return wrong_light(text);
    for (std::size_t i = 1; i < parts.size(); ++i) {
        if (!take_part(std::string(trimmed(parts[i])), light)) return wrong_light(text);
    }
    return light;
}

OrInputError<std::optional<Background>> read_background(const std::string& text) {
    if (text == "default") return std::nullopt;
    const std::vector<std::string_view> parts = split(text, ',');
    const auto top = color_from(parts.front());
    const auto bottom = color_from(parts.back());
    if (parts.size() > 2 || !top || !bottom) {
        return wrong_input("--background " + text +
                           ": type #RRGGBB, #RRGGBB,#RRGGBB from top to bottom, or default");
    }
    return Background{.top = *top, .bottom = *bottom};
}

std::optional<InputError> take_light(const LightText& text, LightChoice& light) {
    if (text.look) {
        const auto look = look_named(*text.look);
        if (!look)
            return InputError{.reason = "--look " + *text.look + ": type " + look_words() +
                                        "; --surface-look 2:metal is for one surface"};
        light.look = *look;
    }
    if (text.tone) {
        const auto tone = tone_named(*text.tone);
        if (!tone) return InputError{.reason = "--tone " + *text.tone + ": type plain or filmic"};
        light.tone = *tone;
    }
    if (text.background) {
        const auto background = read_background(*text.background);
        if (!background) return background.error();
        light.background = *background;
    }
    if (text.reflections) {
        const auto count = read_integer("--reflections", *text.reflections, 0, max_reflections);
        if (!count) return count.error();
        light.reflections = *count;
    }
    if (text.absorption) {
        const auto absorption = read_number("--absorption", *text.absorption);
        if (!absorption) return absorption.error();
        if (*absorption < 0.0 || *absorption > max_absorption)
            return InputError{.reason = "--absorption " + *text.absorption +
                                        ": type a number from 0 to 1e6, per unit of length"};
        light.absorption = *absorption;
    }
    if (text.lights.empty()) return std::nullopt;
    if (text.lights.size() > max_lights)
        return InputError{.reason = "--light: there are at most 4 lights"};
    light.lights.clear();
    for (const std::string& typed : text.lights) {
        const auto read = read_light(typed);
        if (!read) return read.error();
        light.lights.push_back(*read);
    }
    return std::nullopt;
}

}  // namespace zeroset
