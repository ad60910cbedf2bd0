#include "app/cli/render_picture.hpp"

#include "engine/base/clock.hpp"
#include "engine/base/text.hpp"
#include "engine/export/pictures/picture_formats.hpp"
#include "engine/image/background.hpp"
#include "engine/render/color_range.hpp"
#include "engine/render/render.hpp"
#include "engine/render/tracers.hpp"
#include "pipeline/code_choice.hpp"
#include "pipeline/fit_view.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/periodic_axes.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/plans/poster.hpp"
#include "pipeline/shown_points.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace zeroset {
namespace {

using Clock = std::chrono::steady_clock;

/// How long to wait for a picture beyond its budget, as LLVM cannot be interrupted.
constexpr auto picture_patience = std::chrono::seconds(1);

// Divisors of the time left: finding the range of the colours and finding the surfaces' extent each
// may take 1 / share of it.
constexpr int coloring_share = 4;
constexpr int fitting_share = 4;

/// A picture being drawn. The thread that draws it shares its ownership and may outlive everything
/// else.
struct Drawing {
    RenderedPicture picture;
    TakeRows take_rows;
    Progress progress;
    Clock::time_point start, until;
    std::atomic<bool> cancel = false;
    std::atomic<bool> has_scene = false;  ///< all members of `picture` but frame and timing are set
};

/// True if the plan draws a single frame; frames repeated for their times each have a budget.
bool is_one_frame(const RenderPlan& plan) {
    return plan.repeats == 1 && !plan.warms_up && !plan.in_bands;
}

/// Returns the time at which 1 / `parts` of the time left is over.
Clock::time_point after_share(const Drawing& drawing, int parts) {
    const auto now = Clock::now();
    return now + (drawing.until - now) / parts;
}

/// Returns a picture whose pixels are all undecided.
Framebuffer undecided_frame(const Size& size) {
    Framebuffer frame(size.width, size.height);
    for (int row = 0; row < size.height; ++row) {
        for (int col = 0; col < size.width; ++col)
            frame.color[frame.index(col, row)] =
                background_color(frame.background, row, size.height);
    }
    frame.depth.assign(frame.depth.size(), std::numeric_limits<float>::infinity());
    frame.certificate.assign(frame.certificate.size(), Certificate::Undecided);
    frame.surface.assign(frame.surface.size(), no_surface);
    frame.cost.assign(frame.color.size(), 0.0F);
    return frame;
}

/// Makes the request for the plan's picture with the prepared code.
PictureRequest request_for(const RenderPlan& plan, const PreparedDocument& prepared) {
    return picture_request(prepared.formula, prepared.colors, plan.document, plan.settings,
                           {plan.size.width, plan.size.height});
}

/// Finds the range of the colours if the document leaves it open.
void find_color_range(Drawing& drawing) {
    const RenderPlan& plan = drawing.picture.plan;
    Scene& scene = drawing.picture.scene;
    if (!has_range(scene.coloring.by) || scene.coloring.range) return;
    drawing.progress.enter(Progress::Stage::Coloring);
    scene.coloring.range = find_range(
        scene, drawing.picture.request.camera, plan.settings, plan.size.width, plan.size.height,
        {.cancel = &drawing.cancel, .until = after_share(drawing, coloring_share)});
}

/// Returns the formula with the code that draws one frame soonest.
std::expected<Formula, InputError> with_code_for_one(const Drawing& drawing,
                                                     const PictureRequest& request) {
    Formula formula = *request.formula;
    if (formula.code == CodeState::Interpreted) return formula;
    const auto start = Clock::now();
    const RenderRequest frame = render_request(request);
    const auto use = code_for_one(frame, formula, &drawing.cancel);
    formula.compile_ms += ms_since(start);
    if (!use) return formula;
    const Precision precision =
        wanted_precision(frame.scene, ViewFrame(frame.camera), frame.settings.stop);
    return with_machine_code(formula, *use, precision);
}

/// Makes the picture's code and, if planned, fits the view to the surfaces; returns an error if
/// something fails.
std::optional<InputError> prepare_picture(Drawing& drawing) {
    RenderPlan& plan = drawing.picture.plan;
    // Fitting evaluates many ranges, as do all tracers but beams, so that machine code pays.
    const bool few =
        is_one_frame(plan) && !plan.fits && plan.settings.tracer == usual_tracer().name;
    auto prepared =
        prepare(plan.document, plan.rows, few ? Preparation::Interpreted : Preparation::Compiled);
    if (!prepared) return prepared.error();
    if (plan.fits || plan.fits_itself) drawing.progress.enter(Progress::Stage::Fitting);
    const TimeLimit limit{.cancel = &drawing.cancel, .until = after_share(drawing, fitting_share)};
    if (plan.fits) {
        drawing.picture.note = fit_view(plan.document, request_for(plan, *prepared), plan.aspect(),
                                        plan.fits_box, limit);
    } else if (plan.fits_itself) {
        drawing.picture.note = fit_by_itself(plan.document, request_for(plan, *prepared),
                                             plan.aspect(), own_fitting_limit(limit));
    }
    PictureRequest request = request_for(plan, *prepared);
    drawing.progress.enter(Progress::Stage::Compiling);
    if (few) {
        auto formula = with_code_for_one(drawing, request);
        if (!formula) return formula.error();
        request.formula = std::make_shared<const Formula>(std::move(*formula));
    }
    const std::string& tracer = plan.settings.tracer;
    if (const auto refusal = tracer_refusal(tracer, "--tracer " + tracer, request))
        return InputError{.reason = *refusal};
    add_needed_code(request);
    drawing.picture.scene = scene_of(request);
    drawing.picture.request = std::move(request);
    find_color_range(drawing);
    return std::nullopt;
}

/// Draws the picture band by band.
void draw_bands(Drawing& drawing) {
    RenderedPicture& picture = drawing.picture;
    const RenderPlan& plan = picture.plan;
    const Poster poster{.scene = picture.scene,
                        .camera = picture.request.camera,
                        .settings = picture.request.settings,
                        .size = plan.picture.size,
                        .document = plan.document,
                        .points = shown_points(picture.request.formula.get(), plan.document,
                                               picture.request.camera, plan.size.height),
                        .legend = plan.legend,
                        .of_pi = periodic_axes(*picture.request.formula->program),
                        .transparent = plan.picture.alpha,
                        .keeps_light = needs_light(plan.picture),
                        .keeps_normals = needs_normals(plan.picture),
                        .band_budget_s = plan.budget_s};
    const auto pixels =
        static_cast<std::uint64_t>(plan.size.width) * static_cast<std::uint64_t>(plan.size.height);
    drawing.progress.enter(Progress::Stage::Drawing, pixels);
    const auto take = [&](const PictureBand& band) {
        drawing.progress.show(band.painted, band.row, plan.size.height);
        return drawing.take_rows(picture, band);
    };
    const auto add = [&](std::uint64_t count) { drawing.progress.add(count); };
    const auto drawn = draw_poster(poster, take, {.cancel = &drawing.cancel, .on_pixels = add});
    if (!drawn) picture.write_error = drawn.error();
    const PosterWork work = drawn.value_or(PosterWork());
    const double ms = work.drawing_ms;
    picture.timing = {
        .median_ms = ms, .min_ms = ms, .max_ms = ms, .repeats = 1, .counters = work.counters};
    picture.in_time = !picture.timing.counters.is_cut();
}

/// Draws the finished picture once more, with smooth edges, and takes it if that does not take
/// long.
void smooth_edges(Drawing& drawing, Antialias antialias) {
    RenderedPicture& picture = drawing.picture;
    constexpr auto least = std::chrono::seconds(2);
    constexpr int times_plain = 8;
    const std::chrono::duration<double, std::milli> plain(picture.timing.median_ms);
    const auto most = std::max<Clock::duration>(
        least, std::chrono::duration_cast<Clock::duration>(times_plain * plain));
    const TimeLimit limit{.cancel = &drawing.cancel,
                          .until = std::min(drawing.until, Clock::now() + most)};
    Framebuffer frame = picture.frame;
    TraceSettings settings = picture.request.settings;
    settings.antialias = antialias;
    const FrameTiming timing =
        time_frames(picture.scene, picture.request.camera, settings, frame,
                    {.count = 1, .warm_up = false}, [&] { return RenderWatch{.limit = limit}; });
    picture.left_plain = timing.counters.is_cut();
    if (picture.left_plain) return;
    picture.frame = std::move(frame);
    picture.timing = timing;
    picture.request.settings = settings;
}

void draw(Drawing& drawing) {
    RenderedPicture& picture = drawing.picture;
    picture.error = prepare_picture(drawing);
    if (picture.error) return;
    drawing.has_scene.store(true, std::memory_order_release);
    const RenderPlan& plan = picture.plan;
    if (plan.in_bands) return draw_bands(drawing);
    const auto pixels = static_cast<std::uint64_t>(picture.frame.color.size());
    Clock::time_point until = drawing.until;
    const auto next_watch = [&] {
        drawing.progress.enter(Progress::Stage::Drawing, pixels);
        const TimeLimit limit{.cancel = &drawing.cancel, .until = until};
        until =
            until_after(Clock::now(), plan.budget_s);  // each further frame has a budget of its own
        return RenderWatch{.limit = limit, .on_tile = [&drawing](const PixelRect& rect) {
                               drawing.progress.add(static_cast<std::uint64_t>(rect.cols) *
                                                    static_cast<std::uint64_t>(rect.rows));
                           }};
    };
    const bool tries = plan.smooths_itself && is_one_frame(plan) &&
                       picture.request.settings.antialias != Antialias::None;
    const Antialias smooth = picture.request.settings.antialias;
    if (tries) picture.request.settings.antialias = Antialias::None;
    picture.timing =
        time_frames(picture.scene, picture.request.camera, picture.request.settings, picture.frame,
                    {.count = plan.repeats, .warm_up = plan.warms_up}, next_watch);
    picture.in_time = !picture.timing.counters.is_cut();
    if (tries && picture.in_time) smooth_edges(drawing, smooth);
}

/// Copies what is finished of a picture whose thread is still running.
std::shared_ptr<const RenderedPicture> stuck_picture(const Drawing& drawing,
                                                     const RenderPlan& plan) {
    auto picture = std::make_shared<RenderedPicture>();
    if (drawing.has_scene.load(std::memory_order_acquire)) {
        *picture = drawing.picture;  // no tile changes any more: the frame was cancelled
    } else {
        picture->plan = plan;
        picture->frame = undecided_frame(plan.size);
    }
    picture->in_time = false;
    picture->stage_at_end = drawing.progress.stage();
    const std::chrono::duration<double, std::milli> elapsed = Clock::now() - drawing.start;
    picture->timing.median_ms = picture->timing.min_ms = picture->timing.max_ms = elapsed.count();
    picture->timing.repeats = 1;
    const CertificateCounts counts = count_certificates(picture->frame);
    picture->timing.counters.cut_pixels = counts.undecided;
    return picture;
}

}  // namespace

