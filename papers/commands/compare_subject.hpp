#pragma once

#include "app/cli/options/options.hpp"
#include "app/cli/timing.hpp"
#include "app/dev/bench_suite.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/settings.hpp"
#include "engine/view/camera.hpp"
#include "papers/commands/paper_commands.hpp"
#include "papers/compare/compared_row.hpp"
#include "papers/compare/printed_tables.hpp"
#include "pipeline/picture_request.hpp"

#include <optional>
#include <string>

namespace zeroset {

/// How the frames of a comparison are drawn and timed.
struct CompareFrames {
    const PrintedTable* table = nullptr;  ///< nullptr: no times of frames are printed
    Size size{};
    int repeats = 3;
    double budget_s = default_budget_s;  ///< for each frame
};

/// The typed numbers of frames, or the usual ones.
OrInputError<CompareFrames> read_frames(const CompareCommand& command,
                                        const std::string& usual_size);

/// A surface, ready to be drawn by tracers that are compared.
class CompareSubject {
public:
    static OrInputError<CompareSubject> make(const BenchItem& item, const CompareFrames& frames);

    /// Why the tracer cannot draw it, as a line; nothing: it can.
    [[nodiscard]] std::optional<std::string> refusal(const TraceSettings& settings) const;
    /// A row of the comparison: frames by a tracer. `wanted_d_stop`: of the table.
    [[nodiscard]] ComparedRow measured(int wanted_d_stop, const TraceSettings& settings,
                                       const CompareFrames& frames) const;

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const Camera& camera() const { return request_.camera; }

private:
    CompareSubject(std::string name, PictureRequest request);

    [[nodiscard]] double prepared_ms(const Scene& scene, const TraceSettings& settings,
                                     const Framebuffer& frame) const;
    [[nodiscard]] ImageBoxCounters boxes(const Scene& scene, const TraceSettings& settings,
                                         double budget_s, Framebuffer& frame) const;
    FrameTiming draw(const Scene& scene, const TraceSettings& settings, const Repeats& repeats,
                     double budget_s, Framebuffer& frame) const;

    std::string name_;
    PictureRequest request_;
    Scene scene_;
    Framebuffer proved_;  ///< by beams, as fine as there is
};

}  // namespace zeroset
