#include "ui/picture/view_notice.hpp"

#include "engine/base/translation.hpp"
#include "ui/actions/actions.hpp"
#include "ui/picture/axis_gizmo.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/label.hpp"
#include "ui/style/screen_areas.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace zeroset::ui {
namespace {

/// Least width of the picture that has room for a notice.
constexpr float least_for_notice_em = 11.0F;
constexpr float widest_notice_em = 26.0F;

constexpr std::array<Example, 3> all_examples{
    {{.title = "A sphere", .text = "x^2 + y^2 + z^2 = 1"},
     {.title = "Waves", .text = "z = sin(3x) cos(3y) / 2"},
     {.title = "With a slider", .text = "x^2 + y^2 - z^2 = a"}}};

constexpr ImGuiWindowFlags flags =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus |
    ImGuiWindowFlags_NoSavedSettings;

bool is_blank(const Statement& statement) {
    return statement.text.find_first_not_of(" \t\n") == std::string::npos;
}

std::vector<Statement>& statements_of(UiState& state) { return state.edited.document.statements; }

void take_example(UiState& state, const Example& example) {
    Statement& first = statements_of(state).front();
    first.text = example.text;
    state.wishes.reload = first.id;
    state.wishes.focus = RowFocus{.row = first.id, .caret = RowFocus::Caret::End};
}

/// Draws the files used last, to go on with.
void draw_recent(UiState& state, float width) {
    constexpr std::size_t most = 3;
    const std::vector<std::string>& recent = state.shown.document.recent;
    if (recent.empty()) return;
    ImGui::TextDisabled("%s", tr("Or go on with a recent file:"));
    for (std::size_t i = 0; i < std::min(recent.size(), most); ++i) {
        const std::string name = std::filesystem::path(recent[i]).filename().string();
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Button((elided(name, width - em(1.5F)) + "###recent").c_str(),
                          ImVec2(width, 0.0F)))
            state.wishes.open_path = recent[i];
        draw_tooltip(recent[i]);
        ImGui::PopID();
    }
}

void draw_examples(UiState& state, float width) {
    ImGui::TextWrapped("%s", tr("Type an equation at the left, or begin with one of these."));
    for (const Example& example : all_examples) {
        ImGui::PushID(example.title);
        ImGui::PushFont(font(FontRole::Formula));
        const bool picked =
            ImGui::Button(elided(example.text, width - em(1.5F)).c_str(), ImVec2(width, 0.0F));
        ImGui::PopFont();
        draw_tooltip(tr(example.title));
        if (picked) take_example(state, example);
        ImGui::PopID();
    }
    const Action& gallery = action_named("Gallery");
    if (ImGui::Button(described(gallery).c_str(), ImVec2(width, 0.0F))) gallery.run(state);
    draw_recent(state, width);
}

void show_all(UiState& state) {
    for (Statement& row : statements_of(state))
        row.visible = true;
}

/// Gives the document its usual box back, and looks at all of it.
void reset_box(UiState& state) {
    state.edited.document.clip = Box();
    state.wishes.frame_box = true;
}

void draw_ways(UiState& state, float width) {
    ImGui::TextWrapped("%s", tr("Nothing of the surface is in view."));
    const ImGuiStyle& style = ImGui::GetStyle();
    const float gap = style.ItemSpacing.x;
    const float needed = ImGui::CalcTextSize(tr("Reset box")).x + 2.0F * style.FramePadding.x;
    const bool wide = 0.5F * (width - gap) >= needed;
    const ImVec2 half(wide ? 0.5F * (width - gap) : width, 0.0F);
    if (ImGui::Button(tr("Fit (F)"), half)) state.wishes.frame_surfaces = true;
    draw_tooltip(tr("Find how far the surface reaches, and look at all of it."));
    if (wide) ImGui::SameLine(0.0F, gap);
    if (ImGui::Button(tr("Reset box"), half)) reset_box(state);
    draw_tooltip(tr("The clip box from -2 to 2 again, and all of it in view."));
    Region& region = state.edited.document.region;
    if (region.is_whole()) return;
    if (ImGui::Button(tr("Remove the cuts"), ImVec2(width, 0.0F))) region = Region();
    draw_tooltip(tr("Sphere and sections may have taken all of it away."));
}

