#pragma once

#include "engine/render/render_job.hpp"
#include "pipeline/picture_request.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/window/texture.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace zeroset {

/// The picture on the screen by another tracer, and where the two differ. The window's thread only.
class TracerComparison {
public:
    /// `wake` is called from another thread after each picture.
    explicit TracerComparison(std::function<void()> wake);

    /// Hands the newest picture to the panels; to be called before they are drawn.
    void show(ui::UiState& state);
    /// Has the other tracer draw what is on the screen; to be called after they were drawn.
    /// `on_screen`: its request, nullptr while a newer one is on its way. While its full picture is
    /// still to come there are only first ones of the other tracer, so that their times are fair.
    void follow(const ui::UiState& state, const PictureRequest* on_screen);
    [[nodiscard]] bool settled() const { return job_ == nullptr || !job_->busy(); }

private:
    /// The pictures that the texture was made of, and how.
    struct Uploaded {
        std::shared_ptr<const Framebuffer> first, other;
        ui::Theme theme = ui::Theme::Dark;
        bool difference = false;

        bool operator==(const Uploaded&) const = default;
    };

    void upload(ui::UiState& state);
    void upload_difference(const ui::Shown& shown, ui::OtherPicture& other, bool first_proves);

    std::optional<PictureRequest> submitted_;
    bool previews_ = false;  ///< submitted_ was asked for in first pictures only
    std::uint64_t newest_ = 0;
    Precision precision_ = Precision::Float;
    std::optional<ui::Texture> texture_;
    Uploaded uploaded_;
    std::function<void()> wake_;
    /// Since a first picture was wanted. Its thread wakes the window: it ends first.
    std::unique_ptr<RenderJob> job_;
};

}  // namespace zeroset
