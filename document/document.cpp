#include "document/document.hpp"

#include "engine/base/enum_names.hpp"
#include "engine/base/text.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace zeroset {
namespace {

constexpr auto repeats = enum_names<Repeat>("bounce", "loop");
constexpr std::string_view between_rows = "\n;\n";
constexpr std::array<std::string_view, 4> signs{"+", "-", "\u2212", "\u2013"};

/// The row with "\v" for each line end that a sign follows: within a row, such a line continues
/// the one before.
std::string with_joined_lines(std::string row) {
    for (std::size_t end = row.find('\n'); end != std::string::npos;
         end = row.find('\n', end + 1)) {
        const std::size_t next = row.find_first_not_of(" \t\r", end + 1);
        if (next == std::string::npos) break;
        const std::string_view rest = std::string_view(row).substr(next);
        const bool sign = std::ranges::any_of(
            signs, [&](std::string_view minus) { return rest.starts_with(minus); });
        if (sign) row[end] = '\v';
    }
    return row;
}

}  // namespace

std::string_view name_of(Repeat repeat) { return repeats.of(repeat); }

std::optional<Repeat> repeat_named(std::string_view name) { return repeats.named(name); }

std::string thickness_text(const Thickness& thickness) {
    return digits_of(thickness.width) + (thickness.in_pixels ? " px" : "");
}

std::optional<Thickness> thickness_from(std::string_view text) {
    text = trimmed(text);
    const bool in_pixels = text.ends_with("px");
    if (in_pixels) text = trimmed(text.substr(0, text.size() - 2));
    const auto width = number_from<double>(text);
    const double most = in_pixels ? most_pixels_thick : largest_number;
    if (!width || !(*width > 0.0 && *width <= most)) return std::nullopt;
    return Thickness{.width = *width, .in_pixels = in_pixels};
}

void keep_settings(Document& document, const Document& of) {
    document.stop = of.stop;
    document.shadows = of.shadows;
    document.antialias = of.antialias;
    document.light = of.light;
    document.jumps = of.jumps;
    document.axes = of.axes;
    document.clip_box = of.clip_box;
    document.grid = of.grid;
    document.axis_names = of.axis_names;
    document.trackball = of.trackball;
    if (!document.camera) document.up = of.up;
}

glm::dvec3 stretch_of(const Document& document) {
    constexpr double most_unequal = 10.0;
    if (document.region.ball) return glm::dvec3(1.0);  // it would be no ball
    if (document.aspect) return *document.aspect;
    const glm::dvec3 edges = document.clip.hi - document.clip.lo;
    const double longest = document.clip.size();
    if (longest <= most_unequal * std::min({edges.x, edges.y, edges.z})) return glm::dvec3(1.0);
    // Powers of two stretch numbers without rounding.
    return glm::exp2(glm::round(glm::log2(longest / edges)));
}

Document unstretched(Document document) {
    document.aspect = glm::dvec3(1.0);
    return document;
}

Document empty_document() {
    Document document;
    document.statements.push_back({.id = 1, .text = {}, .visible = true, .color = {}});
    return document;
}

int unused_id(const Document& document) {
    int id = 1;
    for (const Statement& statement : document.statements)
        id = std::max(id, statement.id + 1);
    return id;
}

Document renumbered(Document document, int first) {
    for (Statement& statement : document.statements)
        statement.id = first++;
    return document;
}

Slider slider_of(const Document& document, const std::string& parameter) {
    const auto found = document.parameters.find(parameter);
    return found == document.parameters.end() ? Slider{} : found->second;
}

void set_value(Slider& slider, double value) {
    slider.value = value;
    slider.lo = std::min(slider.lo, value);
    slider.hi = std::max(slider.hi, value);
}

bool same_work(const Document& a, const Document& b) {
    Document looked_at = b;
    looked_at.camera = a.camera;
    return a == looked_at;
}

JoinedRows::JoinedRows(const std::vector<std::string>& rows) {
    for (const std::string& row : rows) {
        if (!begins.empty()) text += between_rows;
        begins.push_back(text.size());
        text += with_joined_lines(row);
    }
}

std::size_t JoinedRows::row_at(std::size_t offset) const {
    const auto after = std::ranges::upper_bound(begins, offset);
    return after == begins.begin() ? 0 : static_cast<std::size_t>(after - begins.begin()) - 1;
}

std::vector<CutText> JoinedRows::cuts(std::span<const std::optional<Box>> boxes) const {
    std::vector<CutText> cuts;
    for (std::size_t i = 0; i < std::min(boxes.size(), begins.size()); ++i) {
        if (!boxes[i]) continue;
        const auto& [lo, hi] = *boxes[i];
        const std::size_t end = i + 1 < begins.size() ? begins[i + 1] : text.size() + 1;
        cuts.push_back(
            {.begin = begins[i], .end = end, .box = {lo.x, hi.x, lo.y, hi.y, lo.z, hi.z}});
    }
    return cuts;
}

std::string text_with_cuts(std::string text, std::span<const CutText> cuts) {
    for (const CutText& cut : cuts) {
        text += "\n# box " + std::to_string(cut.begin) + ":";
        for (const double end : cut.box)
            text += " " + digits_of(end);
    }
    return text;
}

std::vector<std::optional<Box>> boxes_of(const Document& document) {
    std::vector<std::optional<Box>> boxes;
    boxes.reserve(document.statements.size());
    for (const Statement& statement : document.statements)
        boxes.push_back(statement.box);
    return boxes;
}

JoinedRows joined_rows(const Document& document) {
    std::vector<std::string> rows;
    rows.reserve(document.statements.size());
    for (const Statement& statement : document.statements)
        rows.push_back(statement.text);
    return JoinedRows(rows);
}

}  // namespace zeroset