RenderOutcome render_picture(const RenderPlan& plan, Clock::time_point start, TakeRows take_rows) {
    const auto drawing = std::make_shared<Drawing>();
    drawing->picture.plan = plan;
    drawing->take_rows = std::move(take_rows);
    if (!plan.in_bands) drawing->picture.frame = undecided_frame(plan.size);
    if (needs_light(plan.picture) && !plan.in_bands)
        drawing->picture.frame.keep_planes(needs_normals(plan.picture));
    drawing->start = start;
    drawing->until = until_after(start, plan.budget_s);
    const auto last = is_one_frame(plan) ? drawing->until + picture_patience : TimeLimit::never;
    if (finish_until(last, drawing->progress, [drawing] { draw(*drawing); })) {
        return {.picture = std::shared_ptr<const RenderedPicture>(drawing, &drawing->picture)};
    }
    drawing->cancel = true;
    return {.picture = stuck_picture(*drawing, plan), .stuck = true};
}

std::string budget_note(const RenderedPicture& picture) {
    if (picture.in_time) return "";
    const std::string more = "; --budget SECONDS gives more";
    std::string text = "the budget of " + short_number(picture.plan.budget_s) + " s is spent";
    if (picture.stage_at_end != Progress::Stage::Drawing)
        text += std::string(" on ") + name_of(picture.stage_at_end);
    const std::uint64_t cut = picture.timing.counters.cut_pixels;
    if (cut == 0) {
        return text + ": all is decided, but " +
               std::to_string(picture.timing.counters.rough_pixels) +
               " pixels are not shaded to the end" + more;
    }
    const Size& size = picture.plan.size;
    const auto pixels = static_cast<long long>(size.width) * size.height;
    return text + ": " + std::to_string(cut) + " of " + std::to_string(pixels) +
           " pixels are left undecided" + more;
}

}  // namespace zeroset