void draw_contents(UiState& state, Emptiness why, float width) {
    switch (why) {
        case Emptiness::None: return;
        case Emptiness::NoText: return draw_examples(state, width);
        case Emptiness::AllHidden:
            ImGui::TextWrapped("%s", tr("All surfaces are hidden."));
            if (ImGui::Button(tr("Show all"), ImVec2(width, 0.0F))) show_all(state);
            return;
        case Emptiness::OutOfView: return draw_ways(state, width);
    }
}

/// The picture's part beside the page of exports, where that leaves enough of it.
PictureArea free_part(PictureArea area) {
    const ImGuiWindow* const page = ImGui::FindWindowByID(ImHashStr("###export"));
    if (page == nullptr || !page->WasActive) return area;
    if (page->Pos.x - area.lo.x >= em(least_for_notice_em)) area.hi.x = page->Pos.x;
    return area;
}

void draw_news_text(const std::string& text, float width) {
    if (text.empty()) return;
    const float needed = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + std::min(needed + 1.0F, width));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
}

/// Draws for some seconds what was done, and found by framing.
void draw_news(UiState& state) {
    const StatusTexts& status = state.shown.status;
    if (status.done.empty() && status.framed.empty()) return;
    const PictureArea area = free_part(viewport_area(state.edited.layout));
    const float padding = 2.0F * ImGui::GetStyle().WindowPadding.x;
    const float width = std::max(area.hi.x - area.lo.x - em(2.0F) - padding, em(8.0F));
    ImGui::SetNextWindowPos(ImVec2(0.5F * (area.lo.x + area.hi.x), area.hi.y - em(0.8F)),
                            ImGuiCond_Always, ImVec2(0.5F, 1.0F));
    ImGui::SetNextWindowBgAlpha(0.95F);
    const bool clicks = !status.saved.empty();
    if (ImGui::Begin("##news", nullptr, clicks ? flags : flags | ImGuiWindowFlags_NoInputs)) {
        if (!clicks) put_under_pages();
        draw_news_text(status.done, width);
        draw_news_text(status.framed, width);
        if (clicks && ImGui::Button(tr("Show in folder"))) state.wishes.show_file = status.saved;
    }
    ImGui::End();
}

}  // namespace

std::span<const Example> examples() { return all_examples; }

Emptiness emptiness_of(const UiState& state) {
    const std::vector<Statement>& all = state.edited.document.statements;
    if (std::ranges::all_of(all, is_blank)) return Emptiness::NoText;
    const PictureFigures& figures = state.shown.figures;
    const CertificateCounts& counts = figures.counts;
    const std::vector<int>& surfaces = state.shown.reading.surface_rows;
    const bool known = figures.width_px > 0 && !figures.hidden && !surfaces.empty();
    if (!known || counts.certified + counts.undecided + counts.jumps > 0) return Emptiness::None;
    const auto is_surface = [&surfaces](const Statement& row) {
        return std::ranges::find(surfaces, row.id) != surfaces.end();
    };
    // While no row can be read nothing is hidden.
    if (std::ranges::none_of(all, is_surface)) return Emptiness::None;
    const bool seen = std::ranges::any_of(
        all, [&](const Statement& row) { return row.visible && is_surface(row); });
    return seen ? Emptiness::OutOfView : Emptiness::AllHidden;
}

void draw_view_notice(UiState& state) {
    draw_news(state);
    const PictureArea area = viewport_area(state.edited.layout);
    const float space = area.hi.x - area.lo.x;
    if (space < em(least_for_notice_em)) return;
    const Emptiness why = emptiness_of(state);
    if (why == Emptiness::None) return;
    const float padding = 2.0F * ImGui::GetStyle().WindowPadding.x;
    const float width = std::min(em(widest_notice_em), space - em(2.0F) - padding);
    ImGui::SetNextWindowPos(ImVec2(0.5F * (area.lo.x + area.hi.x), 0.5F * (area.lo.y + area.hi.y)),
                            ImGuiCond_Always, ImVec2(0.5F, 0.5F));
    ImGui::SetNextWindowSize(ImVec2(width + padding, 0.0F));
    if (ImGui::Begin("##notice", nullptr, flags)) {
        put_under_pages();
        draw_contents(state, why, width);
    }
    ImGui::End();
}

}  // namespace zeroset::ui
