// Tests of the gallery's thumbnails: drawing them in the background and caching them.

#include "app/gallery/thumbnail_cache.hpp"
#include "app/gallery/thumbnail_job.hpp"
#include "pipeline/gallery.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>
#include <vector>

namespace zeroset::test {
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
        : job_(ThumbnailCache(folder), ThumbnailJob::Priority::Usual, [this] {
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
}  // namespace zeroset::test
