#include "document/import/pov_camera.hpp"
#include "document/import/pov_container.hpp"
#include "document/import/pov_formulas.hpp"
#include "document/import/pov_modifiers.hpp"
#include "document/import/pov_script.hpp"
#include "document/import/readers.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

// Scenes of POV-Ray 3.7: their isosurfaces. POV-Ray's axes are left-handed, y is up and z leads
// into the picture: (x, y, z) there is (x, z, y) here, where z is up (but PovAxes). f below the
// threshold is inside, and what is not open is closed by its container.

namespace zeroset {
namespace {

/// An isosurface or a parametric surface in its own coordinates, and where it stands.
struct PovSurface {
    std::vector<std::string> functions;    ///< one of (x, y, z), or three of (u, v)
    std::vector<glm::dvec3> corners = {};  ///< of (u, v): the least and the greatest
    PovContainer container;
    double threshold = 0.0;
    bool open = false;
    Placement placement;
    PovLook look;
    std::size_t line = 0;
};

constexpr int deepest_group = 60;
constexpr std::size_t most_surfaces = 90;

class SceneReader {
public:
    SceneReader(std::string_view text, const ImportFiles& files)
        : script_(text), formulas_(script_, modifiers_, result_) {
        script_.on_note = [this](std::size_t line, std::string_view entry, std::string reason) {
            result_.note(line, entry, std::move(reason));
            if (!missed_ && entry.starts_with("#include")) missed_ = result_.notes.back();
        };
        script_.on_include = files.text_beside;
        script_.on_declare = [this](const std::string& name) { return declare(name); };
    }

    ReadImport run() {
        while (script_.peek().kind != ScriptKind::End)
            item(shown_);
        if (shown_.empty()) show_declared();
        if (shown_.empty()) return nothing_shown();
        add_rows();
        note_axes();
        for (ImportNote& note : result_.notes)
            tell_file(note.line, note.entry);
        for (std::size_t& line : result_.row_lines)
            line = line_of_scene(script_.file_line(line));
        Imported imported;
        imported.documents.push_back(std::move(result_));
        return imported;
    }

private:
    using Surfaces = std::vector<PovSurface>;

    /// Why the scene shows nothing: the first surface that is left out, else that there is none,
    /// with the first file that is not read, which may have it.
    ReadImport nothing_shown() {
        if (lost_) {
            tell_file(lost_->line, lost_->entry);
            return import_error(lost_->line, lost_->entry + ": " + lost_->reason);
        }
        std::string reason =
            tr("it shows no isosurface or parametric surface, which is what is read of scenes of "
               "POV-Ray");
        if (missed_) {
            tell_file(missed_->line, missed_->entry);
            reason += "; " + missed_->entry + ": " + missed_->reason;
        }
        return import_error(0, reason);
    }

    /// Adds surfaces, but none beyond one more than are drawn.
    static void append(Surfaces& to, const Surfaces& more) {
        for (const PovSurface& surface : more) {
            if (to.size() <= most_surfaces) to.push_back(surface);
        }
    }

    /// Shows the last object that is declared, where the scene itself shows nothing: files of
    /// POV-Ray's that others include are so.
    void show_declared() {
        const auto found = objects_.find(last_declared_);
        if (found == objects_.end()) return;
        shown_ = found->second;
        result_.note(0, last_declared_,
                     tr("the file shows nothing; this, which it declares, is drawn"));
    }

    /// The line of the scene itself, in which another file is included.
    static std::size_t line_of_scene(const PovScript::FileLine& place) {
        return place.file.empty() ? place.line : place.included_at;
    }
    /// Names the file of an included line, and takes the line that includes it.
    void tell_file(std::size_t& line, std::string& entry) const {
        const PovScript::FileLine place = script_.file_line(line);
        line = line_of_scene(place);
        if (place.file.empty()) return;
        entry = place.file + ":" + std::to_string(place.line) + (entry.empty() ? "" : ": ") + entry;
    }

    [[nodiscard]] PovAxes axes() const { return camera_ ? camera_->axes : PovAxes::LeftHanded; }

    void note_axes() {
        if (axes() == PovAxes::LeftHanded)
            result_.note(
                0, "",
                tr("y is up there and z leads into the picture; here z is up: (x, z, y) in "
                   "the rows"));
        if (axes() == PovAxes::RightHanded)
            result_.note(
                0, "",
                tr("the camera's right makes the scene right-handed; here z is up: (x, -z, "
                   "y) in the rows"));
    }

