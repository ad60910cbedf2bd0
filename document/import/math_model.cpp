#include "document/import/math_model.hpp"

#include "document/import/foreign_formula.hpp"
#include "document/import/names.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace zeroset {
namespace {

/// A definition "name=formula", cut at the first =.
struct Definition {
    std::string_view name, formula;
};

std::optional<Definition> definition_of(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) return std::nullopt;
    const Definition result{.name = trimmed(text.substr(0, equals)),
                            .formula = trimmed(text.substr(equals + 1))};
    const auto tokens = script_tokens(result.name);
    if (tokens.size() != 2 || tokens[0].kind != ScriptKind::Name) return std::nullopt;
    return result;
}

/// a % b as fmod(a, b).
ForeignTerm without_remainders(ForeignTerm chain) {
    ForeignTerm result = std::move(chain.operands[0]);
    const std::size_t line = chain.line;
    for (std::size_t i = 1; i < chain.operands.size(); ++i) {
        std::vector<ForeignTerm> both;
        both.push_back(std::move(result));
        both.push_back(std::move(chain.operands[i]));
        if (chain.signs[i] == "%") {
            result = call_of("fmod", std::move(both), line);
        } else {
            result = {.kind = TermKind::Chain,
                      .operands = std::move(both),
                      .signs = {"", chain.signs[i]},
                      .line = line};
        }
    }
    return result;
}

class ModelReader {
public:
    explicit ModelReader(const MathModel& model) : model_(model) {
        result_.name = model.name;
        const bool implicit = model.kind == "Iso3D";
        variables_ = implicit ? std::vector<std::string>{"x", "y", "z", "t"}
                              : std::vector<std::string>{"u", "v", "t"};
    }

    ImportedDocument run() {
        if (model_.kind != "Iso3D" && model_.kind != "Param3D") {
            refuse_kind();
            return std::move(result_);
        }
        add_sliders();
        add_constants();
        add_variables();
        add_functions();
        if (model_.kind == "Iso3D")
            add_implicit();
        else
            add_parametric();
        note_the_rest();
        return std::move(result_);
    }

private:
    void note(const std::string& field, std::size_t index, std::string reason) {
        const bool one = model_.texts(field).size() < 2;
        const auto own = model_.names_in_file.find(field);
        if (own != model_.names_in_file.end())
            return result_.note(model_.line, own->second, std::move(reason));
        result_.note(model_.line,
                     model_.kind + "." + field + (one ? "" : "[" + std::to_string(index) + "]"),
                     std::move(reason));
    }

    void refuse_kind() {
        result_.add_definition("# " + model_.kind + " " + model_.name, model_.line);
        result_.note(model_.line, model_.kind,
                     tr("surfaces of four coordinates and of complex functions are not drawn"));
    }

    /// The name in the language of one of the file, with a note where they differ.
    std::string named(const std::string& field, std::size_t index, std::string_view name) {
        std::string own = names_.fresh(name);
        if (own != name) note(field, index, filled(tr("{0} is called {1}"), {name, own}));
        renamed_.insert_or_assign(std::string(name), own);
        return own;
    }

    void add_sliders() {
        for (const ModelSlider& slider : model_.sliders) {
            values_[slider.name] = slider.value;
            slid_.insert(slider.name);
            if (can_have_slider(slider.name) && slider.lo < slider.hi) {
                names_.fresh(slider.name);
                Slider own{.lo = slider.lo, .hi = slider.hi, .step = std::max(0.0, slider.step)};
                set_value(own, slider.value);
                result_.document.parameters[slider.name] = own;
                renamed_.insert_or_assign(slider.name, slider.name);
                continue;
            }
            const std::string own = named("Sliders", 0, slider.name);
            result_.add_definition(own + " := " + exact_number(slider.value), model_.line);
            result_.note(model_.line, "Sliders." + slider.name,
                         tr("a constant of the text, without a slider"));
        }
    }

    void add_constants() {
        const auto& texts = model_.texts("Const");
        for (std::size_t i = 0; i < texts.size(); ++i) {
            if (trimmed(texts[i]).empty()) continue;
            const auto definition = definition_of(texts[i]);
            if (!definition) {
                note("Const", i, tr("it is no definition; it is left out"));
                continue;
            }
            const std::string name(definition->name);
            if (slid_.contains(name)) continue;
            const std::string formula = translated(definition->formula, "Const", i);
            if (const auto value = value_of_text(definition->formula)) values_[name] = *value;
            const bool again = renamed_.contains(name);
            const std::string own = again ? renamed_[name] : named("Const", i, name);
            result_.add_definition(own + " := " + formula, model_.line);
        }
    }

