#include "ui/model/edited.hpp"

namespace zeroset::ui {

Document new_document(const Layout& layout) {
    Document document = empty_document();
    document.axes = layout.axes;
    document.clip_box = layout.clip_box;
    document.grid = layout.grid;
    return document;
}

}  // namespace zeroset::ui
