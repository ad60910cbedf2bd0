#include "app/picture_point.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/scene/tolerance.hpp"

#include "document/json_fields.hpp"
#include <nlohmann/json.hpp>

namespace zeroset {
namespace {

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

std::vector<Kernel> typed_formulas(const Program& program, const std::vector<std::size_t>& shown) {
    std::vector<Kernel> formulas;
    for (const std::size_t surface : shown)
        formulas.push_back(interpret(program.surfaces[surface]));
    return formulas;
}

double depth_tolerance(const Box& clip, const StopCriterion& stop, Precision precision) {
    constexpr double guess = 1e-3;  // of the box
    return certified_width(clip, stop, precision).value_or(guess * clip.size());
}

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
