// No text of the window is cut or written over another one: in all states, in all languages, from
// the smallest window to a large one, at scales between 1 and 3.

#include "tests/ui/cut_text.hpp"

#include "engine/annotate/legend.hpp"
#include "engine/base/translation.hpp"
#include "engine/language/help.hpp"
#include "engine/render/tracers.hpp"
#include "pipeline/gallery.hpp"
#include "pipeline/plans/export_formats.hpp"
#include "tests/ui/panels.hpp"
#include "ui/actions/actions.hpp"
#include "ui/pages/pages_drawn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace zeroset::ui::cut_text_test {
namespace {

/// Something that the window shows.
struct Scene {
    const char* name;
    std::function<void(UiState&)> set;
};

void run(UiState& state, const char* action) { action_named(action).run(state); }

void show_legend(UiState& state) {
    Coloring coloring;
    coloring.by = ColorBy::MeanCurvature;
    coloring.map = ColorMap::Balance;
    coloring.range = ValueRange{-2, 2};
    state.edited.document.coloring = {ColorBy::MeanCurvature, "", ColorMap::Balance,
                                      ValueRange{-2, 2}};
    state.shown.picture.legend = legend_of(coloring, "");
}

void point_at_surface(UiState& state) {
    PointedFacts pointed;
    pointed.row = 1;
    pointed.pixel_size = 0.01;
    pointed.facts.point = {0.512345678, -0.2512345678, 0.7512345678};
    pointed.facts.distance = 8.125;
    pointed.facts.normal = {0.0, 0.6, 0.8};
    pointed.facts.certificate = Certificate::Certified;
    state.shown.pointed = pointed;
}

void export_page(UiState& state, ExportKind kind) {
    state.pages.exports.open = true;
    state.pages.exports.wish.kind = kind;
    state.shown.export_target = "/home/someone/Pictures/surface-with-a-long-name-2.png";
    state.shown.export_preview.doing = tr("preparing…");
}

std::vector<Scene> sections() {
    return {
        {"rows", [](UiState&) {}},
        {"rows with errors",
         [](UiState& state) {
             set_rows(state, {"x^2 + = 1", "sinn(x) + y = z", "1/0 = x", "x^2 + y^2 < 1 and",
                              "a very long row of words that nobody can read = 0 + x + y + z + x"});
         }},
        {"view", [](UiState& state) { state.edited.layout.view_open = true; }},
        {"camera",
         [](UiState& state) {
             state.edited.layout.camera_open = true;
             state.edited.document.views = {
                 {.name = "A name of a view", .camera = *state.edited.document.camera}};
         }},
        {"look",
         [](UiState& state) {
             state.edited.layout.look_open = true;
             show_legend(state);
         }},
        {"light", [](UiState& state) { state.edited.layout.light_open = true; }},
        {"markers",
         [](UiState& state) {
             state.edited.layout.markers_open = true;
             state.edited.document.markers = {{1, {0.5, 0.25, 0.75}}, {2, {-1.0, 0.0, 0.5}}};
             state.edited.selected_marker = 2;
             point_at_surface(state);
         }},
        {"space", [](UiState& state) { state.edited.layout.space_open = true; }},
        {"clip",
         [](UiState& state) {
             state.edited.layout.clip_open = true;
             state.edited.layout.edges_open = true;
             state.edited.document.region.ball = Ball{{0.0, 0.0, 0.0}, 1.5};
             state.edited.document.region.sections = {make_section({1.0, 0.0, 0.0}, 0.25)};
             state.edited.document.region.sections.front().values = true;
         }},
        {"details",
         [](UiState& state) {
             state.edited.layout.details_open = true;
             point_at_surface(state);
         }},
        {"advanced",
         [](UiState& state) {
             state.edited.layout.advanced_open = true;
             state.edited.inspection.costs = true;
         }},
        {"two tracers",
         [](UiState& state) {
             state.edited.layout.advanced_open = true;
             state.edited.inspection.other = "octree-unrounded";
             state.edited.inspection.difference = true;
             state.shown.other.tracer = "octree-unrounded";
             state.shown.other.complete = true;
             state.shown.other.frame_ms = 1234.5;
             state.shown.other.reference = Reference::First;
             state.shown.other.wrong = WrongPixels{.missed = 12, .added = 345, .moved = 6789};
         }},
        {"a volume",
         [](UiState& state) {
             state.shown.reading.parameters = {"a"};
             state.shown.reading.histograms["a"] = std::make_shared<const Histogram>(
                 Histogram{.first = -5.0, .width = 1.0, .counts = {1, 200, 30, 4, 0, 6, 7, 800}});
         }},
    };
}

std::vector<Scene> pages() {
    std::vector<Scene> all{
        {"gallery", [](UiState& state) { run(state, "Gallery"); }},
        {"commands", [](UiState& state) { state.pages.commands.open = true; }},
        {"help", [](UiState& state) { state.pages.help.open = true; }},
        {"picture", [](UiState& state) { export_page(state, ExportKind::Picture); }},
        {"film", [](UiState& state) { export_page(state, ExportKind::Film); }},
        {"mesh", [](UiState& state) { export_page(state, ExportKind::Mesh); }},
        {"drawing", [](UiState& state) { export_page(state, ExportKind::Drawing); }},
        {"question",
         [](UiState& state) {
             state.pages.dialogs.question =
                 Question{filled(tr("Save the changes to {0}?"), {state.shown.document.name}),
                          {tr("Save"), tr("Don't save"), tr("Cancel")},
                          {}};
         }},
        {"file",
         [](UiState& state) {
             FileChoice choice;
             choice.title = tr("Save as");
             choice.folder = "/";
             state.pages.dialogs.file = choice;
         }},
        {"a film being saved",
         [](UiState& state) {
             export_page(state, ExportKind::Film);
             state.shown.export_progress = {
                 .name = "a-film-with-a-long-name.mp4",
                 .share = 0.4,
                 .text = filled(tr("frame {0} of {1}, {2} s"), {"1072", "1800", "35"})};
         }},
        {"what was open",
         [](UiState& state) {
             const std::string question =
                 tr("Zeroset ended without being closed. Restore what was open?\n\n{0}");
             state.pages.dialogs.question =
                 Question{filled(question, {"x^2 + y^2 + z^2 = 1\nsin(x) + sin(y) + sin(z) = a"}),
                          {tr("Restore"), tr("Discard")},
                          {}};
         }},
        {"commands that are found",
         [](UiState& state) {
             state.pages.commands.open = true;
             state.pages.commands.typed = "e";
         }},
        {"presentation",
         [](UiState& state) {
             set_rows(state, {"x^2 + y^2 = a z^2 + long_name"});
             state.edited.layout.presents = true;
         }},
        {"nothing typed", [](UiState& state) { set_rows(state, {""}); }},
        {"all hidden",
         [](UiState& state) {
             state.edited.document.statements.front().visible = false;
             state.shown.figures.counts = {};
         }},
        {"out of view", [](UiState& state) { state.shown.figures.counts = {}; }},
        {"busy",
         [](UiState& state) {
             state.shown.picture.tracing = true;
             state.shown.status.doing = filled(tr("compiling… ({0} nodes)"), {"123456"});
             state.shown.status.note =
                 filled(tr("no singular point and no maximum or minimum of {0} found near {1}"),
                        {"z", "A"});
         }},
    };
    for (std::size_t step = 0; step < tour_steps; ++step)
        all.push_back({"tour", [step](UiState& state) { state.pages.tour.step = step; }});
    return all;
}

class CutText : public Panels {
protected:
    ~CutText() override { set_language(Language::English); }

