#include "app/gallery/thumbnail_job.hpp"

#include "document/json/document_json.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/render/render.hpp"
#include "pipeline/gallery.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/prepare.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace zeroset {
namespace {

/// The stop value for thumbnails: fine enough at twice their width and height.
constexpr double thumbnail_d_stop = 12.0;
/// Niceness of the thread: other work comes first, but a busy machine does not stop it.
constexpr int low_priority = 10;

/// The request for the item's picture.
PictureRequest request_of(const PreparedDocument& prepared, const Document& document,
                          glm::ivec2 size_px) {
    PictureRequest request =
        picture_request(prepared.formula, prepared.colors, document, thumbnail_settings(), size_px);
    request.settings.antialias = Antialias::None;  // thumbnail_of makes edges smooth
    return request;
}

/// A failure leaves the thread's priority as it is, which only makes other work slower.
void lower_priority() {
    (void)::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), low_priority);
}

std::string text_of_numbers(const std::vector<double>& numbers) {
    std::string text;
    for (const double number : numbers) {
        std::array<char, 32> digits{};
        std::snprintf(digits.data(), digits.size(), " %.17g", number);
        text += digits.data();
    }
    return text;
}

/// Draws a document and keeps its picture.
std::optional<RgbaImage> drawn(const ReadDocument& read, glm::ivec2 size_px, const std::string& key,
                               const ThumbnailCache& cache, const std::atomic<bool>& cancel) {
    RgbaImage empty = halved(Framebuffer(2 * size_px.x, 2 * size_px.y));
    if (!read.rows) return empty;
    const auto prepared = prepare(read.document, *read.rows, Preparation::Quickest);
    if (cancel) return std::nullopt;
    if (!prepared) return empty;
    const auto image =
        thumbnail_of(render_request(request_of(*prepared, read.document, 2 * size_px)), cancel);
    if (image) cache.keep(key, *image);
    return image;
}

}  // namespace

std::string thumbnail_key(std::size_t item, glm::ivec2 size_px) {
    const GalleryItem& shown = gallery()[item];
    const Camera camera = camera_of(read_document(shown).document, size_px);
    std::vector<double> numbers{shown.w, camera.fov_rad, thumbnail_d_stop,
                                static_cast<double>(size_px.x), static_cast<double>(size_px.y)};
    for (const glm::dvec3& point :
         {shown.clip.lo, shown.clip.hi, camera.eye, camera.look_at, camera.up}) {
        numbers.insert(numbers.end(), {point.x, point.y, point.z});
    }
    numbers.push_back(shown.light.reflections);
    if (shown.thickness) numbers.push_back(shown.thickness->width);
    return "zeroset " ZEROSET_VERSION "\n" + shown.equation + "\n" +
           std::string(name_of(shown.light.look)) + text_of_numbers(numbers);
}

TraceSettings thumbnail_settings() {
    TraceSettings settings;
    settings.stop.value = thumbnail_d_stop;
    settings.threads = 1;
    return settings;
}

std::optional<RgbaImage> thumbnail_of(const RenderRequest& request,
                                      const std::atomic<bool>& cancel) {
    Framebuffer frame(request.width, request.height);
    (void)render_frame(request.scene, request.camera, request.settings, frame,
                       {.limit = {.cancel = &cancel}});
    if (cancel) return std::nullopt;
    return halved(frame);
}

DrawThumbnail gallery_thumbnails(ThumbnailCache cache) {
    return [cache = std::move(cache)](std::size_t item, glm::ivec2 size_px,
                                      const std::atomic<bool>& cancel) -> std::optional<RgbaImage> {
        const std::string key = thumbnail_key(item, size_px);
        if (auto kept = cache.find(key)) return kept;
        return drawn(read_document(gallery()[item]), size_px, key, cache, cancel);
    };
}

std::optional<RgbaImage> document_thumbnail(const Document& document, glm::ivec2 size_px,
                                            const ThumbnailCache& cache,
                                            const std::atomic<bool>& cancel) {
    const bool names_files = std::ranges::any_of(
        document.statements,
        [](const Statement& statement) { return statement.text.contains('"'); });
    if (names_files) return halved(Framebuffer(2 * size_px.x, 2 * size_px.y));
    const std::string key = "zeroset " ZEROSET_VERSION "\n" + std::to_string(size_px.x) + " " +
                            std::to_string(size_px.y) + "\n" + text_of(document);
    if (auto kept = cache.find(key)) return kept;
    return drawn(read_document(document), size_px, key, cache, cancel);
}

ThumbnailJob::ThumbnailJob(DrawThumbnail draw, Priority priority, std::function<void()> on_picture)
    : draw_(std::move(draw)), on_picture_(std::move(on_picture)), thread_([this, priority] {
          if (priority == Priority::Low) lower_priority();
          run();
      }) {}

ThumbnailJob::~ThumbnailJob() {
    {
        const std::scoped_lock lock(mutex_);
        stop_ = true;
        cancel_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void ThumbnailJob::want(std::vector<std::size_t> items, glm::ivec2 size_px) {
    {
        const std::scoped_lock lock(mutex_);
        if (items == wanted_ && size_px == size_px_) return;
        const bool goes_on = size_px == size_px_ && !wanted_.empty() && !items.empty() &&
                             items.front() == wanted_.front();
        if (!goes_on) {
            cancel_ = true;
            ++round_;
        }
        wanted_ = std::move(items);
        size_px_ = size_px;
    }
    wake_.notify_one();
}

void ThumbnailJob::hold(bool held) {
    {
        const std::scoped_lock lock(mutex_);
        if (held == held_) return;
        held_ = held;
        if (held) cancel_ = true;
    }
    wake_.notify_one();
}

std::vector<Thumbnail> ThumbnailJob::take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(finished_, {});
}

bool ThumbnailJob::busy() const {
    const std::scoped_lock lock(mutex_);
    return !wanted_.empty() || !finished_.empty();
}

void ThumbnailJob::run() {
    while (const auto work = wait_for_work())
        finish(*work, draw_(work->item, work->size_px, cancel_));
}

std::optional<ThumbnailJob::Work> ThumbnailJob::wait_for_work() {
    std::unique_lock lock(mutex_);
    wake_.wait(lock, [this] { return stop_ || (!held_ && !wanted_.empty()); });
    if (stop_) return std::nullopt;
    cancel_ = false;
    return Work{.item = wanted_.front(), .size_px = size_px_, .round = round_};
}

void ThumbnailJob::finish(const Work& work, std::optional<RgbaImage> image) {
    if (!image) return;
    {
        const std::scoped_lock lock(mutex_);
        if (round_ != work.round || std::erase(wanted_, work.item) == 0) return;
        finished_.push_back({.item = work.item, .image = std::move(*image)});
    }
    on_picture_();
}

}  // namespace zeroset
