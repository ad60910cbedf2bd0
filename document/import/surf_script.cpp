#include "document/import/foreign_formula.hpp"
#include "document/import/names.hpp"
#include "document/import/readers.hpp"
#include "document/import/surf_view.hpp"
#include "engine/base/translation.hpp"
#include "engine/image/gamma.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numbers>

// Scripts of surf (surf.sourceforge.net, version 1.0): assignments to variables of its own and of
// the script, and commands. A minus binds more than ^ there, and ^ counts from the left.

namespace zeroset {
namespace {

constexpr Dialect surf_dialect{
    .minus_before_power = true, .power_from_left = true, .equals_is_condition = false};

/// A polynomial of the script, as a function of the document.
struct Polynomial {
    std::string row;  ///< its definition
    std::size_t line;
    std::vector<std::string> uses;  ///< other polynomials in it
    std::string function = {};      ///< of a surface that others go on from: what the row calls
    std::size_t order = 0;          ///< greater than that of each of those that it uses
};

class SurfReader {
public:
    explicit SurfReader(std::string_view text) : tokens_(script_tokens(text)) {}

    ReadImport run() {
        while (!tokens_.at_end() && steps_++ < most_steps)
            statement();
        if (imported_.documents.empty() && terms_.contains("surface")) {
            imported_.notes.push_back(
                {.reason = tr("it has no draw_surface; its surface is drawn")});
            draw(0);
        }
        if (imported_.documents.empty()) return nothing_drawn();
        return std::move(imported_);
    }

private:
    static constexpr std::size_t most_steps = 1'000'000;

    /// Why there is no surface.
    [[nodiscard]] ReadImport nothing_drawn() const {
        if (saw_curve_ && !saw_draw_)
            return import_error(0, tr("it draws plane curves only, no surface"));
        if (lost_) return import_error(lost_->line, lost_->entry + ": " + lost_->reason);
        return import_error(0, saw_draw_ ? tr("no surface has been named before")
                                         : tr("it has no draw_surface, as a script of surf has"));
    }

    /// Notes that a value is left out.
    void lose(std::size_t line, std::string_view entry, std::string reason) {
        note(line, entry, std::move(reason));
        if (!lost_) lost_ = notes_.back();
    }

    void note(std::size_t line, std::string_view entry, std::string reason) {
        ImportNote added{.line = line, .entry = std::string(entry), .reason = std::move(reason)};
        notes_.push_back(std::move(added));
    }

    void skip_statement() {
        while (!tokens_.at_end() && !tokens_.take_sign(";"))
            tokens_.next();
    }

    void statement() {
        if (tokens_.take_sign(";")) return;
        const ScriptToken word = tokens_.peek();
        if (word.kind != ScriptKind::Name) {
            note(word.line, word.text.substr(0, 20), tr("no statement of surf; it is left out"));
            return skip_statement();
        }
        if (word.text == "if") {
            note(word.line, "if", tr("nothing is repeated: a loop is gone through once"));
            return skip_statement();
        }
        tokens_.next();
        if (tokens_.take_sign(":")) return;
        const bool declares = is_type(word.text) && tokens_.peek().kind == ScriptKind::Name;
        const std::string name(declares ? tokens_.next().text : word.text);
        if (tokens_.take_sign("=")) {
            assign(name, word.text == "string", word.line);
        } else if (!declares) {
            command(name, word.line);
        }
        skip_statement();
    }

    static bool is_type(std::string_view word) {
        return word == "int" || word == "double" || word == "string" || word.starts_with("poly");
    }

    void assign(const std::string& name, bool is_text, std::size_t line) {
        if (is_text || name == "filename" || tokens_.peek().kind == ScriptKind::Text) return;
        auto term = read_term(tokens_, surf_dialect);
        if (!term || !tokens_.at_sign(";")) {
            const std::string reason = term ? filled(tr("'{0}' does not continue the formula"),
                                                     {tokens_.peek().text.substr(0, 20)})
                                            : term.error().reason;
            lose(line, name, filled(tr("{0}; it is left out"), {reason}));
            return;
        }
        if (const auto value = number_of(*term)) {
            numbers_[name] = *value;
            polynomials_of_.erase(name);
            if (is_surface(name))
                assign_polynomial(name, number_term(*value, line), line);
            else if (view_.knows(name))
                set_lines_[name] = line;
            else if (surf_draws_with(name))
                note_setting(name, line);
        } else {
            assign_polynomial(name, std::move(*term), line);
        }
    }

    void note_setting(const std::string& name, std::size_t line) {
        note(line, name, tr("not taken over"));
    }

    static bool is_surface(std::string_view name) {
        return name.starts_with("surface") &&
               (name.size() == 7 || (name.size() == 8 && name[7] >= '2' && name[7] <= '9'));
    }

