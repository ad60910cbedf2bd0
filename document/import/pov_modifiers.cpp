#include "document/import/pov_modifiers.hpp"

#include "document/import/imported.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <string_view>

namespace zeroset {
namespace {

constexpr int deepest_block = 60;

}  // namespace

std::optional<double> PovModifiers::number(const ScriptToken& word) {
    const auto value = script_.value();
    if (value) return (*value)[0];
    result_.note(word.line, word.text, tr("its value is not known; it is left out"));
    return std::nullopt;
}

std::optional<glm::dvec3> PovModifiers::vector(const ScriptToken& word) {
    const auto value = script_.value();
    if (value) return vector_of(*value);
    result_.note(word.line, word.text, tr("its value is not known; it is left out"));
    return std::nullopt;
}

bool PovModifiers::read(Placement& placement, PovLook& look) {
    const ScriptToken word = script_.peek();
    if (word.kind != ScriptKind::Name) return false;
    static constexpr std::array<std::string_view, 4> looks{"texture", "pigment", "material",
                                                           "color"};
    if (std::ranges::find(looks, word.text) != looks.end()) {
        script_.next();
        read_look(word, look);
        return true;
    }
    const auto step = transformation();
    if (step) placement = placement.then(*step);
    return step.has_value();
}

std::optional<Placement> PovModifiers::transformation() {
    const ScriptToken word = script_.peek();
    if (word.text == "transform") return transform();
    const bool known = word.text == "scale" || word.text == "rotate" || word.text == "translate" ||
                       word.text == "matrix";
    if (word.kind != ScriptKind::Name || !known) return std::nullopt;
    script_.next();
    if (word.text == "matrix") return matrix(word);
    const auto value = vector(word);
    if (!value) return Placement{};
    if (word.text == "translate") return Placement::moving(*value);
    if (word.text == "scale") {
        glm::dvec3 factors = *value;
        for (int i = 0; i < 3; ++i)
            if (factors[i] == 0.0) factors[i] = 1.0;
        return Placement::scaling(factors);
    }
    Placement turned;
    for (int axis = 0; axis < 3; ++axis) {
        if ((*value)[axis] == 0.0) continue;
        turned = turned.then(Placement::turning(axis, (*value)[axis] * std::numbers::pi / 180.0));
    }
    return turned;
}

Placement PovModifiers::matrix(const ScriptToken& word) {
    Placement result;
    std::array<double, 12> m{};
    script_.take_sign("<");
    for (double& entry : m) {
        const auto value = script_.value();
        script_.take_sign(",");
        if (!value) {
            result_.note(word.line, word.text, tr("its value is not known; it is left out"));
            return {};
        }
        entry = (*value)[0];
    }
    script_.take_sign(">");
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            result.linear[i][j] = m[static_cast<std::size_t>(3 * i + j)];
        result.shift[i] = m[static_cast<std::size_t>(9 + i)];
    }
    return result;
}

Placement PovModifiers::transform() {
    const ScriptToken word = script_.next();
    const bool braces = script_.take_sign("{");
    Placement result;
    if (!braces) {
        const auto known = transforms_.find(script_.next().text);
        return known == transforms_.end() ? result : known->second;
    }
    bool inverse = false;
    while (!script_.take_sign("}") && script_.peek().kind != ScriptKind::End) {
        if (script_.take_name("inverse")) {
            inverse = true;
            continue;
        }
        const auto known = transforms_.find(script_.peek().text);
        if (known != transforms_.end()) {
            script_.next();
            result = result.then(known->second);
        } else if (depth_ < deepest_block) {
            ++depth_;
            const auto step = transformation();
            --depth_;
            if (step)
                result = result.then(*step);
            else
                result_.note(word.line, script_.next().text, tr("not taken over"));
        } else {
            script_.next();
        }
    }
    return inverse ? result.inverse().value_or(result) : result;
}

void PovModifiers::read_look(const ScriptToken& word, PovLook& look) {
    if (word.text == "color") return take_color(script_.value(), look);
    if (!script_.take_sign("{")) return;
    int open = 1;
    while (open > 0 && script_.peek().kind != ScriptKind::End) {
        const ScriptToken token = script_.peek();
        if (script_.take_sign("{")) {
            ++open;
            continue;
        }
        if (script_.take_sign("}")) {
            --open;
            continue;
        }
        static constexpr std::array<std::string_view, 7> colors{"rgb",    "rgbt", "rgbf", "color",
                                                                "colour", "srgb", "rgbft"};
        const auto known = looks_.find(token.text);
        if (token.kind == ScriptKind::Name && known != looks_.end()) {
            if (!look.color) look = known->second;
            script_.next();
        } else if (std::ranges::find(colors, token.text) != colors.end()) {
            take_color(script_.value(), look);
        } else {
            const auto value = script_.value_of(token.text);
            script_.next();
            if (token.kind == ScriptKind::Name && value && value->size() >= 3 &&
                token.text.size() > 1)
                take_color(value, look);
        }
    }
}

void PovModifiers::take_color(const std::optional<PovValue>& color, PovLook& look) {
    if (!color || color->size() < 3 || look.color) return;
    look.color = shown_color((*color)[0], (*color)[1], (*color)[2]);
    const double through =
        (color->size() > 3 ? (*color)[3] : 0.0) + (color->size() > 4 ? (*color)[4] : 0.0);
    if (through > 0.0) look.opacity = std::clamp(1.0 - through, 0.0, 1.0);
}

bool PovModifiers::declare(const std::string& name) {
    const ScriptToken word = script_.peek();
    if (word.text == "transform") {
        transforms_.insert_or_assign(name, transform());
        return true;
    }
    static constexpr std::array<std::string_view, 4> looks{"texture", "pigment", "material",
                                                           "finish"};
    if (std::ranges::find(looks, word.text) != looks.end()) {
        script_.next();
        PovLook look;
        read_look(word, look);
        looks_.insert_or_assign(name, look);
        return true;
    }
    return false;
}

}  // namespace zeroset
