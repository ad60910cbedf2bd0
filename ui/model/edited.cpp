#include "ui/model/edited.hpp"

#include "engine/base/enum_names.hpp"

namespace zeroset::ui {
namespace {

constexpr auto uses = enum_names<WheelUse>("zoom", "orbit", "pan");

}  // namespace

std::string_view name_of(WheelUse use) { return uses.of(use); }
std::optional<WheelUse> wheel_use_named(std::string_view name) { return uses.named(name); }

void show_as_new(Document& document, const Layout& layout) {
    document.axes = document.axes || layout.axes;
    document.clip_box = document.clip_box || layout.clip_box;
    document.grid = document.grid || layout.grid;
}

void smooth_as_new(Document& document, const Layout& layout) {
    document.antialias = smooth_edges(layout.smooth_edges);
}

Document new_document(const Layout& layout) {
    Document document = empty_document();
    show_as_new(document, layout);
    smooth_as_new(document, layout);
    return document;
}

Slider first_slider(const std::string& name) { return name == w_name ? Document().w : Slider(); }

Slider slider_named(const Document& document, const std::string& name) {
    return name == w_name ? document.w : slider_of(document, name);
}

void set_slider(Document& document, const std::string& name, const Slider& slider) {
    if (name == w_name) {
        document.w = slider;
    } else if (slider == Slider()) {
        document.parameters.erase(name);
    } else {
        document.parameters[name] = slider;
    }
}

}  // namespace zeroset::ui