    /// Varu: a function of u that stands for three variables, its name followed by x, y and z.
    void add_variables() {
        const auto& texts = model_.texts("Varu");
        for (std::size_t i = 0; i < texts.size(); ++i) {
            const auto definition = definition_of(texts[i]);
            if (!definition) {
                if (!trimmed(texts[i]).empty())
                    note("Varu", i, tr("it is no definition; it is left out"));
                continue;
            }
            const std::string formula = translated(definition->formula, "Varu", i, {"u"});
            const std::string stem(definition->name);
            const std::string function = names_.fresh(stem + "_of");
            result_.add_definition(function + "(u) = " + formula, model_.line);
            for (const char* const letter : {"x", "y", "z"}) {
                const std::string own = named("Varu", i, stem + letter);
                result_.add_definition(own + " := " + function + "(" + letter + ")", model_.line);
            }
        }
    }

    void add_functions() {
        const auto& texts = model_.texts("Funct");
        for (std::size_t i = 0; i < texts.size(); ++i) {
            const auto definition = definition_of(texts[i]);
            if (!definition) {
                if (!trimmed(texts[i]).empty())
                    note("Funct", i, tr("it is no definition; it is left out"));
                continue;
            }
            const std::string formula = translated(definition->formula, "Funct", i);
            const std::string own = named("Funct", i, definition->name);
            result_.add_definition(own + "(" + variable_list() + ") = " + formula, model_.line);
        }
    }

    [[nodiscard]] std::string variable_list() const {
        std::string list;
        for (const std::string& variable : variables_)
            list += (list.empty() ? "" : ", ") + variable;
        return list;
    }

    /// The formula for the language. `extra`: variables that only this formula has.
    std::string translated(std::string_view text, const std::string& field, std::size_t index,
                           const std::vector<std::string>& extra = {}) {
        auto term = read_whole_term(text, {});
        if (!term) return std::string(text);
        for_each_part(*term, [&](ForeignTerm& part) {
            const bool is_call = part.kind == TermKind::Call;
            if (is_call && part.text == "int") {
                part.text = "round";
                note(field, index, tr("int() rounds to the nearest integer, as it does there"));
            }
            if (part.kind == TermKind::Chain &&
                std::ranges::find(part.signs, "%") != part.signs.end()) {
                // Each operand is one deeper than the one before it then.
                if (std::ssize(part.operands) <= most_depth)
                    part = without_remainders(std::move(part));
                else
                    note(field, index, tr("too many remainders: a % b is from 0 up to b here"));
            }
            if (part.kind != TermKind::Name && !is_call) return;
            const auto own = renamed_.find(part.text);
            if (own != renamed_.end())
                part.text = own->second;
            else if (part.kind == TermKind::Name && !is_known(part.text, extra))
                note(field, index, filled(tr("{0} is not defined in the file"), {part.text}));
        });
        return text_of(*term);
    }

    [[nodiscard]] bool is_known(std::string_view name,
                                const std::vector<std::string>& extra) const {
        static constexpr std::array<std::string_view, 5> always{"pi", "x", "y", "z", "t"};
        return std::ranges::find(always, name) != always.end() ||
               std::ranges::find(variables_, name) != variables_.end() ||
               std::ranges::find(extra, name) != extra.end();
    }

    [[nodiscard]] std::optional<double> value_of_text(std::string_view text) const {
        const auto term = read_whole_term(text, {});
        if (!term) return std::nullopt;
        const auto value = value_of(*term, [this](std::string_view name) -> std::optional<double> {
            if (name == "pi") return std::numbers::pi;
            const auto found = values_.find(name);
            if (found == values_.end()) return std::nullopt;
            return found->second;
        });
        if (!value || !std::isfinite(*value) || std::abs(*value) > largest_number)
            return std::nullopt;
        return value;
    }

    /// The box of a component; nothing, with a note, where it is none.
    std::optional<Box> box_of(std::size_t component) {
        Box box;
        for (int axis = 0; axis < 3; ++axis) {
            const std::string letter{"XYZ"[axis]};
            const std::size_t last = model_.texts(letter + "min").size();
            const std::size_t at = last == 0 ? 0 : std::min(component, last - 1);
            const auto lo = value_of_text(model_.text(letter + "min", at));
            const auto hi = value_of_text(model_.text(letter + "max", at));
            if (!lo || !hi || !(*lo < *hi)) {
                note(letter + "min", component, tr("the box is not told by two numbers"));
                return std::nullopt;
            }
            box.lo[axis] = *lo;
            box.hi[axis] = *hi;
        }
        return box;
    }

