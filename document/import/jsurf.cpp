#include "document/import/foreign_formula.hpp"
#include "document/import/names.hpp"
#include "document/import/placement.hpp"
#include "document/import/readers.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/base/utf8.hpp"
#include "engine/image/gamma.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>

// Surfaces of SURFER and jsurf: Java properties. A point p of the clip ball |p| <= 1 shows where
// transform_matrix * rotation_matrix puts it, and lies on the surface where the equation holds at
// surface_transform_matrix * 10^scale_factor * p.

namespace zeroset {
namespace {

struct Property {
    std::string value;
    std::size_t line;
};
using Properties = std::map<std::string, Property, std::less<>>;

/// The character that \uXXXX names, in UTF-8; nothing where `digits` is no number of four digits.
std::optional<std::string> unicode(std::string_view digits) {
    unsigned code = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (error != std::errc() || digits.size() != 4 || end != digits.data() + 4) return std::nullopt;
    std::string text;
    add_character(text, code);
    return text;
}

/// Reads lines "key=value" with the escapes of Java's properties.
class PropertyReader {
public:
    explicit PropertyReader(std::string_view text) : text_(text) {}

    Properties run() {
        Properties properties;
        while (at_ < text_.size()) {
            skip_blanks();
            const std::size_t line = line_;
            if (at_ < text_.size() && (text_[at_] == '#' || text_[at_] == '!')) {
                skip_line();
                continue;
            }
            const std::string key = part(true);
            const std::string value = part(false);
            if (!key.empty())
                properties.insert_or_assign(key, Property{.value = value, .line = line});
        }
        return properties;
    }

private:
    void skip_blanks() {
        for (; at_ < text_.size() && static_cast<unsigned char>(text_[at_]) <= ' '; ++at_)
            if (text_[at_] == '\n') ++line_;
    }

    void skip_line() {
        while (at_ < text_.size() && text_[at_] != '\n')
            ++at_;
    }

    std::string escape() {
        const char letter = text_[at_++];
        if (letter == 'n') return "\n";
        if (letter == 't') return "\t";
        if (letter == 'u') {
            if (auto character = unicode(text_.substr(at_, 4))) {
                at_ += 4;
                return *character;
            }
        }
        if (letter != '\n') return std::string{letter};
        ++line_;
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t'))
            ++at_;
        return {};
    }

    std::string part(bool is_key) {
        std::string result;
        while (at_ < text_.size()) {
            const char letter = text_[at_++];
            if (letter == '\\' && at_ < text_.size()) {
                result += escape();
            } else if (letter == '\n') {
                // The line end is met again, as an empty value or as a blank.
                --at_;
                break;
            } else if (is_key && (letter == '=' || letter == ':')) {
                break;
            } else if (letter != '\r') {
                result += letter;
            }
        }
        return std::string(trimmed(result));
    }

    std::string_view text_;
    std::size_t at_ = 0, line_ = 1;
};

std::vector<double> numbers_of(std::string_view text) {
    std::vector<double> numbers;
    for (const std::string_view word : split(text, ' ')) {
        if (word.empty()) continue;
        const auto number = number_from<double>(word);
        if (!number || !std::isfinite(*number)) return {};
        numbers.push_back(*number);
    }
    return numbers;
}

/// Makes the document of the properties; each that is used is marked.
class JsurfReader {
public:
    explicit JsurfReader(Properties properties) : properties_(std::move(properties)) {}

    ImportedDocument run(const Property& equation) {
        used_.insert("surface_equation");
        add_parameters();
        place();
        add_surface(equation);
        add_light();
        note_the_rest();
        result_.tells_box = true;
        return std::move(result_);
    }

private:
    /// The property's numbers, if there are so many and all are finite; else a note.
    std::optional<std::vector<double>> numbers(const std::string& key, std::size_t count) {
        const auto found = properties_.find(key);
        if (found == properties_.end()) return std::nullopt;
        used_.insert(key);
        auto values = numbers_of(found->second.value);
        if (values.size() == count) return values;
        result_.note(
            found->second.line, key,
            filled(tr("it should be {0} numbers; it is left out"), {std::to_string(count)}));
        return std::nullopt;
    }

    double number(const std::string& key, double otherwise) {
        const auto values = numbers(key, 1);
        return values ? (*values)[0] : otherwise;
    }

    std::string word(const std::string& key) {
        const auto found = properties_.find(key);
        if (found == properties_.end()) return {};
        used_.insert(key);
        return found->second.value;
    }

    std::optional<std::uint32_t> color(const std::string& key) {
        const auto rgb = numbers(key, 3);
        if (!rgb) return std::nullopt;
        return shown_color((*rgb)[0], (*rgb)[1], (*rgb)[2]);
    }

    Placement matrix(const std::string& key) {
        const auto m = numbers(key, 16);
        Placement result;
        if (!m) return result;
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t column = 0; column < 3; ++column)
                result.linear[static_cast<int>(column)][static_cast<int>(row)] =
                    (*m)[4 * row + column];
            result.shift[static_cast<int>(row)] = (*m)[4 * row + 3];
        }
        return result;
    }

