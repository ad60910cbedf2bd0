#include "document/json/document_fields.hpp"
#include "engine/base/translation.hpp"

#include <cstdint>

namespace zeroset {
namespace {

constexpr std::int64_t largest_marker = 1'000'000;

ValueRange range_of(const Json& json, const std::string& place) {
    const auto [lo, hi] = numbers_of<2>(json, place);
    if (!(lo < hi)) throw Damage{filled(tr("{0} is empty"), {place})};
    return {.lo = lo, .hi = hi};
}

Json json_of(const LineChoice& lines) {
    Json json{{"contours", name_of(lines.contours)},
              {"labels", lines.labels},
              {"intersections", lines.intersections}};
    if (!lines.expression.empty()) json["expression"] = lines.expression;
    if (lines.step) json["step"] = *lines.step;
    if (lines.width) json["width"] = *lines.width;
    return json;
}

LineChoice lines_of(const Json& json, std::vector<std::string>& unknown) {
    Fields fields(json, "color.lines", unknown);
    LineChoice lines;
    if (const Json* contours = fields.find("contours")) {
        const auto named = contours_named(string_of(*contours, fields.at("contours")));
        if (!named)
            throw Damage{filled(tr("{0} is none of none, height, xyz, expression"),
                                {fields.at("contours")})};
        lines.contours = *named;
    }
    if (const Json* expression = fields.find("expression"))
        lines.expression = string_of(*expression, fields.at("expression"));
    if (const Json* step = fields.find("step")) {
        lines.step = number_of(*step, fields.at("step"));
        if (!(*lines.step > 0.0))
            throw Damage{filled(tr("{0} is not above 0"), {fields.at("step")})};
    }
    if (const Json* width = fields.find("width"))
        lines.width = number_in(*width, fields.at("width"), least_line, most_line);
    // Earlier versions wrote a width for pictures alone, chosen or not.
    if (const Json* width = fields.find("width_px"); width != nullptr && !lines.width) {
        const double pixels = number_in(*width, fields.at("width_px"), least_line, most_line);
        if (static_cast<float>(pixels) != SurfaceLines().width_px) lines.width = pixels;
    }
    if (const Json* labels = fields.find("labels"))
        lines.labels = flag_of(*labels, fields.at("labels"));
    if (const Json* intersections = fields.find("intersections"))
        lines.intersections = flag_of(*intersections, fields.at("intersections"));
    return lines;
}

}  // namespace

Json json_of(const ColorChoice& coloring) {
    Json json{{"by", name_of(coloring.by)}};
    if (!coloring.expression.empty()) json["expression"] = coloring.expression;
    if (coloring.map) json["map"] = name_of(*coloring.map);
    if (coloring.range) json["range"] = Json::array({coloring.range->lo, coloring.range->hi});
    if (coloring.lines != LineChoice()) json["lines"] = json_of(coloring.lines);
    return json;
}

ColorChoice coloring_of(const Json& json, std::vector<std::string>& unknown) {
    Fields fields(json, "color", unknown);
    ColorChoice coloring;
    const auto by = color_by_named(string_of(fields.get("by"), "color.by"));
    if (!by) throw Damage{filled(tr("{0} is nothing that surfaces are colored by"), {"color.by"})};
    coloring.by = *by;
    if (const Json* expression = fields.find("expression")) {
        coloring.expression = string_of(*expression, "color.expression");
    }
    if (const Json* map = fields.find("map")) {
        coloring.map = color_map_named(string_of(*map, "color.map"));
        if (!coloring.map) throw Damage{filled(tr("{0} is no color map"), {"color.map"})};
    }
    if (const Json* range = fields.find("range")) coloring.range = range_of(*range, "color.range");
    if (const Json* lines = fields.find("lines")) coloring.lines = lines_of(*lines, unknown);
    return coloring;
}

Json json_of(const SectionChoice& values) {
    Json json = Json::object();
    if (values.map) json["map"] = name_of(*values.map);
    if (values.range) json["range"] = Json::array({values.range->lo, values.range->hi});
    return json;
}

SectionChoice section_choice_of(const Json& json, std::vector<std::string>& unknown) {
    Fields fields(json, "section_values", unknown);
    SectionChoice values;
    if (const Json* map = fields.find("map")) {
        values.map = color_map_named(string_of(*map, fields.at("map")));
        if (!values.map) throw Damage{filled(tr("{0} is no color map"), {fields.at("map")})};
    }
    if (const Json* range = fields.find("range"))
        values.range = range_of(*range, fields.at("range"));
    return values;
}

Json json_of(const std::vector<Marker>& markers) {
    Json json = Json::array();
    for (const Marker& marker : markers) {
        Json item{{"number", marker.number}, {"at", array_of(marker.at)}};
        if (!marker.label.empty()) item["label"] = marker.label;
        json.push_back(std::move(item));
    }
    return json;
}

std::vector<Marker> markers_of(const Json& json, std::vector<std::string>& unknown) {
    if (!json.is_array()) throw Damage{filled(tr("{0} is no list"), {"markers"})};
    if (json.size() > most_markers) throw Damage{tr("there are more than 1000 markers")};
    std::vector<Marker> markers;
    for (const Json& item : json) {
        const std::string place = "markers[" + std::to_string(markers.size()) + "]";
        Fields fields(item, place, unknown);
        const Json& number = fields.get("number");
        const bool whole = number.is_number_integer() && number.get<std::int64_t>() >= 1 &&
                           number.get<std::int64_t>() <= largest_marker;
        if (!whole)
            throw Damage{
                filled(tr("{0} is no whole number from 1 to 1000000"), {fields.at("number")})};
        Marker marker{.number = number.get<int>(), .at = {}, .label = {}};
        if (find_marker(markers, marker.number) != nullptr) {
            throw Damage{filled(tr("{0} is that of another marker"), {fields.at("number")})};
        }
        marker.at = vector_of(fields.get("at"), fields.at("at"));
        if (const Json* label = fields.find("label"))
            marker.label = label_of(*label, fields.at("label"));
        markers.push_back(std::move(marker));
    }
    return markers;
}

}  // namespace zeroset
