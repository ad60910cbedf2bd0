#include "document/import/pov_pattern.hpp"

#include "engine/base/translation.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>

namespace zeroset {
namespace {

/// Patterns that are functions of the language: f_agate and so on.
constexpr std::array<std::string_view, 19> known{
    "agate",       "boxed",     "bozo",    "brick",   "bumps",   "checker", "crackle",
    "cylindrical", "dents",     "granite", "leopard", "marble",  "onion",   "planar",
    "radial",      "spherical", "spotted", "wood",    "wrinkles"};

/// The map that mixes two colours by values from 0 to 1.
std::vector<PovPattern::Entry> gradient_of(const PovValue& first, const PovValue& last) {
    return {{.at = 0.0, .color = first}, {.at = 1.0, .color = last}};
}

class PatternReader {
public:
    PatternReader(PovScript& script, PovModifiers& modifiers, ImportedDocument& result)
        : script_(script), modifiers_(modifiers), result_(result) {}

    std::expected<PovPattern, std::string> run() {
        script_.take_sign("{");
        pigment_ = script_.next().text == "pigment";
        if (!script_.take_sign("{"))
            return std::unexpected(tr("a pattern is { ... }; it is left out"));
        const ScriptToken word = script_.next();
        const auto function = function_of(word);
        while (script_.peek().kind != ScriptKind::End && !script_.take_sign("}"))
            modifier();
        script_.take_sign("}");
        const auto back = placement_.inverse();
        if (!function)
            return std::unexpected(
                filled(tr("the pattern {0} is not taken over"), {word.text.substr(0, 40)}));
        if (!back) return std::unexpected(tr("it is scaled to nothing; it is left out"));
        pattern_.call = *function + "(" + bent() + ")";
        if (!back->is_identity()) pattern_.moved = coordinates_of(*back);
        if (pigment_ && pattern_.map.empty()) pattern_.map = gradient_of({0, 0, 0}, {1, 1, 1});
        std::ranges::stable_sort(pattern_.map, {}, &PovPattern::Entry::at);
        return std::move(pattern_);
    }

private:
    std::optional<std::string> function_of(const ScriptToken& word) {
        if (std::ranges::find(known, word.text) != known.end()) {
            // These take two colours, not a map.
            if (pigment_ && (word.text == "checker" || word.text == "brick")) two_colors();
            return "f_" + std::string(word.text);
        }
        if (word.text == "gradient") {
            const auto axis = script_.value();
            if (!axis) return std::nullopt;
            const glm::dvec3 along = vector_of(*axis);
            if (along == glm::dvec3(1, 0, 0)) return "f_gradientX";
            if (along == glm::dvec3(0, 1, 0)) return "f_gradientY";
            if (along == glm::dvec3(0, 0, 1)) return "f_gradientZ";
        }
        if (word.text == "spiral1" || word.text == "spiral2") {
            const auto arms = script_.value();
            if (arms && (*arms)[0] == 2.0) return "f_" + std::string(word.text);
        }
        return std::nullopt;
    }

    void two_colors() {
        std::vector<PovValue> colors;
        while (colors.size() < 2 && !script_.at_sign("}")) {
            script_.take_sign(",");
            const auto color = script_.value();
            if (!color) break;
            colors.push_back(*color);
        }
        if (colors.size() == 2) pattern_.map = gradient_of(colors[0], colors[1]);
    }

    void modifier() {
        if (const auto step = modifiers_.transformation()) {
            placement_ = placement_.then(*step);
            return;
        }
        const ScriptToken word = script_.next();
        if (word.kind != ScriptKind::Name) return;
        const auto number = numbers_.find(word.text);
        if (word.text == "color_map" || word.text == "colour_map") {
            color_map(word);
        } else if (word.text == "turbulence") {
            if (const auto by = modifiers_.vector(word)) turbulence_ = *by;
            turbulence_line_ = word.line;
        } else if (number != numbers_.end()) {
            number->second = modifiers_.number(word).value_or(number->second);
        } else {
            if (script_.at_sign("{")) script_.skip_block();
            result_.note(word.line, word.text, tr("not taken over"));
        }
    }