    /// Reads an item of the scene or of a union, and adds its surfaces.
    void item(Surfaces& surfaces) {
        const ScriptToken word = script_.next();
        if (word.kind != ScriptKind::Name) return;
        if (word.text == "camera") {
            if (const auto camera = read_pov_camera(script_, modifiers_, result_)) camera_ = camera;
            return;
        }
        if (word.text == "background") return background();
        if (!script_.at_sign("{")) return;
        if (auto found = object(word.text, word.line)) {
            append(surfaces, *found);
        } else {
            script_.skip_block();
            if (word.text != "global_settings")
                result_.note(word.line, word.text, tr("not taken over"));
        }
    }

    /// Reads the object behind its word; nothing where it is of another kind.
    std::optional<Surfaces> object(std::string_view word, std::size_t line) {
        static constexpr std::array<std::string_view, 5> groups{"union", "merge", "object",
                                                                "intersection", "difference"};
        if (word == "isosurface" || word == "parametric") return surface(word, line);
        if (std::ranges::find(groups, word) == groups.end() || depth_ >= deepest_group)
            return std::nullopt;
        if (word == "intersection" || word == "difference")
            result_.note(line, word, tr("its parts are drawn whole, not cut by each other"));
        ++depth_;
        Surfaces parts;
        PovLook look;
        Placement placement;
        script_.take_sign("{");
        while (!script_.take_sign("}") && script_.peek().kind != ScriptKind::End) {
            if (modifiers_.read(placement, look)) continue;
            const std::string name(script_.peek().text);
            const auto known = objects_.find(name);
            if (known != objects_.end() && script_.take_name(name)) {
                append(parts, known->second);
            } else {
                item(parts);
            }
        }
        --depth_;
        for (PovSurface& part : parts) {
            part.placement = part.placement.then(placement);
            if (!part.look.color) part.look = look;
        }
        if (parts.size() > most_surfaces) parts.resize(most_surfaces);
        return parts;
    }

    Surfaces surface(std::string_view kind, std::size_t line) {
        const bool parametric = kind == "parametric";
        if (++read_ > 2 * most_surfaces) {
            result_.note(line, kind, tr("the script runs too long; the rest is left out"));
            script_.stop();
            return {};
        }
        PovSurface surface{
            .functions = {}, .container = {}, .placement = {}, .look = {}, .line = line};
        const std::size_t notes = result_.notes.size();
        script_.take_sign("{");
        while (!script_.take_sign("}") && script_.peek().kind != ScriptKind::End) {
            surface_item(surface, parametric);
        }
        const std::size_t corners = surface.corners.size();
        if (surface.functions.size() != (parametric ? 3U : 1U) || (parametric && corners != 2)) {
            result_.note(line, kind, tr("without its function it is left out"));
            if (!lost_ && notes < result_.notes.size()) lost_ = result_.notes[notes];
            return {};
        }
        return {surface};
    }

    void surface_item(PovSurface& surface, bool parametric) {
        if (modifiers_.read(surface.placement, surface.look) || script_.take_sign(",")) return;
        if (parametric && script_.at_sign("<")) {
            if (const auto corner = script_.value()) surface.corners.push_back(vector_of(*corner));
            return;
        }
        const ScriptToken word = script_.next();
        if (word.text == "function") {
            const auto own = parametric ? formulas_.read("", {"u", "v"}) : formulas_.read("");
            if (own) surface.functions.push_back(*own);
        } else if (word.text == "contained_by") {
            surface.container = containers_.read();
        } else if (word.text == "threshold") {
            if (const auto value = modifiers_.number(word)) surface.threshold = *value;
        } else if (word.text == "open") {
            surface.open = true;
        } else if (script_.at_sign("{")) {
            script_.skip_block();
            result_.note(word.line, word.text, tr("not taken over"));
        }
    }

    bool declare(const std::string& name) {
        const ScriptToken word = script_.peek();
        if (word.kind != ScriptKind::Name) return false;
        if (script_.take_name("function")) {
            if (const auto own = formulas_.read(name)) formulas_.define(name, *own);
            return true;
        }
        if (formulas_.find(word.text)) {
            const std::string same(word.text);
            script_.next();
            formulas_.define_as(name, same);
            return true;
        }
        if (modifiers_.declare(name) || containers_.declare(name)) return true;
        if (script_.sign_follows("{")) {
            script_.next();
            auto parts = object(word.text, word.line);
            if (!parts) {
                script_.skip_block();
                return true;
            }
            if (!parts->empty()) last_declared_ = name;
            objects_.insert_or_assign(name, std::move(*parts));
            return true;
        }
        return false;
    }

    void background() {
        if (!script_.take_sign("{")) return;
        PovLook look;
        PovModifiers::take_color(script_.value(), look);
        script_.take_sign("}");
        if (look.color)
            result_.document.light.background =
                Background{.top = *look.color, .bottom = *look.color};
    }

