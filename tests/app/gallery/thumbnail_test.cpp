// Tests of the gallery's thumbnails: drawing them in the background and caching them.

#include "app/gallery/look_cards.hpp"
#include "app/gallery/thumbnail_cache.hpp"
#include "app/gallery/thumbnail_job.hpp"
#include "app/gallery/view_cards.hpp"
#include "pipeline/gallery.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace zeroset::test::thumbnail_test {
namespace {

namespace fs = std::filesystem;

class Thumbnails : public testing::Test {
protected:
    static RgbaImage some_image() { return {2, 1, {0xFF102030U, 0x00000000U}}; }
    [[nodiscard]] std::vector<fs::path> files() const {
        std::vector<fs::path> found;
        for (const auto& entry : fs::directory_iterator(folder_.path()))
            found.push_back(entry.path());
        return found;
    }

    TestFolder folder_;
};

TEST_F(Thumbnails, AreKeptByAllTheyDependOn) {
    const ThumbnailCache cache(folder_.path());
    EXPECT_FALSE(cache.find("a"));
    cache.keep("a", some_image());
    EXPECT_EQ(cache.find("a"), some_image());
    EXPECT_FALSE(cache.find("b"));
    EXPECT_EQ(files(), std::vector<fs::path>{cache.file_of("a")}) << "nothing is left beside";
    EXPECT_NE(thumbnail_key(0, {32, 24}), thumbnail_key(1, {32, 24}));
    EXPECT_NE(thumbnail_key(0, {32, 24}), thumbnail_key(0, {64, 48}));
}

TEST_F(Thumbnails, AreNotTakenFromDamagedFiles) {
    const ThumbnailCache cache(folder_.path());
    cache.keep("a", some_image());
    const auto size = fs::file_size(cache.file_of("a"));
    for (std::uintmax_t at = 0; at < size; at += 5) {
        cache.keep("a", some_image());
        std::fstream file(cache.file_of("a"), std::ios::in | std::ios::out | std::ios::binary);
        file.seekg(static_cast<std::streamoff>(at));
        const int byte = file.get();
        file.seekp(static_cast<std::streamoff>(at));
        file.put(static_cast<char>(byte ^ 1));
        file.close();
        EXPECT_FALSE(cache.find("a")) << at;
    }
    cache.keep("a", some_image());
    fs::resize_file(cache.file_of("a"), 3);
    EXPECT_FALSE(cache.find("a"));
    fs::rename(cache.file_of("a"), cache.file_of("b"));
    cache.keep("a", some_image());
    fs::copy_file(cache.file_of("a"), cache.file_of("b"), fs::copy_options::overwrite_existing);
    EXPECT_FALSE(cache.find("b")) << "another's picture";
}

TEST_F(Thumbnails, AreNotKeptWithoutAFolder) {
    const ThumbnailCache cache(std::nullopt);
    cache.keep("a", some_image());
    EXPECT_FALSE(cache.find("a"));
}

/// A thumbnail job together with means to wait until it has finished a number of pictures.
class WatchedJob {
public:
    explicit WatchedJob(const fs::path& folder)
        : WatchedJob(gallery_thumbnails(ThumbnailCache(folder))) {}
    explicit WatchedJob(DrawThumbnail draw)
        : job_(std::move(draw), ThumbnailJob::Priority::Usual, [this] {
              const std::scoped_lock lock(mutex_);
              ++finished_;
              changed_.notify_one();
          }) {}
    ThumbnailJob& job() { return job_; }
    std::vector<Thumbnail> wait_for(int count) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this, count] { return finished_ >= count; });
        return job_.take();
    }
    int finished() {
        const std::scoped_lock lock(mutex_);
        return finished_;
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    int finished_ = 0;
    ThumbnailJob job_;
};

std::size_t item_named(const char* name) {
    const auto found = std::ranges::find(gallery(), name, &GalleryItem::name);
    return static_cast<std::size_t>(found - gallery().begin());
}

TEST_F(Thumbnails, ShowTheSurfaceOnNothing) {
    WatchedJob watched(folder_.path());
    const std::size_t sphere = item_named("sphere");
    watched.job().want({sphere, item_named("torus")}, {32, 24});
    EXPECT_TRUE(watched.job().busy());
    const auto made = watched.wait_for(2);
    ASSERT_EQ(made.size(), 2U);
    EXPECT_EQ(made[0].item, sphere);
    EXPECT_FALSE(watched.job().busy());
    const RgbaImage& image = made[0].image;
    EXPECT_EQ(image.width, 32);
    EXPECT_EQ(image.height, 24);
    EXPECT_EQ(image.pixels[12 * 32 + 16] >> 24U, 255U) << "the sphere in the middle";
    EXPECT_EQ(image.pixels[0] >> 24U, 0U) << "nothing in the corner";
    EXPECT_EQ(ThumbnailCache(folder_.path()).find(thumbnail_key(sphere, {32, 24})), image);
}

