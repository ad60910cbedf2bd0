#include "app/desktop/session.hpp"
#include "document/camera_text.hpp"
#include "document/json/document_json.hpp"
#include "engine/base/translation.hpp"
#include "pipeline/volume_source.hpp"
#include "ui/actions/view_moves.hpp"
#include "ui/panels/panels.hpp"
#include "ui/window/clipboard.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace zeroset {

void Session::copy() const {
    const Marker* const marker = find_marker(current().markers, state_.edited.selected_marker);
    ui::set_clipboard(marker != nullptr ? coordinates_text(marker->at) : text_of(current()));
}

void Session::copy_camera() const {
    if (current().camera) ui::set_clipboard(camera_text(*current().camera));
}

void Session::paste_camera(const std::string& text) {
    if (!current().camera) return;
    const auto camera = read_camera_text(text, *current().camera);
    if (!camera)
        return say(filled(tr("No camera pasted: {0}. A camera is a text such as {1}."),
                          {camera.error(), "eye 5,-8,4; look-at 0,0,0; up 0,0,1; fov 42"}));
    ui::move_view(state_, *camera);
}

void Session::paste() {
    const std::string text = ui::clipboard();
    if (current().camera && read_camera_text(text, *current().camera)) return paste_camera(text);
    if (!looks_like_document(text)) {
        const bool empty = current().statements.back().text.empty();
        ui::insert_rows(state_, current().statements.size() - 1, text);
        const auto last = std::ranges::find(current().statements, std::string(), &Statement::text);
        if (empty && current().statements.size() > 1) current().statements.erase(last);
        return;
    }
    auto read = document_from(text);
    if (!read) return say(filled(tr("Nothing pasted: {0}."), {read.error()}));
    read->document.files = volume_source({.folder = {}, .closed = true}, files_);
    show(std::move(read->document));
}

}  // namespace zeroset
