#include "document/colors.hpp"
#include "document/json/document_fields.hpp"
#include "engine/base/translation.hpp"
#include "engine/image/gamma.hpp"

#include <cstdint>

namespace zeroset {
namespace {

Json json_of(const Light& light) {
    return {{"towards", array_of(light.towards)},
            {"with", light.with_camera ? "camera" : "world"},
            {"color", color_text(color_of_light(light.color))},
            {"power", light.power},
            {"radius_deg", light.radius_deg}};
}

bool is_with_camera(const Json& json, const std::string& place) {
    const std::string text = string_of(json, place);
    if (text != "camera" && text != "world")
        throw Damage{filled(tr("{0} is neither camera nor world"), {place})};
    return text == "camera";
}

Light light_of(const Json& json, const std::string& place, std::vector<std::string>& unknown) {
    Fields fields(json, place, unknown);
    Light light;
    light.towards = vector_of(fields.get("towards"), fields.at("towards"));
    if (glm::length(light.towards) == 0.0)
        throw Damage{filled(tr("{0} is zero"), {fields.at("towards")})};
    if (const Json* with = fields.find("with"))
        light.with_camera = is_with_camera(*with, fields.at("with"));
    if (const Json* color = fields.find("color"))
        light.color = light_of_color(color_of(*color, fields.at("color")));
    if (const Json* power = fields.find("power"))
        light.power = number_in(*power, fields.at("power"), 0.0, max_power);
    if (const Json* radius = fields.find("radius_deg"))
        light.radius_deg = number_in(*radius, fields.at("radius_deg"), 0.0, half_sphere_deg);
    return light;
}

std::vector<Light> lights_of(const Json& json, std::vector<std::string>& unknown) {
    if (!json.is_array()) throw Damage{filled(tr("{0} is no list"), {"light.lights"})};
    if (json.size() > max_lights)
        throw Damage{filled(tr("{0} has more than 4 lights"), {"light.lights"})};
    std::vector<Light> lights;
    for (const Json& item : json) {
        const std::string place = "light.lights[" + std::to_string(lights.size()) + "]";
        lights.push_back(light_of(item, place, unknown));
    }
    return lights;
}

}  // namespace

Background background_of(const Json& json, const std::string& place) {
    if (json.is_string()) {
        const std::uint32_t color = color_of(json, place);
        return {.top = color, .bottom = color};
    }
    if (!json.is_array() || json.size() != 2)
        throw Damage{
            filled(tr("{0} is neither a color such as #3399FF nor a list of two"), {place})};
    return {.top = color_of(json[0], place), .bottom = color_of(json[1], place)};
}

Json json_of(const Background& background) {
    return {color_text(background.top), color_text(background.bottom)};
}

std::uint32_t color_of(const Json& json, const std::string& place) {
    const auto color = color_from(string_of(json, place));
    if (!color) throw Damage{filled(tr("{0} is no color such as #3399FF"), {place})};
    return *color;
}

Look look_in(const Json& json, const std::string& place) {
    const auto look = look_named(string_of(json, place));
    if (!look) throw Damage{filled(tr("{0} is no look"), {place})};
    return *look;
}

Json json_of(const LightChoice& light) {
    Json json{{"look", name_of(light.look)},
              {"reflections", light.reflections},
              {"absorption", light.absorption},
              {"tone", name_of(light.tone)}};
    if (light.background) json["background"] = json_of(*light.background);
    if (light.lights.empty()) return json;
    json["lights"] = Json::array();
    for (const Light& item : light.lights)
        json["lights"].push_back(json_of(item));
    return json;
}

LightChoice light_choice_of(const Json& json, std::vector<std::string>& unknown) {
    Fields fields(json, "light", unknown);
    LightChoice light;
    if (const Json* look = fields.find("look")) light.look = look_in(*look, "light.look");
    if (const Json* tone = fields.find("tone")) {
        const auto named = tone_named(string_of(*tone, "light.tone"));
        if (!named) throw Damage{filled(tr("{0} is neither plain nor filmic"), {"light.tone"})};
        light.tone = *named;
    }
    if (const Json* reflections = fields.find("reflections")) {
        const bool whole = reflections->is_number_integer();
        const auto count = whole ? reflections->get<std::int64_t>() : -1;
        if (count < 0 || count > max_reflections)
            throw Damage{filled(tr("{0} is no whole number from 0 to 5"), {"light.reflections"})};
        light.reflections = static_cast<int>(count);
    }
    if (const Json* absorption = fields.find("absorption"))
        light.absorption = number_in(*absorption, "light.absorption", 0.0, max_absorption);
    if (const Json* background = fields.find("background"))
        light.background = background_of(*background, "light.background");
    if (const Json* lights = fields.find("lights")) light.lights = lights_of(*lights, unknown);
    return light;
}

}  // namespace zeroset
