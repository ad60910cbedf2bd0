#include "app/exports/export_desk.hpp"

#include "document/framing.hpp"
#include "engine/base/translation.hpp"

#include <glm/ext/vector_int2.hpp>

#include <cmath>
#include <filesystem>
#include <utility>

namespace zeroset {
namespace {

PreviewRequest request_of(const ui::ExportPage& page, const ExportSubject& subject) {
    PreviewRequest request;
    request.subject = subject;
    request.wish = page.wish;
    const ExportKind kind = page.wish.kind;
    if (kind != ExportKind::Drawing) request.space_px = page.preview_px;
    if (kind == ExportKind::Film) request.at = std::floor(page.at);
    if (kind != ExportKind::Mesh) return request;
    // Meshes do not change as one looks around, unless their colours tell the distance.
    Document& document = request.subject.document;
    request.camera = *document.camera;
    if (document.coloring.by != ColorBy::Depth) document.camera.reset();
    return request;
}

bool has_room(const ui::ExportPage& page) { return page.preview_px.x > 0 && page.preview_px.y > 0; }

}  // namespace

void ExportDesk::show(ui::UiState& state) {
    show_preview(state);
    ui::ExportProgress& progress = state.shown.export_progress;
    if (!run_.runs()) {
        progress = {};
        return;
    }
    progress.name = run_.name();
    progress.share = run_.news().share();
    progress.text = run_.news().text();
    if (const auto picture = run_.news().take_picture()) {
        run_texture_.upload(*picture);
        progress.texture = run_texture_.name();
        progress.size_px = {picture->width, picture->height};
    }
}

void ExportDesk::show_preview(ui::UiState& state) {
    ui::ExportPreview& shown = state.shown.export_preview;
    if (auto made = previews_.take()) {
        preview_ = std::move(made);
        shown = preview_->shown;
        if (const auto& image = preview_->image) {
            preview_texture_.upload(*image);
            shown.texture = preview_texture_.name();
            shown.size_px = {image->width, image->height};
        }
    }
    if (!state.pages.exports.open) {
        preview_.reset();
        shown = {};
    }
    shown.doing = previews_.doing();
}

void ExportDesk::follow(ui::UiState& state, const std::optional<ExportSubject>& subject) {
    const ui::ExportPage& page = state.pages.exports;
    if (std::exchange(state.wishes.stop_export, false)) run_.cancel();
    // A preview would take the cores from the picture on the screen, and from what is being saved.
    if (!page.open || !subject || !has_room(page)) {
        previews_.want(std::nullopt);
    } else if (!state.shown.picture.tracing && !run_.runs()) {
        previews_.want(request_of(page, *subject));
    }
    const bool copies = std::exchange(state.wishes.copy_picture, false);
    const auto path = std::exchange(state.wishes.export_path, std::nullopt);
    if ((!path && !copies) || run_.runs()) return;
    if (!subject) {
        refused_ = std::unexpected(
            tr("there is nothing yet that could be saved: the formula has an error"));
    } else if (path) {
        save(state, *subject, *path);
    } else {
        copy(state, *subject);
    }
}

void ExportDesk::save(const ui::UiState& state, const ExportSubject& subject,
                      const std::string& path) {
    copied_.reset();
    path_ = path;
    run_.start(std::filesystem::path(path).filename().string(),
               work_of(request_of(state.pages.exports, subject), path));
}

void ExportDesk::copy(const ui::UiState& state, const ExportSubject& subject) {
    copied_ = std::make_shared<std::vector<std::byte>>();
    path_.clear();
    const glm::ivec2 size = state.input.viewport_px;
    ExportSubject shown = subject;
    shown.document.camera = fitting(*subject.document.camera,
                                    static_cast<double>(size.x) / static_cast<double>(size.y));
    run_.start(tr("the picture"), copy_work(shown, size, copied_));
}

ExportWork ExportDesk::work_of(const PreviewRequest& wanted, const std::string& path) {
    const ExportSubject& subject = wanted.subject;
    const ui::ExportWish& wish = wanted.wish;
    const bool known = preview_ && preview_->request.same_file(wanted);
    switch (wish.kind) {
        case ExportKind::Picture: return picture_work(subject, wish.picture, path);
        case ExportKind::Film: return film_work(subject, wish.film, path);
        case ExportKind::Mesh:
            if (known) return mesh_work(subject, wish.mesh, path, preview_->meshes);
            // A preview that is being made would come out a little otherwise.
            previews_.want(std::nullopt);
            saved_request_ = wanted;
            saved_meshes_ = std::make_shared<MadeMeshes>();
            return mesh_work(subject, wish.mesh, path, nullptr, saved_meshes_);
        case ExportKind::Drawing:
            return drawing_work(subject, wish.drawing, path, known ? preview_->drawing : nullptr);
    }
    return {};
}

/// Lets the preview show the meshes that were saved.
void ExportDesk::know_meshes() {
    const auto made = std::exchange(saved_meshes_, nullptr);
    if (made == nullptr || made->meshes == nullptr) return;
    previews_.know({.request = saved_request_,
                    .shown = {},
                    .image = {},
                    .meshes = made->meshes,
                    .drawing = {}});
}

std::optional<ExportOutcome> ExportDesk::take() {
    saved_path_.clear();
    if (auto refused = std::exchange(refused_, std::nullopt)) return refused;
    auto outcome = run_.take();
    if (outcome) know_meshes();
    if (outcome && *outcome) saved_path_ = path_;
    if (!outcome || !*outcome || copied_ == nullptr || copied_->empty()) return outcome;
    if (const auto offered = clipboard_.offer(std::move(*copied_)); !offered)
        return std::unexpected(offered.error());
    return outcome;
}

std::string ExportDesk::doing() const {
    if (!run_.runs()) return "";
    return filled(tr("saving {0}, {1}"), {run_.name(), run_.news().text()});
}

}  // namespace zeroset
