#include "document/json/document_json.hpp"

#include "document/colors.hpp"
#include "document/json/document_fields.hpp"
#include "document/json/json_fields.hpp"
#include "document/json/share_text.hpp"
#include "engine/base/enum_names.hpp"
#include "engine/base/translation.hpp"
#include "engine/language/parse.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <utility>

namespace zeroset {
namespace {

/// A width in units of the world, or a text such as "3 px".
Json json_of(const Thickness& thickness) {
    return thickness.in_pixels ? Json(thickness_text(thickness)) : Json(thickness.width);
}

Json json_of(const Box& box) {
    return Json::array({box.lo.x, box.hi.x, box.lo.y, box.hi.y, box.lo.z, box.hi.z});
}

Json json_of(const Statement& statement) {
    Json json{{"text", statement.text}};
    if (!statement.visible) json["visible"] = false;
    if (statement.color) json["color"] = color_text(*statement.color);
    if (statement.solid != SolidSide::Automatic)
        json["solid"] = statement.solid == SolidSide::Below ? "f<0" : "f>0";
    if (statement.look) json["look"] = name_of(*statement.look);
    if (statement.opacity) json["opacity"] = *statement.opacity;
    if (statement.thickness) json["thickness"] = json_of(*statement.thickness);
    if (statement.box) json["box"] = json_of(*statement.box);
    return json;
}

Json json_of(const Slider& slider) {
    Json json{{"value", slider.value},
              {"range", Json::array({slider.lo, slider.hi})},
              {"step", slider.step},
              {"speed", slider.speed},
              {"repeat", name_of(slider.repeat)}};
    if (!slider.presented) json["presented"] = false;
    return json;
}

constexpr auto stop_rules = enum_names<StopRule>("d_stop", "epsilon", "delta");

Json json_of(const StopCriterion& stop) {
    return {{"rule", stop_rules.of(stop.rule)}, {"value", stop.value}};
}

/// The switches in the field "look".
constexpr std::array<std::pair<const char*, bool Document::*>, 7> look_switches{
    {{"mark_undecided", &Document::mark_undecided},
     {"shadows", &Document::shadows},
     {"jumps", &Document::jumps},
     {"axes", &Document::axes},
     {"clip_box", &Document::clip_box},
     {"grid", &Document::grid},
     {"trackball", &Document::trackball}}};

/// True: by beams; false: not at all; a number: by so many rays a pixel.
Json json_of(Antialias antialias) {
    const int across = rays_across(antialias);
    return across > 1 ? Json(across * across) : Json(antialias == Antialias::Beams);
}

Antialias antialias_of(const Json& json, const std::string& place) {
    if (json.is_boolean()) return smooth_edges(json.get<bool>());
    const auto rays = antialias_named(json.dump());
    if (!rays || *rays == Antialias::None)
        throw Damage{filled(tr("{0} is neither true nor false, nor 4, 9, 16 or 64"), {place})};
    return *rays;
}

Json look_of(const Document& document) {
    Json look;
    for (const auto& [name, member] : look_switches)
        look[name] = document.*member;
    look["antialias"] = json_of(document.antialias);
    if (document.axis_names != Document().axis_names) look["axis_names"] = document.axis_names;
    return look;
}

std::array<std::string, 3> axis_names_of(const Json& json, const std::string& place) {
    if (!json.is_array() || json.size() != 3)
        throw Damage{filled(tr("{0} is no list of 3 names"), {place})};
    std::array<std::string, 3> names;
    std::ranges::transform(json, names.begin(),
                           [&](const Json& name) { return label_of(name, place); });
    return names;
}

SolidSide solid_of(const Json& json, const std::string& place) {
    const std::string text = string_of(json, place);
    if (text == "f<0") return SolidSide::Below;
    if (text == "f>0") return SolidSide::Above;
    throw Damage{filled(tr("{0} is neither f<0 nor f>0"), {place})};
}

Box box_of(const Json& json, const std::string& place) {
    const auto n = numbers_of<6>(json, place);
    const Box box{.lo = {n[0], n[2], n[4]}, .hi = {n[1], n[3], n[5]}};
    for (int i = 0; i < 3; ++i) {
        if (!(box.lo[i] < box.hi[i])) throw Damage{filled(tr("{0} is empty"), {place})};
    }
    return box;
}

Thickness thickness_of(const Json& json, const std::string& place) {
    const auto thickness = thickness_from(json.is_string() ? json.get<std::string>() : json.dump());
    if (!thickness)
        throw Damage{
            filled(tr("{0} is neither a width above 0 nor a text such as \"3 px\""), {place})};
    return *thickness;
}

Statement statement_of(const Json& json, const std::string& place,
                       std::vector<std::string>& unknown) {
    Fields fields(json, place, unknown);
    Statement statement;
    statement.text = string_of(fields.get("text"), fields.at("text"));
    if (const Json* visible = fields.find("visible")) {
        statement.visible = flag_of(*visible, fields.at("visible"));
    }
    if (const Json* color = fields.find("color")) {
        statement.color = color_of(*color, fields.at("color"));
    }
    if (const Json* solid = fields.find("solid"))
        statement.solid = solid_of(*solid, fields.at("solid"));
    if (const Json* look = fields.find("look")) statement.look = look_in(*look, fields.at("look"));
    if (const Json* opacity = fields.find("opacity"))
        statement.opacity = number_in(*opacity, fields.at("opacity"), 0.0, 1.0);
    if (const Json* thickness = fields.find("thickness"))
        statement.thickness = thickness_of(*thickness, fields.at("thickness"));
    if (const Json* box = fields.find("box")) statement.box = box_of(*box, fields.at("box"));
    return statement;
}

Repeat repeat_of(const Json& json, const std::string& place) {
    if (const auto repeat = repeat_named(string_of(json, place))) return *repeat;
    throw Damage{filled(tr("{0} is neither loop nor bounce"), {place})};
}

Slider slider_of(const Json& json, const std::string& place, std::vector<std::string>& unknown) {
    Fields fields(json, place, unknown);
    Slider slider;
    slider.value = number_of(fields.get("value"), fields.at("value"));
    const auto [lo, hi] = numbers_of<2>(fields.get("range"), fields.at("range"));
    slider.lo = lo;
    slider.hi = hi;
    if (!(lo < hi)) throw Damage{filled(tr("{0} is empty"), {fields.at("range")})};
    if (const Json* step = fields.find("step")) slider.step = number_of(*step, fields.at("step"));
    if (slider.step < 0) throw Damage{filled(tr("{0} is below 0"), {fields.at("step")})};
    if (const Json* speed = fields.find("speed"))
        slider.speed = number_of(*speed, fields.at("speed"));
    if (slider.speed < slowest || slider.speed > fastest) {
        throw Damage{
            filled(tr("{0} is not between {1} and {2}"), {fields.at("speed"), "1/64", "64"})};
    }
    if (const Json* repeat = fields.find("repeat")) {
        slider.repeat = repeat_of(*repeat, fields.at("repeat"));
    }
    if (const Json* presented = fields.find("presented"))
        slider.presented = flag_of(*presented, fields.at("presented"));
    return slider;
}

StopCriterion stop_of(const Json& json, std::vector<std::string>& unknown) {
    Fields fields(json, "stop", unknown);
    const auto rule = stop_rules.named(string_of(fields.get("rule"), "stop.rule"));
    if (!rule) throw Damage{filled(tr("{0} is none of d_stop, epsilon and delta"), {"stop.rule"})};
    const double value = number_of(fields.get("value"), "stop.value");
    const bool is_depth = *rule == StopRule::DStop;
    if (!(value > 0) || (is_depth && (value > max_d_stop || value != std::floor(value)))) {
        throw Damage{filled(tr("{0} is out of range"), {"stop.value"})};
    }
    return {.rule = *rule, .value = value};
}

std::vector<Statement> statements_of(const Json& json, std::vector<std::string>& unknown) {
    if (!json.is_array()) throw Damage{filled(tr("{0} is no list"), {"statements"})};
    if (json.size() > ProgramLimits::statements)
        throw Damage{tr("there are more than 1000 statements")};
    std::vector<Statement> statements;
    for (const Json& item : json) {
        const std::string place = "statements[" + std::to_string(statements.size()) + "]";
        statements.push_back(statement_of(item, place, unknown));
    }
    if (statements.empty()) statements.emplace_back();
    return statements;
}

void read_parameters(const Json& json, Document& document, std::vector<std::string>& unknown) {
    if (!json.is_object()) throw Damage{filled(tr("{0} is no object"), {"parameters"})};
    for (const auto& [name, slider] : json.items())
        document.parameters[name] = slider_of(slider, "parameters." + name, unknown);
}

void read_look(const Json& json, Document& document, std::vector<std::string>& unknown) {
    Fields fields(json, "look", unknown);
    for (const auto& [name, member] : look_switches) {
        if (const Json* value = fields.find(name))
            document.*member = flag_of(*value, fields.at(name));
    }
    if (const Json* value = fields.find("antialias"))
        document.antialias = antialias_of(*value, fields.at("antialias"));
    if (const Json* value = fields.find("axis_names"))
        document.axis_names = axis_names_of(*value, fields.at("axis_names"));
}

ParsedDocument document_of(const Json& json) {
    ParsedDocument read;
    std::vector<std::string>& unknown = read.unknown;
    Fields fields(json, "", unknown);
    fields.find("zeroset");
    Document& document = read.document;
    document.antialias = Antialias::None;  // as all that is missing in the field "look"
    document.statements = statements_of(fields.get("statements"), unknown);
    if (const Json* parameters = fields.find("parameters")) {
        read_parameters(*parameters, document, unknown);
    }
    if (const Json* w = fields.find("w")) document.w = slider_of(*w, "w", unknown);
    if (const Json* box = fields.find("box")) document.clip = box_of(*box, "box");
    if (const Json* aspect = fields.find("aspect")) document.aspect = stretch_of(*aspect, "aspect");
    if (const Json* region = fields.find("region")) document.region = region_of(*region, unknown);
    if (const Json* camera = fields.find("camera"))
        document.camera = camera_of(*camera, "camera", unknown);
    if (const Json* home = fields.find("home")) document.home = camera_of(*home, "home", unknown);
    if (const Json* views = fields.find("views")) document.views = views_of(*views, unknown);
    if (document.camera) document.up = document.camera->up;
    if (const Json* up = fields.find("up")) document.up = vector_of(*up, "up");
    if (glm::length(document.up) == 0) throw Damage{filled(tr("{0} is zero"), {"up"})};
    if (const Json* stop = fields.find("stop")) document.stop = stop_of(*stop, unknown);
    if (const Json* look = fields.find("look")) read_look(*look, document, unknown);
    if (const Json* color = fields.find("color")) document.coloring = coloring_of(*color, unknown);
    if (const Json* values = fields.find("section_values"))
        document.section_values = section_choice_of(*values, unknown);
    if (const Json* light = fields.find("light")) document.light = light_choice_of(*light, unknown);
    if (const Json* shown_on = fields.find("shown_on"))
        read.shown_on = background_of(*shown_on, "shown_on");
    if (const Json* markers = fields.find("markers"))
        document.markers = markers_of(*markers, unknown);
    document = renumbered(std::move(document), 1);
    return read;
}

/// Throws Damage where `json` is not a document of a format that can be read.
void check_format(const Json& json) {
    if (!json.is_object() || !json.contains("zeroset"))
        throw Damage{tr("it is no Zeroset document")};
    const Json& version = json["zeroset"];
    if (!version.is_number_integer() || version.get<std::int64_t>() < 1) {
        throw Damage{tr("it is damaged: the format version is no number")};
    }
    if (version.get<std::int64_t>() > document_format) {
        throw Damage{
            filled(tr("it was written by a newer Zeroset (format {0}; this one reads up to {1})"),
                   {std::to_string(version.get<std::int64_t>()), std::to_string(document_format)})};
    }
}

/// Refuses what is nested deeper than documents are: JSON is copied by functions that call
/// themselves.
bool refuse_depth(int depth, Json::parse_event_t /*event*/, const Json& /*parsed*/) {
    constexpr int most = 32;
    if (depth > most)
        throw Damage{filled(tr("it is nested more than {0} deep"), {std::to_string(most)})};
    return true;
}

}  // namespace

std::string text_of(const Document& document, const std::optional<Background>& shown_on) {
    Json json;
    json["zeroset"] = document_format;
    json["statements"] = Json::array();
    for (const Statement& statement : document.statements)
        json["statements"].push_back(json_of(statement));
    json["parameters"] = Json::object();
    for (const auto& [name, slider] : document.parameters)
        json["parameters"][name] = json_of(slider);
    json["w"] = json_of(document.w);
    const Box& box = document.clip;
    json["box"] = {box.lo.x, box.hi.x, box.lo.y, box.hi.y, box.lo.z, box.hi.z};
    if (document.aspect) json["aspect"] = array_of(*document.aspect);
    if (!document.region.is_whole()) json["region"] = json_of(document.region);
    if (document.camera) json["camera"] = json_of(*document.camera);
    if (document.home) json["home"] = json_of(*document.home);
    if (!document.views.empty()) json["views"] = json_of(document.views);
    json["up"] = array_of(document.up);
    json["stop"] = json_of(document.stop);
    json["look"] = look_of(document);
    if (document.coloring != ColorChoice()) json["color"] = json_of(document.coloring);
    if (document.section_values != SectionChoice())
        json["section_values"] = json_of(document.section_values);
    if (document.light != LightChoice()) json["light"] = json_of(document.light);
    if (shown_on && !document.light.background) json["shown_on"] = json_of(*shown_on);
    if (!document.markers.empty()) json["markers"] = json_of(document.markers);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::expected<ParsedDocument, std::string> document_from(std::string_view text) {
    if (is_share_text(text)) {
        const auto shared = shared_json(text);
        if (!shared) return std::unexpected(shared.error());
        return document_from(*shared);
    }
    Json json;
    try {
        json = Json::parse(text, refuse_depth);
    } catch (const Damage& damage) {
        return std::unexpected(filled(tr("it is damaged: {0}"), {damage.reason}));
    } catch (const Json::parse_error& error) {
        const auto end =
            text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        const auto line = 1 + std::count(text.begin(), end, '\n');
        return std::unexpected(
            filled(tr("it is damaged: line {0} is no JSON"), {std::to_string(line)}));
    } catch (const Json::out_of_range&) {
        return std::unexpected(tr("it is damaged: a number in it is too large"));
    }
    try {
        check_format(json);
    } catch (const Damage& damage) {
        return std::unexpected(damage.reason);
    }
    try {
        return document_of(json);
    } catch (const Damage& damage) {
        return std::unexpected(filled(tr("it is damaged: {0}"), {damage.reason}));
    }
}

bool looks_like_document(std::string_view text) {
    if (is_share_text(text)) return true;
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    return begin != std::string_view::npos && text[begin] == '{' && text.contains("\"zeroset\"");
}

}  // namespace zeroset
