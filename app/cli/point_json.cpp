#include "app/cli/mesh_report.hpp"

#include <glm/ext/vector_double3.hpp>
#include <nlohmann/json.hpp>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;

Json array_of(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

const char* name_of(Certificate certificate) {
    switch (certificate) {
        case Certificate::Miss: return "miss";
        case Certificate::Certified: return "certified";
        case Certificate::Undecided: return "undecided";
        case Certificate::Coarse: return "certified, coarse";
        case Certificate::Jump: return "jump in sign";
    }
    return "";
}

}  // namespace

std::string json_line(int col, int row, const std::optional<PointFacts>& facts, std::size_t surface,
                      const std::string& reading) {
    Json json{{"col", col}, {"row", row}, {"hit", facts.has_value()}};
    if (facts) {
        json["point"] = array_of(facts->point);
        json["within"] = facts->within;
        json["proved"] = facts->proved;
        json["f"] = facts->f;
        json["normal"] = array_of(facts->normal);
        json["distance"] = facts->distance;
        json["certificate"] = name_of(facts->certificate);
        json["surface"] = surface;
        json["reading"] = reading;
    }
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace zeroset