    /// "(x(u, v), y(u, v), z(u, v)), 0 < u < 1, 0 < v < 1", moved to where it is placed.
    static std::string parametric_row(const PovSurface& surface, const Placement& placed) {
        std::string text = "(";
        for (int row = 0; row < 3; ++row) {
            std::string sum;
            for (int part = 0; part < 3; ++part) {
                const double factor = placed.linear[part][row];
                if (factor == 0.0) continue;
                const std::string call =
                    surface.functions[static_cast<std::size_t>(part)] + "(u, v)";
                sum += (sum.empty() ? "" : " + ") +
                       (factor == 1.0 ? call : exact_number(factor, true) + "*" + call);
            }
            if (placed.shift[row] != 0.0 || sum.empty())
                sum += (sum.empty() ? "" : " + ") + exact_number(placed.shift[row], true);
            text += (row > 0 ? ", " : "") + sum;
        }
        const auto range = [&surface](int axis, const char* letter) {
            return ", " + exact_number(surface.corners[0][axis]) + " < " + letter + " < " +
                   exact_number(surface.corners[1][axis]);
        };
        return text + ")" + range(0, "u") + range(1, "v");
    }

    /// A surface whose back can be seen has one colour there, and another one here.
    void note_back(const PovSurface& surface) {
        if (surface.look.color)
            result_.note(surface.line, "pigment",
                         tr("the back has a colour that suits the front's"));
    }

    /// Adds the rows of a surface and returns the box that it is in.
    std::optional<Box> add_surface(const PovSurface& surface) {
        const Placement placed = surface.placement.then(placement_of(axes()));
        if (surface.functions.size() == 3) {
            const Box box = box_of(surface.container, placed);
            Statement& row =
                result_.add_row(parametric_row(surface, placed), surface.line, surface.look.color);
            row.opacity = surface.look.opacity;
            // A flat container has nothing in it.
            const glm::dvec3 size = box.hi - box.lo;
            if (std::min({size.x, size.y, size.z}) > 0.0) row.box = box;
            note_back(surface);
            return box;
        }
        const auto back = placed.inverse();
        if (!back) {
            result_.note(surface.line, "isosurface", tr("it is scaled to nothing; it is left out"));
            return std::nullopt;
        }
        const std::string coordinates = "(" + coordinates_of(*back) + ")";
        const std::string limits = inside_formula(surface.container);
        std::string text;
        if (surface.open) {
            note_back(surface);
            const std::string container = surface.container.ball ? limits : "max(" + limits + ")";
            text = surface.functions[0] + coordinates + " = " + exact_number(surface.threshold);
            text +=
                ", " + formulas_.add("container", container, surface.line) + coordinates + " < 0";
        } else {
            std::string f = surface.functions[0] + "(x, y, z)";
            if (surface.threshold != 0.0)
                f += (surface.threshold < 0.0 ? " + " : " - ") +
                     exact_number(std::abs(surface.threshold));
            text = formulas_.add("solid", "max(" + f + ", " + limits + ")", surface.line) +
                   coordinates + " = 0";
        }
        result_.add_row(text, surface.line, surface.look.color).opacity = surface.look.opacity;
        return box_of(surface.container, placed);
    }

    void add_rows() {
        std::optional<Box> all;
        if (shown_.size() > most_surfaces) {
            result_.note(
                shown_[most_surfaces].line, "isosurface",
                filled(tr("only the first {0} are drawn"), {std::to_string(most_surfaces)}));
            shown_.resize(most_surfaces);
        }
        for (const PovSurface& surface : shown_) {
            const auto box = add_surface(surface);
            if (!box) continue;
            if (!all) all = box;
            all->lo = glm::min(all->lo, box->lo);
            all->hi = glm::max(all->hi, box->hi);
        }
        const bool usable = all && all->size() > 0.0 && all->size() < largest_number &&
                            glm::length(all->lo) < largest_number;
        if (usable) {
            // The containers' walls are surfaces, too, and must not lie in the box's.
            result_.document.clip = scaled(*all, 1.02);
            result_.tells_box = true;
            if (camera_) result_.document.camera = result_.document.home = camera_->camera;
        }
    }

    ImportedDocument result_{.name = {}};
    PovScript script_;
    PovModifiers modifiers_{script_, result_};
    PovContainers containers_{script_, modifiers_, result_};
    PovFormulas formulas_;
    Surfaces shown_;
    std::map<std::string, Surfaces, std::less<>> objects_;
    std::optional<PovCamera> camera_;
    std::optional<ImportNote> lost_;    ///< why the first surface that is left out is so
    std::optional<ImportNote> missed_;  ///< the first file that is not read
    std::string last_declared_;         ///< the last name of surfaces
    std::size_t read_ = 0;
    int depth_ = 0;
};

}  // namespace

ReadImport read_pov(std::string_view text, const ImportFiles& files) {
    return SceneReader(text, files).run();
}

}  // namespace zeroset
