#include "document/document.hpp"
#include "engine/base/translation.hpp"
#include "ui/exports/export_parts.hpp"
#include "ui/model/edited.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/number_field.hpp"
#include "ui/widgets/slider_row.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr int largest_film = 16384;
constexpr double longest_s = 3600.0;
constexpr int most_frames = 100'000;

constexpr std::array<const char*, 4> axes{marked("up"), "x", "y", "z"};
constexpr std::array<const char*, 3> ends{marked("stop"), marked("loop"), marked("bounce")};
constexpr std::array<const char*, 2> easings{marked("at an even speed"),
                                             marked("slow at both ends")};

/// Draws a list from which one of `names` is chosen.
template <std::size_t count>
void draw_choice(const char* id, const std::array<const char*, count>& names, std::size_t& chosen) {
    const std::string shown = elided_in_combo(tr(names.at(chosen)));
    const bool open = ImGui::BeginCombo(id, shown.c_str());
    if (shown != tr(names.at(chosen))) draw_tooltip(tr(names.at(chosen)));
    if (!open) return;
    for (std::size_t i = 0; i < count; ++i) {
        if (ImGui::Selectable(tr(names.at(i)), i == chosen)) chosen = i;
    }
    ImGui::EndCombo();
}

/// Draws a list from which an enum's value is chosen; the names are in the order of its values.
template <class Enum, std::size_t count>
void draw_enum(const char* id, const std::array<const char*, count>& names, Enum& value) {
    auto chosen = static_cast<std::size_t>(value);
    draw_choice(id, names, chosen);
    value = static_cast<Enum>(chosen);
}

void draw_turn(FilmExport& film) {
    draw_export_label(tr("turn"), tr("The camera goes around what it looks at."));
    const float column = ImGui::GetCursorPosX();
    ImGui::Checkbox("##turns", &film.turns);
    if (!film.turns) return;
    ImGui::SameLine();
    ImGui::SetNextItemWidth(em(5.0F));
    draw_number_field("##degrees", film.degrees, -36000.0, 36000.0);
    draw_tooltip(tr("Degrees, against the clock seen from the axis' end."));
    const char* const about = tr("\xC2\xB0 about");
    const float list = ImGui::CalcTextSize(tr(axes.front())).x + ImGui::GetFrameHeight() +
                       2.0F * ImGui::GetStyle().FramePadding.x;
    flow(ImGui::CalcTextSize(about).x + em(0.4F) + list, em(0.4F), column);
    ImGui::TextUnformatted(about);
    ImGui::SameLine(0.0F, em(0.4F));
    ImGui::SetNextItemWidth(-1.0F);
    auto axis = static_cast<std::size_t>(film.axis);
    draw_choice("##axis", axes, axis);
    film.axis = static_cast<int>(axis);
}

/// The names that can be swept and are not.
std::vector<std::string> names_left(const UiState& state) {
    std::vector<std::string> names = state.shown.reading.parameters;
    if (state.shown.reading.uses_w) names.emplace_back(w_name);
    const std::vector<Sweep>& sweeps = state.pages.exports.wish.film.plan.sweeps;
    std::erase_if(names, [&](const std::string& name) {
        return std::ranges::find(sweeps, name, &Sweep::name) != sweeps.end();
    });
    return names;
}

/// A sweep over the whole of the parameter's slider.
Sweep whole_sweep(const Document& document, const std::string& name) {
    const Slider slider = slider_named(document, name);
    return {.name = name, .from = slider.lo, .to = slider.hi};
}

/// Draws one sweep; false when the user removes it.
bool draw_sweep(Sweep& sweep, const Palette& colors) {
    const float button = ImGui::GetFrameHeight();
    draw_export_label(sweep.name.c_str(), tr("Goes from the first number to the second."));
    const float space = ImGui::GetContentRegionAvail().x - button - em(2.6F);
    ImGui::SetNextItemWidth(0.5F * space);
    draw_number_field("##from", sweep.from, -largest_number, largest_number);
    ImGui::SameLine(0.0F, em(0.4F));
    ImGui::TextUnformatted(tr("to"));
    ImGui::SameLine(0.0F, em(0.4F));
    ImGui::SetNextItemWidth(0.5F * space);
    draw_number_field("##to", sweep.to, -largest_number, largest_number);
    ImGui::SameLine();
    return !icon_button("##remove", Icon::Cross, {.size = button, .color = colors.quiet},
                        tr("Leave it as it is"));
}