    void add_parameters() {
        constexpr std::string_view prefix = "surface_parameter_";
        for (const auto& [key, property] : properties_) {
            if (!key.starts_with(prefix)) continue;
            const std::string name = key.substr(prefix.size());
            const auto value = numbers(key, 1);
            if (!value || name.empty()) continue;
            if (can_have_slider(name)) {
                Slider slider{.lo = 0.0, .hi = 1.0};
                set_value(slider, (*value)[0]);
                result_.document.parameters[name] = slider;
            } else {
                result_.add_definition(name + " := " + exact_number((*value)[0]), property.line);
                result_.note(property.line, key, tr("a constant of the text, without a slider"));
            }
        }
    }

    /// Sets clip ball, box and camera.
    void place() {
        const double scale = std::pow(10.0, number("scale_factor", 0.0));
        const Placement surface =
            Placement::scaling(glm::dvec3(scale)).then(matrix("surface_transform_matrix"));
        const Placement shown = matrix("rotation_matrix").then(matrix("transform_matrix"));
        const auto from_shown = shown.inverse();
        double radius = 1.0;
        Placement from_ball;
        if (const auto factor = surface.scale()) {
            radius = *factor;
            from_ball = surface;
        } else if (surface.inverse()) {
            substituted_ = surface;
        } else {
            result_.note(0, "surface_transform_matrix",
                         tr("it cannot be inverted; it is left out"));
        }
        const glm::dvec3 centre = from_ball.of(glm::dvec3(0.0));
        result_.document.region.ball = Ball{.centre = centre, .radius = radius};
        result_.document.clip = {.lo = centre - radius, .hi = centre + radius};
        result_.document.up = glm::dvec3(0.0, 1.0, 0.0);
        if (from_shown && from_shown->scale()) look(from_shown->then(from_ball));
    }

    void look(const Placement& from_world) {
        const auto eye = matrix("camera_transform").inverse();
        const bool parallel = word("camera_type") != "PERSPECTIVE_CAMERA";
        const double height = number("camera_height", 2.0);
        const double fov_deg = number("camera_fov_y", 60.0);
        if (!eye || !eye->scale()) return;
        // The point looked at is the ball's centre's nearest on the axis of the view.
        const double distance = std::max(1e-3, glm::dot(eye->shift, eye->linear[2]));
        Placement from_view = *eye;
        from_view.shift = eye->shift - distance * eye->linear[2];
        const double half =
            parallel ? 0.5 * height : distance * std::tan(std::numbers::pi * fov_deg / 360.0);
        if (!(half > 0.0) || !std::isfinite(half)) return;
        const Camera camera = camera_of_view(from_view.then(from_world), half,
                                             parallel ? std::nullopt : std::optional(distance));
        if (camera_defect(camera) == nullptr) {
            result_.document.camera = result_.document.home = camera;
            result_.document.up = camera.up;
        }
    }

    void add_surface(const Property& equation) {
        const auto front = color("front_material_color");
        const auto back = color("back_material_color");
        const auto term = read_whole_term(equation.value, {});
        std::string text = equation.value;
        if (term) {
            text = text_of(*term);
        } else {
            result_.note(equation.line, "surface_equation",
                         filled(tr("read as the language reads it: {0}"), {term.error().reason}));
        }
        if (substituted_) {
            result_.add_definition("surface_1(x, y, z) = " + text, equation.line);
            text = "surface_1(" + coordinates_of(*substituted_) + ")";
        }
        result_.add_row(text + " = 0", equation.line, front);
        if (back && back != front) {
            result_.note(properties_.find("back_material_color")->second.line,
                         "back_material_color", tr("the back has a colour that suits the front's"));
        }
    }

    void add_light() {
        if (const auto background = color("background_color"))
            result_.document.light.background =
                Background{.top = *background, .bottom = *background};
        const double diffuse = number("front_material_diffuse_intensity", 0.8);
        for (int i = 0; i < 8; ++i) {
            const std::string end = "_" + std::to_string(i);
            const bool on = word("light_status" + end) == "ON";
            const auto at = numbers("light_position" + end, 3);
            const auto rgb = color("light_color" + end);
            const double power =
                std::clamp(diffuse * number("light_intensity" + end, 1.0), 0.0, max_power);
            if (!on || !at || power == 0.0) continue;
            const glm::dvec3 towards((*at)[0], (*at)[1], (*at)[2]);
            if (!(glm::length(towards) > 0.0)) continue;
            if (result_.document.light.lights.size() == max_lights) {
                result_.note(0, "light" + end, tr("there are four lights at most; it is left out"));
                continue;
            }
            result_.document.light.lights.push_back(
                {.towards = towards,
                 .with_camera = true,
                 .color = light_of_color(rgb.value_or(0xFFFFFF)),
                 .power = power});
        }
    }

    void note_the_rest() {
        for (const auto& [key, property] : properties_) {
            if (!used_.contains(key)) result_.note(property.line, key, tr("not taken over"));
        }
    }

    Properties properties_;
    std::set<std::string, std::less<>> used_;
    std::optional<Placement> substituted_;
    ImportedDocument result_{.name = {}};
};

}  // namespace

ReadImport read_jsurf(std::string_view text) {
    Properties properties = PropertyReader(text).run();
    const auto equation = properties.find("surface_equation");
    if (equation == properties.end())
        return import_error(0, tr("it has no surface_equation, as a file of SURFER has"));
    const Property found = equation->second;
    Imported imported;
    imported.documents.push_back(JsurfReader(std::move(properties)).run(found));
    return imported;
}

}  // namespace zeroset