    [[nodiscard]] std::optional<double> number_of(const ForeignTerm& term) const {
        return value_of(term, [this](std::string_view name) { return constant(name); });
    }

    [[nodiscard]] std::optional<double> constant(std::string_view name) const {
        const auto found = numbers_.find(name);
        if (found != numbers_.end()) return found->second;
        return surf_constant(name);
    }

    /// The polynomial with numbers in place of names, and calls in place of other polynomials;
    /// nothing, with a note, where it cannot be written.
    std::optional<Polynomial> translated(ForeignTerm term, std::size_t line,
                                         const std::string& name) {
        Polynomial result{.row = {}, .line = line, .uses = {}};
        std::string wrong;
        for_each_part(term, [&](ForeignTerm& part) {
            if (part.kind == TermKind::Name) translate_name(part, result, wrong);
            if (part.kind == TermKind::Call) translate_call(part, result, wrong);
        });
        if (!wrong.empty()) {
            lose(line, name, filled(tr("{0} is not known; it is left out"), {wrong}));
            return std::nullopt;
        }
        result.row = text_of(term);
        return result;
    }

    void translate_name(ForeignTerm& part, Polynomial& result, std::string& wrong) {
        if (part.text == "x" || part.text == "y" || part.text == "z") return;
        const auto found = polynomials_of_.find(part.text);
        if (found != polynomials_of_.end()) {
            result.uses.push_back(found->second);
            part.text = found->second + "(x, y, z)";
        } else if (terms_.contains(part.text)) {
            part.text = function_of_surface(part.text, result) + "(x, y, z)";
        } else if (const auto value = constant(part.text)) {
            part = number_term(*value, part.line);
        } else if (!part.text.ends_with("Axis")) {
            wrong = part.text;
        }
    }

    /// The function that is what a surface is so far: a script may go on from it.
    std::string function_of_surface(const std::string& name, Polynomial& result) {
        Polynomial& surface = terms_.at(name);
        if (surface.function.empty()) {
            const std::string function = names_.fresh(name + "_before");
            define(function, surface);
            surface = {.row = function + "(x, y, z)",
                       .line = surface.line,
                       .uses = {function},
                       .function = function};
        }
        result.uses.push_back(surface.function);
        return surface.function;
    }

    /// Adds the function with the polynomial's row as its formula.
    void define(const std::string& function, Polynomial polynomial) {
        polynomial.row.insert(0, function + "(x, y, z) = ");
        polynomial.order = polynomials_.size();
        polynomials_[function] = std::move(polynomial);
    }

    void translate_call(ForeignTerm& part, Polynomial& result, std::string& wrong) {
        if (const auto value = number_of(part)) {
            part = number_term(*value, part.line);
            return;
        }
        if (part.text != "rotate" || part.operands.size() != 3) {
            wrong = part.text + "()";
            return;
        }
        const auto angle = number_of(part.operands[1]);
        const std::string& axis = part.operands[2].text;
        const bool is_axis =
            axis.size() == 5 && axis.ends_with("Axis") && axis[0] >= 'x' && axis[0] <= 'z';
        if (!angle || !is_axis) {
            wrong = "rotate()";
            return;
        }
        const std::string turned = names_.fresh("part");
        define(turned, {.row = text_of(part.operands[0]), .line = part.line, .uses = result.uses});
        result.uses.push_back(turned);
        const auto back = surf_turning(axis[0] - 'x', *angle).inverse();
        part = {.kind = TermKind::Name,
                .text = turned + "(" + coordinates_of(back.value_or(Placement{})) + ")",
                .line = part.line};
    }

    void assign_polynomial(const std::string& name, ForeignTerm term, std::size_t line) {
        if (name == "curve") saw_curve_ = true;
        auto polynomial = translated(std::move(term), line, name);
        if (!polynomial) return;
        if (is_surface(name)) {
            terms_[name] = *polynomial;
            return;
        }
        numbers_.erase(name);
        const std::string function = names_.fresh(name);
        define(function, std::move(*polynomial));
        polynomials_of_[name] = function;
    }

    void command(const std::string& name, std::size_t line) {
        if (name == "draw_surface") return draw(line);
        if (name == "draw_curve") saw_curve_ = true;
        if (surf_only_sets(name)) return;
        if (name.starts_with("save_") || name.starts_with("dither_") || name == "clear_pixmap")
            return;
        note(line, name, tr("not taken over"));
    }

    [[nodiscard]] double setting(const std::string& name, double otherwise) const {
        const auto value = constant(name);
        return value && std::abs(*value) <= largest_number ? *value : otherwise;
    }

    [[nodiscard]] std::uint32_t color(const std::string& stem, std::uint32_t usual) const {
        const auto channel = [&](const char* which, unsigned shift) {
            return setting(stem + which, (usual >> shift) & 0xFFU) / 255.0;
        };
        return shown_color(channel("_red", 16U), channel("_green", 8U), channel("_blue", 0U));
    }

