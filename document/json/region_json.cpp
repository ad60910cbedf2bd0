#include "document/json/document_fields.hpp"
#include "engine/base/translation.hpp"

#include <cmath>

namespace zeroset {
namespace {

Ball ball_of(const Json& json, std::vector<std::string>& unknown) {
    Fields fields(json, "region.sphere", unknown);
    Ball ball;
    if (const Json* centre = fields.find("centre"))
        ball.centre = vector_of(*centre, fields.at("centre"));
    ball.radius = number_of(fields.get("radius"), fields.at("radius"));
    if (!(ball.radius > 0)) throw Damage{filled(tr("{0} is not above 0"), {fields.at("radius")})};
    return ball;
}

Section section_of(const Json& json, const std::string& place, std::vector<std::string>& unknown) {
    constexpr double shortest = 1e-30;
    Fields fields(json, place, unknown);
    const glm::dvec3 normal = vector_of(fields.get("normal"), fields.at("normal"));
    if (!(glm::length(normal) > shortest))
        throw Damage{filled(tr("{0} has no direction"), {fields.at("normal")})};
    const double offset = number_of(fields.get("offset"), fields.at("offset"));
    Section section{.normal = normal, .offset = offset};
    // Keep a normal of length 1 to the bit, as this program writes it.
    if (std::abs(glm::length(normal) - 1.0) > 1e-15) section = make_section(normal, offset);
    if (const Json* cap = fields.find("cap")) section.cap = flag_of(*cap, fields.at("cap"));
    if (const Json* values = fields.find("values"))
        section.values = flag_of(*values, fields.at("values"));
    return section;
}

}  // namespace

Json json_of(const Region& region) {
    Json json = Json::object();
    if (region.ball) {
        json["sphere"] = {{"centre", array_of(region.ball->centre)},
                          {"radius", region.ball->radius}};
    }
    if (!region.sections.empty()) json["sections"] = Json::array();
    for (const Section& section : region.sections) {
        json["sections"].push_back({{"normal", array_of(section.normal)},
                                    {"offset", section.offset},
                                    {"cap", section.cap}});
        if (section.values) json["sections"].back()["values"] = true;
    }
    return json;
}

Region region_of(const Json& json, std::vector<std::string>& unknown) {
    Fields fields(json, "region", unknown);
    Region region;
    if (const Json* sphere = fields.find("sphere")) region.ball = ball_of(*sphere, unknown);
    const Json* const sections = fields.find("sections");
    if (sections == nullptr) return region;
    if (!sections->is_array()) throw Damage{filled(tr("{0} is no list"), {"region.sections"})};
    if (sections->size() > max_sections) {
        throw Damage{filled(tr("{0} has more than {1} items"),
                            {"region.sections", std::to_string(max_sections)})};
    }
    for (const Json& item : *sections) {
        const std::string place = "region.sections[" + std::to_string(region.sections.size()) + "]";
        region.sections.push_back(section_of(item, place, unknown));
    }
    return region;
}

}  // namespace zeroset
