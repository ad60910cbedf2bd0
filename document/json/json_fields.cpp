#include "document/json/json_fields.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace zeroset {
namespace {

constexpr std::size_t longest_text = 1'000'000;

}  // namespace

Fields::Fields(const Json& json, std::string place, std::vector<std::string>& unknown)
    : json_(json), place_(std::move(place)), unknown_(unknown) {
    if (!json.is_object()) throw Damage{place_ + " is no object"};
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
    if (found == nullptr) throw Damage{at(name) + " is missing"};
    return *found;
}

double number_of(const Json& json, const std::string& place) {
    if (!json.is_number()) throw Damage{place + " is no number"};
    const auto number = json.get<double>();
    if (!(std::abs(number) <= largest_number)) throw Damage{place + " is too large a number"};
    return number;
}

double number_in(const Json& json, const std::string& place, double least, double most) {
    const double number = number_of(json, place);
    if (number >= least && number <= most) return number;
    std::array<char, 64> range{};
    std::snprintf(range.data(), range.size(), " is not between %g and %g", least, most);
    throw Damage{place + range.data()};
}

std::string string_of(const Json& json, const std::string& place) {
    if (!json.is_string()) throw Damage{place + " is no text"};
    auto text = json.get<std::string>();
    if (text.size() > longest_text) throw Damage{place + " is longer than a million characters"};
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
        throw Damage{place + " is longer than " + std::to_string(longest_label) + " bytes"};
    return label;
}

bool flag_of(const Json& json, const std::string& place) {
    if (!json.is_boolean()) throw Damage{place + " is neither true nor false"};
    return json.get<bool>();
}

}  // namespace zeroset
