#pragma once

#include "document/document.hpp"
#include "engine/base/translation.hpp"

#include <glm/ext/vector_double3.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

// Helpers for reading a document's JSON. Private to the *_json.cpp files.

namespace zeroset {

using Json = nlohmann::ordered_json;

/// The reason why a text is no document; thrown, and caught in document_from.
struct Damage {
    std::string reason;
};

/// An object of the file whose fields are taken one by one; those not taken are added to `unknown`.
class Fields {
public:
    Fields(const Json& json, std::string place, std::vector<std::string>& unknown);
    ~Fields();
    Fields(const Fields&) = delete;
    Fields& operator=(const Fields&) = delete;

    /// The field, or nullptr where it is missing.
    const Json* find(const char* name);
    /// The field; throws Damage where it is missing.
    const Json& get(const char* name);
    /// The full name of a field, for messages.
    [[nodiscard]] std::string at(const std::string& name) const {
        return place_.empty() ? name : place_ + "." + name;
    }
    std::vector<std::string>& unknown() { return unknown_; }

private:
    const Json& json_;
    std::string place_;
    std::vector<std::string>& unknown_;
    std::vector<std::string> taken_;
};

// Readers of values. They throw Damage that names `place` where a value is of another kind.

double number_of(const Json& json, const std::string& place);
/// A number from `least` to `most`.
double number_in(const Json& json, const std::string& place, double least, double most);
std::string string_of(const Json& json, const std::string& place);
/// A text of at most longest_label bytes.
std::string label_of(const Json& json, const std::string& place);
bool flag_of(const Json& json, const std::string& place);

glm::dvec3 vector_of(const Json& json, const std::string& place);

/// The list [x, y, z].
Json array_of(const glm::dvec3& v);

template <std::size_t count>
std::array<double, count> numbers_of(const Json& json, const std::string& place) {
    if (!json.is_array() || json.size() != count) {
        throw Damage{filled(tr("{0} is no list of {1} numbers"), {place, std::to_string(count)})};
    }
    std::array<double, count> numbers{};
    for (std::size_t i = 0; i < count; ++i)
        numbers[i] = number_of(json[i], place);
    return numbers;
}

}  // namespace zeroset
