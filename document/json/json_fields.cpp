#include "document/json/json_fields.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace zeroset {
namespace {

constexpr std::size_t longest_string = 1'000'000;

}  // namespace

Fields::Fields(const Json& json, std::string place, std::vector<std::string>& unknown)
    : json_(json), place_(std::move(place)), unknown_(unknown) {
    if (!json.is_object()) throw Damage{filled(tr("{0} is no object"), {place_})};
}

Fields::~Fields() {
    for (const auto& [name, value] : json_.items()) {
        if (std::ranges::find(taken_, name) == taken_.end()) unknown_.push_back(at(name));
    }
}

const Json* Fields::find(const char* name) {
    taken_.emplace_back(name);
    const auto found = json_.find(name);
    return found == json_.end() ? nullptr : &*found;
}

const Json& Fields::get(const char* name) {
    const Json* found = find(name);
    if (found == nullptr) throw Damage{filled(tr("{0} is missing"), {at(name)})};
    return *found;
}

double number_of(const Json& json, const std::string& place) {
    if (!json.is_number()) throw Damage{filled(tr("{0} is no number"), {place})};
    const auto number = json.get<double>();
    if (!(std::abs(number) <= largest_number))
        throw Damage{filled(tr("{0} is too large a number"), {place})};
    return number;
}

double number_in(const Json& json, const std::string& place, double least, double most) {
    const double number = number_of(json, place);
    if (number >= least && number <= most) return number;
    throw Damage{filled(tr("{0} is not between {1} and {2}"),
                        {place, short_number(least, 6), short_number(most, 6)})};
}

std::string string_of(const Json& json, const std::string& place) {
    if (!json.is_string()) throw Damage{filled(tr("{0} is no text"), {place})};
    auto text = json.get<std::string>();
    if (text.size() > longest_string)
        throw Damage{filled(tr("{0} is longer than a million characters"), {place})};
    return text;
}

glm::dvec3 vector_of(const Json& json, const std::string& place) {
    const auto [x, y, z] = numbers_of<3>(json, place);
    return {x, y, z};
}

Json array_of(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

std::string label_of(const Json& json, const std::string& place) {
    std::string label = string_of(json, place);
    if (label.size() > longest_label)
        throw Damage{
            filled(tr("{0} is longer than {1} bytes"), {place, std::to_string(longest_label)})};
    return label;
}

bool flag_of(const Json& json, const std::string& place) {
    if (!json.is_boolean()) throw Damage{filled(tr("{0} is neither true nor false"), {place})};
    return json.get<bool>();
}

}  // namespace zeroset