    /// The conditions that keep a component in its box: ", x0 < x < x1" for each axis that needs
    /// it.
    static std::string within(const Box& box, const Box& all) {
        std::string text;
        for (int axis = 0; axis < 3; ++axis) {
            if (box.lo[axis] == all.lo[axis] && box.hi[axis] == all.hi[axis]) continue;
            text += ", " + exact_number(box.lo[axis]) + " < " + "xyz"[axis] + " < " +
                    exact_number(box.hi[axis]);
        }
        return text;
    }

    void add_implicit() {
        const std::size_t count = model_.texts("Fxyz").size();
        std::vector<std::optional<Box>> boxes;
        std::optional<Box> all;
        for (std::size_t i = 0; i < count; ++i) {
            boxes.push_back(box_of(i));
            if (!boxes.back()) continue;
            if (!all) all = boxes.back();
            all->lo = glm::min(all->lo, boxes.back()->lo);
            all->hi = glm::max(all->hi, boxes.back()->hi);
        }
        if (all) result_.document.clip = *all;
        result_.tells_box = all.has_value();
        for (std::size_t i = 0; i < count; ++i) {
            const std::string formula = translated(trimmed(model_.text("Fxyz", i)), "Fxyz", i);
            const std::string limits = boxes[i] && all ? within(*boxes[i], *all) : "";
            const std::string_view condition = trimmed(model_.text("Cnd", i));
            if (condition.empty()) {
                result_.add_row(formula + " = 0" + limits, model_.line);
                continue;
            }
            const std::string part = names_.fresh("part_" + std::to_string(i + 1));
            result_.add_definition(part + "(x, y, z) = " + formula, model_.line);
            const std::string holds = translated(condition, "Cnd", i);
            result_.add_row(part + "(x, y, z) = 0, " + holds + limits, model_.line);
            result_.add_row(part + "(x, y, z) = 0, not (" + holds + ")" + limits, model_.line);
            note("Cnd", i,
                 tr("both parts are drawn, where it holds and where not, a row for each"));
        }
    }

    void add_parametric() {
        const std::size_t count = model_.texts("Fx").size();
        for (std::size_t i = 0; i < count; ++i) {
            std::string row = "(";
            for (const char* const field : {"Fx", "Fy", "Fz"}) {
                if (row.size() > 1) row += ", ";
                row += translated(model_.text(field, i), field, i);
            }
            row += ")";
            for (const char letter : {'U', 'V'}) {
                const std::string field{letter};
                const auto limit = [&](const char* end) {
                    const std::size_t last = model_.texts(field + end).size();
                    const std::size_t at = last == 0 ? 0 : std::min(i, last - 1);
                    return translated(model_.text(field + end, at), field + end, at);
                };
                row += ", " + limit("min") + " < " + (letter == 'U' ? "u" : "v") + " < " +
                       limit("max");
            }
            result_.add_row(row, model_.line);
            if (!trimmed(model_.text("Cnd", i)).empty())
                note("Cnd", i, tr("the whole surface is drawn, where it holds and where not"));
        }
    }

    void note_the_rest() {
        static constexpr std::array<std::string_view, 24> taken{
            "Fxyz", "Const", "Funct", "Varu", "Cnd",  "Name",    "Component",    "Description",
            "Xmin", "Xmax",  "Ymin",  "Ymax", "Zmin", "Zmax",    "Fx",           "Fy",
            "Fz",   "Umin",  "Umax",  "Vmin", "Vmax", "Sliders", "Description ", ""};
        for (const auto& [field, texts] : model_.fields) {
            if (std::ranges::find(taken, field) == taken.end())
                note(field, 0, tr("not taken over"));
        }
    }

    const MathModel& model_;
    std::vector<std::string> variables_;
    ImportedDocument result_{.name = {}};
    ImportedNames names_;
    std::map<std::string, std::string, std::less<>> renamed_;  ///< names here by those of the file
    std::map<std::string, double, std::less<>> values_;
    std::set<std::string, std::less<>> slid_;
};

}  // namespace

const std::vector<std::string>& MathModel::texts(std::string_view field) const {
    static const std::vector<std::string> none;
    const auto found = fields.find(field);
    return found == fields.end() ? none : found->second;
}

std::string_view MathModel::text(std::string_view field, std::size_t component) const {
    const auto& all = texts(field);
    return component < all.size() ? std::string_view(all[component]) : std::string_view{};
}

ImportedDocument document_of(const MathModel& model) { return ModelReader(model).run(); }

}  // namespace zeroset