void draw_sweeps(UiState& state) {
    std::vector<Sweep>& sweeps = state.pages.exports.wish.film.plan.sweeps;
    for (std::size_t i = 0; i < sweeps.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const bool kept = draw_sweep(sweeps[i], palette(state.edited.theme));
        ImGui::PopID();
        if (!kept) {
            sweeps.erase(sweeps.begin() + static_cast<std::ptrdiff_t>(i));
            break;
        }
    }
    const std::vector<std::string> names = names_left(state);
    if (names.empty()) return;
    draw_export_label(tr("sweep"), tr("A parameter that changes with the film."));
    if (!ImGui::BeginCombo("##sweep", tr("add a parameter..."))) return;
    for (const std::string& name : names) {
        if (ImGui::Selectable(name.c_str()))
            sweeps.push_back(whole_sweep(state.edited.document, name));
    }
    ImGui::EndCombo();
}

constexpr const char* about_way = marked(
    "The camera goes through views, smoothly and at an even speed. Saved views (V) make a "
    "way, too.");

/// Draws the choice of the saved views as the camera's way.
void draw_saved_way(UiState& state) {
    const std::size_t count = state.edited.document.views.size();
    draw_export_label(tr("way"), tr(about_way));
    const std::string label =
        filled(tr("Through the saved views ({0})"), {std::to_string(count)}) + "###saved";
    ImGui::Checkbox(label.c_str(), &state.pages.exports.wish.film.through_views);
    draw_tooltip(count < 2 ? tr("Two views make a way: save another (V).")
                           : tr("In the order of the section Camera."));
}

/// Draws the cameras of a way of the film's own.
void draw_own_way(UiState& state, const char* label) {
    std::vector<Camera>& path = state.pages.exports.wish.film.plan.path;
    draw_export_label(label, tr(about_way));
    if (ImGui::Button(tr("Add this view")) && state.edited.document.camera)
        path.push_back(*state.edited.document.camera);
    draw_tooltip(tr("Turn the picture, then add what it shows; two views make a way."));
    for (std::size_t i = 0; i < path.size(); ++i) {
        ImGui::SameLine(0.0F, em(0.4F));
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Button(std::to_string(i + 1).c_str())) state.edited.document.camera = path[i];
        draw_tooltip(tr("Look from there"));
        ImGui::PopID();
    }
    if (path.empty()) return;
    ImGui::SameLine(0.0F, em(0.4F));
    if (ImGui::Button(tr("Clear"))) path.clear();
}

/// Draws the way of the camera: through the saved views where there are enough of them, or through
/// views that are added here.
void draw_way(UiState& state) {
    const FilmExport& film = state.pages.exports.wish.film;
    const bool saved = state.edited.document.views.size() >= 2 || film.through_views;
    if (saved) draw_saved_way(state);
    if (film.through_views) return;
    if (!saved || !film.plan.path.empty()) draw_own_way(state, saved ? "" : tr("way"));
}

/// Draws how long the film is: seconds, frames and frames a second, of which any two make the
/// third.
void draw_time(FilmExport& film) {
    constexpr float gap_em = 0.4F;
    draw_export_label(tr("time"), tr("How long it plays, in seconds or frames, and how fast."));
    const float column = ImGui::GetCursorPosX();
    const auto end = [](const char* name) {
        ImGui::SameLine(0.0F, em(gap_em));
        ImGui::TextUnformatted(name);
    };
    ImGui::SetNextItemWidth(em(3.0F));
    draw_number_field("##seconds", film.seconds, 0.01, longest_s);
    end("s,");
    flow(em(3.2F + gap_em) + ImGui::CalcTextSize(tr("frames,")).x, em(gap_em), column);
    ImGui::SetNextItemWidth(em(3.2F));
    int frames = film.frames();
    if (draw_integer_field("##frames", frames, 1, most_frames)) film.take_frames(frames);
    end(tr("frames,"));
    const float unit = std::max(em(2.6F), em(gap_em) + ImGui::CalcTextSize(tr("fps")).x);
    flow(em(2.2F) + unit, em(gap_em), column);
    ImGui::SetNextItemWidth(-unit);
    draw_integer_field("##rate", film.plan.rate.frames, 1, 240);
    end(tr("fps"));
}