    void color_map(const ScriptToken& word) {
        if (!script_.take_sign("{")) return;
        while (script_.peek().kind != ScriptKind::End && !script_.take_sign("}")) {
            if (!script_.take_sign("[")) {
                script_.next();
                continue;
            }
            const auto at = script_.value();
            script_.take_sign(",");
            const auto color = script_.value();
            const bool is_range = at && color && color->size() == 1 && !script_.at_sign("]");
            if (is_range) {
                range(word, (*at)[0], (*color)[0]);
            } else if (at && color)
                pattern_.map.push_back({.at = (*at)[0], .color = *color});
            else
                result_.note(word.line, word.text, tr("its value is not known; it is left out"));
            while (script_.peek().kind != ScriptKind::End && !script_.take_sign("]"))
                script_.next();
        }
        if (pattern_.map.empty()) result_.note(word.line, word.text, tr("not taken over"));
    }

    /// Reads the two colours of an entry of the old form, [begin end color color].
    void range(const ScriptToken& word, double begin, double end) {
        const auto first = script_.value();
        script_.take_sign(",");
        const auto last = script_.value();
        if (!first || !last) {
            result_.note(word.line, word.text, tr("its value is not known; it is left out"));
            return;
        }
        pattern_.map.push_back({.at = begin, .color = *first});
        pattern_.map.push_back({.at = end, .color = *last});
    }

    /// The coordinates, moved by turbulence: three sums of octaves of noise.
    std::string bent() {
        if (turbulence_ == glm::dvec3(0.0)) return "x, y, z";
        result_.note(turbulence_line_, "turbulence",
                     tr("the noise is Zeroset's own: its bumps lie elsewhere than in the program "
                        "that the formula is from"));
        std::string text;
        for (int axis = 0; axis < 3; ++axis) {
            text += axis > 0 ? ", " : "";
            text += "xyz"[axis];
            if (turbulence_[axis] == 0.0) continue;
            // DTurbulence's components have half the height of noise.
            text += " + " + exact_number(turbulence_[axis] / 2.0, true) + "*fbm(x, y, z, " +
                    exact_number(std::clamp(numbers_.at("octaves"), 1.0, 10.0)) + ", " +
                    exact_number(numbers_.at("omega"), true) + ", " +
                    exact_number(numbers_.at("lambda"), true) + ", " + std::to_string(10 * axis) +
                    ")";
        }
        return text;
    }

    PovScript& script_;
    PovModifiers& modifiers_;
    ImportedDocument& result_;
    PovPattern pattern_;
    Placement placement_;
    glm::dvec3 turbulence_{0.0};
    std::size_t turbulence_line_ = 0;
    std::map<std::string, double, std::less<>> numbers_{
        {"octaves", 6.0}, {"omega", 0.5}, {"lambda", 2.0}};
    bool pigment_ = false;
};

}  // namespace

std::expected<PovPattern, std::string> PovPattern::read(PovScript& script, PovModifiers& modifiers,
                                                        ImportedDocument& result) {
    return PatternReader(script, modifiers, result).run();
}

std::string PovPattern::mapped(const std::string& value, int channel) const {
    const auto shade = [channel](const Entry& entry) { return vector_of(entry.color)[channel]; };
    const bool is_value = map.size() == 2 && map[0].at == 0.0 && map[1].at == 1.0 &&
                          shade(map[0]) == 0.0 && shade(map[1]) == 1.0;
    if (is_value) return value;
    std::string text = exact_number(shade(map.back()));
    for (std::size_t i = map.size() - 1; i-- > 0;) {
        const Entry& begin = map[i];
        const Entry& end = map[i + 1];
        std::string part = exact_number(shade(begin));
        if (shade(begin) != shade(end) && end.at > begin.at) {
            const double slope = (shade(end) - shade(begin)) / (end.at - begin.at);
            part += " + " + exact_number(slope, true) + "*(" + value + " - " +
                    exact_number(begin.at, true) + ")";
        }
        text = "if(" + value + " < " + exact_number(end.at) + ", " + part + ", " + text + ")";
    }
    // Values below the first entry have its colour.
    return map.front().at > 0.0 ? "if(" + value + " < " + exact_number(map.front().at) + ", " +
                                      exact_number(shade(map.front())) + ", " + text + ")"
                                : text;
}

}  // namespace zeroset