    UiState fresh() {
        UiState state = usual_state(GetParam().theme);
        set_rows(state, {"a = 0.7", "x^2 + y^2 = a z^2 + w"});
        state.shown.reading.uses_w = true;
        state.edited.layout.view_open = false;
        state.shown.gallery.clear();
        for (const GalleryItem& item : gallery())
            state.shown.gallery.push_back({.title = item.title,
                                           .equation = item.equation,
                                           .about = item.about,
                                           .group = item.group,
                                           .source = item.source});
        for (const Tracer& tracer : tracers())
            state.shown.tracers.push_back({.name = std::string(tracer.name),
                                           .about = std::string(tracer.about),
                                           .finds_jumps = true});
        state.shown.language_help = language_help();
        state.shown.export_formats = {export_formats().begin(), export_formats().end()};
        state.shown.document.name = "a-document-with-a-long-name";
        state.shown.document.unsaved = true;
        return state;
    }

    /// A frame that only has to be laid out.
    void lay_out() {
        window_->begin_frame(state_.edited.theme);
        draw_screen(state_, *picture_);
        ImGui::Render();
    }

    void settle() {
        for (int i = 0; i <= frames_to_settle + 2; ++i)
            lay_out();
    }

    /// Scrolls what can be scrolled of the side panel page by page, and looks at each.
    void look_through(const std::string& what) {
        settle();
        report(what);
        for (int page = 1; page < 20; ++page) {
            bool moved = false;
            for (ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
                if (!window->WasActive || window->Scroll.y >= window->ScrollMax.y) continue;
                ImGui::SetScrollY(window, std::min(window->Scroll.y + 0.8F * window->Size.y,
                                                   window->ScrollMax.y));
                moved = true;
            }
            if (!moved) return;
            lay_out();
            lay_out();
            report(what);
        }
    }