    /// Rows of the polynomials that a surface needs, each once, those first that others need.
    void add_polynomials(ImportedDocument& drawn, const std::vector<std::string>& uses,
                         std::set<std::string>& done) {
        std::vector<std::string> needed;
        std::vector<std::string> open = uses;
        std::set<std::string> seen;
        while (!open.empty()) {
            const std::string name = open.back();
            open.pop_back();
            if (done.contains(name) || !seen.insert(name).second) continue;
            needed.push_back(name);
            const auto& inner = polynomials_.at(name).uses;
            open.insert(open.end(), inner.begin(), inner.end());
        }
        std::ranges::sort(needed, {},
                          [this](const std::string& name) { return polynomials_.at(name).order; });
        for (const std::string& name : needed) {
            drawn.add_definition(polynomials_.at(name).row, polynomials_.at(name).line);
            done.insert(name);
        }
    }

    void draw(std::size_t line) {
        saw_draw_ = true;
        if (terms_.empty())
            return note(line, "draw_surface", tr("no surface has been named before"));
        if (imported_.documents.size() == most_imported) return;
        ImportedDocument drawn{.name = {}};
        drawn.notes = notes_;
        const SurfView view = view_.of(
            [this](const std::string& name, double otherwise) { return setting(name, otherwise); });
        apply(view, drawn, set_lines_);
        std::set<std::string> done;
        for (const auto& [name, polynomial] : terms_) {
            const std::string number = name.substr(7);
            add_polynomials(drawn, polynomial.uses, done);
            std::string text = polynomial.row;
            if (view.substituted) {
                const std::string function =
                    names_.fresh("surface_" + (number.empty() ? "1" : number));
                drawn.add_definition(function + "(x, y, z) = " + text, polynomial.line);
                text = function + "(" + coordinates_of(*view.substituted) + ")";
            }
            const auto front = color("surface" + number, 0x7B68EE);
            Statement& row = drawn.add_row(text + " = 0", polynomial.line, front);
            const double transparence =
                setting("transparence" + number, setting("transparency" + number, 0.0));
            if (transparence > 0.0) row.opacity = std::clamp(1.0 - transparence / 100.0, 0.0, 1.0);
            if (row.opacity == 0.0) row.visible = false;
            if (color("inside" + number, 0xE6B41E) != front) {
                drawn.note(polynomial.line, "inside" + number,
                           tr("the back has a colour that suits the front's"));
            }
        }
        add_light(drawn);
        drawn.tells_box = true;
        if (imported_.documents.empty() || imported_.documents.back().document != drawn.document)
            imported_.documents.push_back(std::move(drawn));
    }

    void add_light(ImportedDocument& drawn) {
        if (constant("background_red") || constant("background_green") ||
            constant("background_blue")) {
            const auto background = color("background", 0);
            drawn.document.light.background = Background{.top = background, .bottom = background};
        }
        const double diffuse = setting("diffuse", 60.0) / 100.0;
        bool given = false;
        std::vector<Light> lights;
        for (int i = 1; i <= 9; ++i) {
            const std::string stem = "light" + std::to_string(i);
            given = given || numbers_.contains(stem + "_x") || numbers_.contains(stem + "_vol");
            const double power = diffuse * setting(stem + "_vol", i == 1 ? 50.0 : 0.0) / 100.0;
            const glm::dvec3 towards(setting(stem + "_x", i == 1 ? -100.0 : 0.0),
                                     setting(stem + "_y", 100.0), setting(stem + "_z", 100.0));
            if (!(power > 0.0) || !(glm::length(towards) > 0.0)) continue;
            if (lights.size() == max_lights) {
                drawn.note(0, stem, tr("there are four lights at most; it is left out"));
                continue;
            }
            lights.push_back({.towards = towards,
                              .with_camera = true,
                              .color = light_of_color(color(stem, 0xFFFFFF)),
                              .power = std::min(power, max_power)});
        }
        if (given) drawn.document.light.lights = std::move(lights);
    }

    TokenReader tokens_;
    std::size_t steps_ = 0;
    bool saw_curve_ = false;
    bool saw_draw_ = false;
    std::optional<ImportNote> lost_;  ///< the first value that is left out
    ImportedNames names_;
    SurfViewNames view_;
    std::map<std::string, double, std::less<>> numbers_;
    std::map<std::string, std::size_t> set_lines_;
    std::map<std::string, std::string, std::less<>> polynomials_of_;  ///< functions by names
    std::map<std::string, Polynomial> polynomials_;                   ///< by functions
    std::map<std::string, Polynomial> terms_;                         ///< surface, surface2, ...
    std::vector<ImportNote> notes_;
    Imported imported_;
};

}  // namespace

ReadImport read_surf_script(std::string_view text) { return SurfReader(text).run(); }

}  // namespace zeroset