TEST_F(Thumbnails, ComeFromTheCache) {
    const std::size_t item = item_named("sarti_dodecic");
    ThumbnailCache(folder_.path()).keep(thumbnail_key(item, {2, 1}), some_image());
    WatchedJob watched(folder_.path());
    watched.job().want({item}, {2, 1});
    EXPECT_EQ(watched.wait_for(1).front().image, some_image());
}

TEST_F(Thumbnails, ShowTheLookOfTheirSurface) {
    const std::size_t item = item_named("tiger");
    ASSERT_EQ(gallery()[item].light.look, Look::Metal);
    EXPECT_NE(thumbnail_key(item, {32, 24}).find("metal"), std::string::npos);
}

TEST_F(Thumbnails, AreNotThoseOfBeforeWhatIsDrawnChanged) {
    std::atomic<bool> begun = false;
    std::atomic<std::uint32_t> shade = 1;
    WatchedJob watched([&](std::size_t, glm::ivec2 size, const std::atomic<bool>& cancel) {
        const RgbaImage image{
            size.x, size.y,
            std::vector<std::uint32_t>(static_cast<std::size_t>(size.x * size.y), shade)};
        begun = true;
        while (shade == 1 && !cancel) {
        }
        return std::optional(image);
    });
    watched.job().want({0}, {2, 1});
    while (!begun) {
    }
    watched.job().want({}, {2, 1});
    shade = 2;
    watched.job().want({0}, {2, 1});
    EXPECT_EQ(watched.wait_for(1).front().image.pixels.front(), 2U);
}

/// The request of a large picture of the gallery's torus.
PictureRequest torus_request() {
    const ReadDocument read = read_document(gallery()[item_named("torus")]);
    const auto prepared = prepare(read.document, read.rows.value(), Preparation::Quickest);
    EXPECT_TRUE(prepared);
    return picture_request(prepared.value().formula, prepared->colors, read.document,
                           thumbnail_settings(), {800, 600});
}

TEST_F(Thumbnails, OfLooksDifferFromEachOther) {
    const PictureRequest request = torus_request();
    std::set<std::vector<std::uint32_t>> pictures;
    for (std::size_t look = 0; look < looks().size(); ++look) {
        const auto image = thumbnail_of(look_picture(request, look, {24, 18}), false);
        ASSERT_TRUE(image);
        EXPECT_EQ(image->width, 24);
        pictures.insert(image->pixels);
    }
    EXPECT_EQ(pictures.size(), looks().size());
}

TEST_F(Thumbnails, OfViewsAreAsTheirCamerasSeeIt) {
    const PictureRequest request = torus_request();
    const Camera away{{0, -50, 0}, {0, -60, 0}, {0, 0, 1}, 0.7};
    // Near enough to need code in double.
    const Camera near{{3 + 1e-7, 0, 0}, {3, 0, 0}, {0, 0, 1}, 0.7};
    std::set<std::vector<std::uint32_t>> pictures;
    for (const Camera& camera : {request.camera, away, near}) {
        const auto image = thumbnail_of(view_picture(request, camera, {24, 18}), false);
        ASSERT_TRUE(image);
        EXPECT_EQ(image->width, 24);
        pictures.insert(image->pixels);
    }
    EXPECT_EQ(pictures.size(), 3U);
    const auto of_away = thumbnail_of(view_picture(request, away, {24, 18}), false);
    EXPECT_EQ(std::ranges::count_if(of_away->pixels, [](auto pixel) { return pixel >> 24U != 0; }),
              0)
        << "nothing is seen";
}

TEST_F(Thumbnails, WaitWhileTheyAreHeld) {
    WatchedJob watched(folder_.path());
    watched.job().hold(true);
    watched.job().want({item_named("sphere")}, {32, 24});
    EXPECT_EQ(watched.finished(), 0);
    EXPECT_TRUE(watched.job().busy());
    watched.job().want({item_named("torus")}, {32, 24});
    watched.job().hold(false);
    EXPECT_EQ(watched.wait_for(1).front().item, item_named("torus")) << "wanted last";
}

}  // namespace
}  // namespace zeroset::test::thumbnail_test
