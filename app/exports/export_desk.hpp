#pragma once

#include "app/exports/export_run.hpp"
#include "app/exports/preview_job.hpp"
#include "app/platform/image_clipboard.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/window/texture.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// The window's exports: shows what a file will be, and makes it. The window's thread only.
class ExportDesk {
public:
    /// `wake` is called from other threads when there is something new.
    explicit ExportDesk(std::function<void()> wake) : previews_(wake), run_(std::move(wake)) {}

    /// Hands previews and progress to the panels; to be called before they are drawn.
    void show(ui::UiState& state);
    /// Fulfils what the panels wish; to be called after they were drawn. `subject`: what is drawn;
    /// nothing while it cannot be.
    void follow(ui::UiState& state, const std::optional<ExportSubject>& subject);
    /// Once for each export that has ended, or could not begin.
    std::optional<ExportOutcome> take();
    /// The path of what take() has told of last; empty: no file was saved.
    [[nodiscard]] const std::string& saved_path() const { return saved_path_; }
    /// "saving a.png, 45 %"; empty while nothing is saved.
    [[nodiscard]] std::string doing() const;
    [[nodiscard]] bool settled() const { return !run_.runs() && !previews_.busy(); }
    /// True while the panels must be drawn again to show how far something is.
    [[nodiscard]] bool moves() const { return run_.runs() || !previews_.doing().empty(); }

private:
    void show_preview(ui::UiState& state);
    void copy(const ui::UiState& state, const ExportSubject& subject);
    void save(const ui::UiState& state, const ExportSubject& subject, const std::string& path);
    [[nodiscard]] ExportWork work_of(const PreviewRequest& wanted, const std::string& path);
    void know_meshes();

    ui::Texture preview_texture_, run_texture_;
    std::optional<Preview> preview_;  ///< the newest
    std::optional<ExportOutcome> refused_;
    std::shared_ptr<std::vector<std::byte>> copied_;  ///< of the picture that is being copied
    std::string path_, saved_path_;                   ///< of what is being saved, and was
    /// The meshes that are being saved, and what for, where no preview had made them.
    std::shared_ptr<MadeMeshes> saved_meshes_;
    PreviewRequest saved_request_;
    ImageClipboard clipboard_;
    PreviewJob previews_;
    ExportRun run_;
};

}  // namespace zeroset