    void report(const std::string& what) {
        for (const std::string& line : cut_texts()) {
            // Typed text scrolls in its field: a camera's three numbers are longer than some.
            if (!line.contains("/##camera_")) found_.emplace(line, what);
        }
        // The sections' heights are known before they are drawn; only all of them together scroll.
        for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
            const std::string name = window->Name;
            const bool is_section = name.starts_with("##side/##list_") &&
                                    std::ranges::count(name, '/') == 2 &&
                                    !name.contains("/##equation_");
            if (window->WasActive && is_section && window->ScrollMax.y > 1.0F)
                found_.emplace(name + " is too low for what is in it", what);
        }
    }

    std::map<std::string, std::string> found_;  ///< where it was seen first, by text
};

TEST_P(CutText, IsNowhere) {
    std::vector<Scene> scenes = sections();
    std::ranges::move(pages(), std::back_inserter(scenes));
    for (const Language language : all_languages) {
        set_language(language, language == Language::English ? '.' : ',');
        for (const Scene& scene : scenes) {
            state_ = fresh();
            settle();
            scene.set(state_);
            look_through(std::string(scene.name) + ", " + std::string(name_of(language)));
        }
    }
    for (const auto& [text, scene] : found_)
        ADD_FAILURE() << scene << ": " << text;
}

INSTANTIATE_TEST_SUITE_P(
    Looks, CutText,
    testing::Values(Look{Theme::Dark, {min_width, min_height, 1.0F}},
                    Look{Theme::Light, {min_width, min_height, 2.0F}},
                    Look{Theme::Light, {640, 480, 1.0F}}, Look{Theme::Dark, {640, 480, 1.5F}},
                    Look{Theme::Light, {1280, 800, 1.0F}}, Look{Theme::Dark, {1280, 800, 1.5F}},
                    Look{Theme::Light, {1920, 1080, 2.0F}}, Look{Theme::Dark, {3840, 2160, 1.0F}}),
    [](const auto& looks) {
        const OffscreenOptions& window = looks.param.window;
        return std::to_string(window.width) + "_at_" +
               std::to_string(std::lround(10.0F * window.scale));
    });

}  // namespace
}  // namespace zeroset::ui::cut_text_test
