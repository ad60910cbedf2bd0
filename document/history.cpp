#include "document/history.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace zeroset {
namespace {

std::vector<int> ids_of(const Document& document) {
    std::vector<int> ids;
    ids.reserve(document.statements.size());
    for (const Statement& statement : document.statements)
        ids.push_back(statement.id);
    return ids;
}

/// "rows" where rows came or went, "order" where they changed places; else empty.
std::string changed_rows(const Document& a, const Document& b) {
    const std::vector<int> from = ids_of(a);
    const std::vector<int> to = ids_of(b);
    if (from == to) return {};
    return std::ranges::is_permutation(from, to) ? "order" : "rows";
}

/// The kind of change and the id of the first row that differs; empty where none does.
std::string changed_row(const Document& a, const Document& b) {
    for (std::size_t i = 0; i < a.statements.size(); ++i) {
        const Statement& from = a.statements[i];
        const Statement& to = b.statements[i];
        const std::string name = std::to_string(to.id);
        if (from.text != to.text) return "text " + name;
        if (from.color != to.color) return "color " + name;
        if (from.visible != to.visible) return "visible " + name;
        if (from.thickness != to.thickness) return "thickness " + name;
        if (from.box != to.box) return "box " + name;
    }
    return {};
}

std::string changed_parameter(const Document& a, const Document& b) {
    for (const auto* names : {&a.parameters, &b.parameters}) {
        for (const auto& [name, slider] : *names) {
            if (slider_of(a, name) != slider_of(b, name)) return "parameter " + name;
        }
    }
    return {};
}

/// "views" where some came or went, or the number of the first that differs; else empty.
std::string changed_view(const Document& a, const Document& b) {
    if (a.views.size() != b.views.size()) return "views";
    const auto [from, to] = std::ranges::mismatch(a.views, b.views);
    return from == a.views.end() ? "" : "view " + std::to_string(to - b.views.begin());
}

/// The part of the document that differs; changes of the same part may become one step.
std::string changed_part(const Document& a, const Document& b) {
    if (const std::string rows = changed_rows(a, b); !rows.empty()) return rows;
    if (const std::string row = changed_row(a, b); !row.empty()) return row;
    if (const std::string name = changed_parameter(a, b); !name.empty()) return name;
    if (a.w != b.w) return "w";
    if (a.camera != b.camera) return "camera";
    if (const std::string view = changed_view(a, b); !view.empty()) return view;
    if (a.clip != b.clip) return "clip";
    if (a.aspect != b.aspect) return "aspect";
    if (a.region != b.region) return "region";
    if (a.stop != b.stop) return "stop";
    if (a.up != b.up) return "up";
    if (a.markers != b.markers) return "markers";
    if (a.coloring.expression != b.coloring.expression) return "color expression";
    if (a.coloring.range != b.coloring.range) return "color range";
    if (a.section_values != b.section_values) return "section values";
    return "look";
}

/// Whether a part is a slider. A point that is dragged moves several of them.
bool is_slider(std::string_view part) { return part == "w" || part.starts_with("parameter "); }

}  // namespace

void History::follow(const Document& document, double time_s, unsigned gesture, bool held) {
    if (document == now_) return;
    const std::string part = changed_part(now_, document);
    const bool stands_alone = part == "rows" || part == "views";
    const bool is_dragged = held && is_slider(part) && is_slider(open_part_);
    const bool goes_on = (part == open_part_ || is_dragged) && !stands_alone &&
                         gesture == open_gesture_ && (held || time_s - changed_s_ <= rest_s);
    if (!goes_on) {
        if (undone_to_.size() == most_steps) undone_to_.erase(undone_to_.begin());
        undone_to_.push_back(now_);
    }
    redone_to_.clear();
    now_ = document;
    open_part_ = part;
    open_gesture_ = gesture;
    changed_s_ = time_s;
    if (undone_to_.back() != now_) return;
    undone_to_.pop_back();
    end_step();
}

const Document& History::undo() {
    if (!can_undo()) return now_;
    redone_to_.push_back(std::exchange(now_, undone_to_.back()));
    undone_to_.pop_back();
    end_step();
    return now_;
}

const Document& History::redo() {
    if (!can_redo()) return now_;
    undone_to_.push_back(std::exchange(now_, redone_to_.back()));
    redone_to_.pop_back();
    end_step();
    return now_;
}

}  // namespace zeroset