void draw_blur(FilmPlan& plan) {
    draw_export_label(tr("blur"), tr("Pictures that are mixed for each frame: motion blur."));
    draw_integer_slider("##blur", plan.blur, 1, 64, plan.blur == 1 ? tr("off") : nullptr);
    if (plan.blur == 1) return;
    draw_export_label(tr("shutter"),
                      tr("The part of a frame's time over which they are spread: 50 % is usual, at "
                         "100 % a motion leaves no gaps."));
    int percent = static_cast<int>(std::lround(100.0 * plan.shutter));
    const std::string shown = std::to_string(percent) + " %";
    if (draw_integer_slider("##shutter", percent, 1, 100, shown.c_str()))
        plan.shutter = 0.01 * percent;
}

}  // namespace

void draw_film_timeline(UiState& state) {
    ExportPage& page = state.pages.exports;
    const Palette& colors = palette(state.edited.theme);
    const FilmExport& film = page.wish.film;
    const int frames = film.frames();
    page.at = std::clamp(page.at, 0.0, static_cast<double>(frames - 1));
    const float button = ImGui::GetFrameHeight();
    if (icon_button("##play", page.plays ? Icon::Pause : Icon::Play,
                    {.size = button, .color = colors.text},
                    page.plays ? tr("Hold the preview") : tr("Play the preview")))
        page.plays = !page.plays;
    if (page.plays) {
        const double rate = static_cast<double>(film.plan.rate.frames) / film.plan.rate.seconds;
        page.at = std::fmod(page.at + rate * static_cast<double>(ImGui::GetIO().DeltaTime), frames);
    }
    ImGui::SameLine();
    int frame = static_cast<int>(page.at);
    std::array<char, 32> seconds{};
    std::snprintf(seconds.data(), seconds.size(), "%.2f",
                  page.at * film.plan.rate.seconds / film.plan.rate.frames);
    const std::string text =
        filled(tr("frame {0} of {1}, {2} s"),
               {std::to_string(frame + 1), std::to_string(frames), localized(seconds.data())});
    ImGui::SetNextItemWidth(-em(12.0F));
    if (ImGui::SliderInt("##timeline", &frame, 0, std::max(frames - 1, 1), "",
                         ImGuiSliderFlags_AlwaysClamp)) {
        page.at = frame;
        page.plays = false;
    }
    draw_tooltip(tr("The film's frames: drag to look at any of them."));
    ImGui::SameLine();
    ImGui::TextDisabled("%s", text.c_str());
}

void draw_film_part(UiState& state, const ExportFormat& format) {
    FilmExport& film = state.pages.exports.wish.film;
    draw_turn(film);
    draw_sweeps(state);
    draw_way(state);
    draw_time(film);
    draw_export_label(tr("end"),
                      tr("What comes after the last frame, and how changes begin and end."));
    ImGui::SetNextItemWidth(em(6.0F));
    draw_enum("##end", ends, film.plan.end);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0F);
    draw_enum("##easing", easings, film.plan.easing);
    draw_size_fields(film.size_px, state.input.viewport_px, largest_film, format.even);
    draw_blur(film.plan);
    if (format.quality) {
        draw_export_label(tr("quality"), tr("Less makes smaller files."));
        draw_integer_slider("##quality", film.quality, 1, 100, nullptr);
    }
    draw_surface_checks(film.smooth, film.alpha, format.alpha);
}

}  // namespace zeroset::ui
