#include "app/desktop/picture_feed.hpp"

#include "engine/view/camera.hpp"
#include "pipeline/volume_source.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <fstream>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

// A document's pictures over time, without a window.

namespace zeroset::test::picture_feed_test {
namespace {

constexpr auto patience = std::chrono::minutes(10);

Document with_text(const std::string& text) {
    Document document = empty_document();
    document.statements.front().text = text;
    document.camera = default_camera(document.clip);
    return document;
}

/// A feed of small pictures and the document that it is given, as a window has them.
class PictureFeedTest : public testing::Test {
protected:
    /// Takes what has come, again after each call of the feed, until `come` holds.
    void follow_until(const std::function<bool()>& come) {
        std::unique_lock lock(mutex_);
        const auto end = std::chrono::steady_clock::now() + patience;
        for (take(); !come(); take()) {
            const bool called = woken_.wait_until(lock, end, [this] { return called_; });
            ASSERT_TRUE(called) << "nothing more came";
            called_ = false;
        }
    }
    void read(const std::string& text, std::shared_ptr<const FieldSource> files = nullptr) {
        document_ = with_text(text);
        document_.files = std::move(files);
        feed_->read(document_);
    }
    /// Reads the text and waits for its last picture.
    void show(const std::string& text, std::shared_ptr<const FieldSource> files = nullptr) {
        read(text, std::move(files));
        follow_until([&] { return feed_->has_read(document_) && feed_->drawn(); });
    }
    [[nodiscard]] std::optional<PictureRequest> wanted() const {
        return feed_->wanted(document_, {}, {24, 16});
    }

    Document document_;
    std::optional<FormulaResult> reading_;
    std::optional<RenderResult> picture_;

private:
    void take() {
        if (auto reading = feed_->take_reading()) reading_ = std::move(reading);
        feed_->take_double();
        if (auto picture = feed_->take_picture()) {
            picture_ = std::move(picture);
            feed_->note_shown(*picture_);
        }
        if (auto picture = wanted()) feed_->submit(std::move(*picture));
    }
    void wake() {
        const std::scoped_lock lock(mutex_);
        called_ = true;
        woken_.notify_one();
    }

    std::mutex mutex_;
    std::condition_variable woken_;
    bool called_ = false;

protected:
    // Ends before what it wakes.
    std::unique_ptr<PictureFeed> feed_ =
        std::make_unique<PictureFeed>([this] { wake(); }, [this] { wake(); });
};

TEST_F(PictureFeedTest, HasNothingAtFirst) {
    document_ = with_text("x = 0");
    EXPECT_EQ(feed_->formula(), nullptr);
    EXPECT_EQ(feed_->newest(), 0U);
    EXPECT_EQ(feed_->on_screen(), nullptr);
    EXPECT_FALSE(feed_->reads());
    EXPECT_FALSE(feed_->tracing());
    EXPECT_FALSE(wanted()) << "there is no formula";
    EXPECT_FALSE(feed_->has_read(document_));
    EXPECT_TRUE(feed_->drawn()) << "there is nothing to draw";
}

TEST_F(PictureFeedTest, DrawsWhatItReads) {
    read("x^2 + y^2 + z^2 = 1");
    EXPECT_TRUE(feed_->reads());
    EXPECT_TRUE(feed_->waits_for().reading);
    follow_until([&] { return feed_->newest() != 0; });
    EXPECT_FALSE(feed_->reads());
    EXPECT_TRUE(feed_->tracing());
    EXPECT_TRUE(feed_->waits_for().picture);
    EXPECT_EQ(feed_->on_screen(), nullptr) << "no picture has come yet";
    follow_until([&] { return feed_->drawn(); });
    ASSERT_TRUE(picture_);
    EXPECT_TRUE(picture_->complete);
    EXPECT_EQ(picture_->frame->width, 24);
    EXPECT_GT(picture_->counts.certified, 0U);
    ASSERT_NE(feed_->on_screen(), nullptr);
    EXPECT_EQ(feed_->on_screen()->formula->text, feed_->formula()->text);
    EXPECT_FALSE(feed_->waits_for().picture || feed_->waits_for().figures);
}

TEST_F(PictureFeedTest, DoesNothingTwice) {
    show("x = 0");
    const auto before = feed_->newest();
    feed_->read(document_);
    EXPECT_FALSE(feed_->reads());
    EXPECT_FALSE(feed_->submit(*wanted()));
    EXPECT_EQ(feed_->newest(), before);
    EXPECT_FALSE(feed_->tracing());
}

TEST_F(PictureFeedTest, ReadsAFileAgainOnceItHasChanged) {
    const TestFolder folder;
    const auto access = std::make_shared<FileAccess>();
    const auto files = volume_source({.folder = folder.path()}, access);
    const auto hits_of = [&](const std::string& balls) {
        std::ofstream(folder / "balls.xyz") << balls;
        access->look_for_changes();
        access->look_for_changes();
        show("blobs(\"balls.xyz\") = 1", files);
        return picture_->counts.certified;
    };
    const auto small = hits_of("0 0 0 0.5\n");
    const auto large = hits_of("0 0 0 1.5\n");
    EXPECT_GT(small, 0U);
    EXPECT_GT(large, 2 * small);
}

TEST_F(PictureFeedTest, ReadsFilesAgainThatOnlyColoursName) {
    const TestFolder folder;
    const auto access = std::make_shared<FileAccess>();
    const auto files = volume_source({.folder = folder.path()}, access);
    const auto colors_of = [&](const std::string& balls) {
        std::ofstream(folder / "balls.xyz") << balls;
        access->look_for_changes();
        access->look_for_changes();
        document_ = with_text("x = 0");
        document_.files = files;
        document_.coloring.by = ColorBy::Expression;
        document_.coloring.expression = "blobs(\"balls.xyz\")";
        feed_->read(document_);
        follow_until([&] { return feed_->has_read(document_) && feed_->drawn(); });
        return feed_->formula() == nullptr ? nullptr : &feed_->colors();
    };
    const auto* const first = colors_of("0 0 0 0.5\n");
    ASSERT_NE(first, nullptr);
    EXPECT_NE(colors_of("0 0 0 1.5\n"), first);
}

TEST_F(PictureFeedTest, ReadsFilesOfTheDocumentThatIsOpenThoughTheTextIsTheSame) {
    const TestFolder folder;
    const auto colors_from = [&](const std::string& name, const std::string& balls) {
        std::filesystem::create_directories(folder / name);
        std::ofstream(folder / name / "balls.xyz") << balls;
        document_ = with_text("x = 0");
        document_.files = volume_source({.folder = folder / name, .closed = true});
        document_.coloring.by = ColorBy::Expression;
        document_.coloring.expression = "blobs(\"balls.xyz\")";
        feed_->read(document_);
        follow_until([&] {
            return !feed_->reads() && feed_->formula() != nullptr &&
                   feed_->formula()->files == document_.files && feed_->drawn();
        });
        return feed_->formula() == nullptr ? nullptr : &feed_->colors();
    };
    const auto* const first = colors_from("a", "0 0 0 0.5\n");
    ASSERT_NE(first, nullptr);
    EXPECT_NE(colors_from("b", "0 0 0 1.5\n"), first);
}

TEST_F(PictureFeedTest, DrawsAnotherViewOfTheSameText) {
    show("x = 0");
    document_.camera->eye *= 2.0;
    EXPECT_TRUE(feed_->submit(*wanted()));
    EXPECT_TRUE(feed_->tracing());
    EXPECT_FALSE(feed_->shows_newest());
    EXPECT_EQ(feed_->on_screen(), nullptr) << "what is on the screen has another camera";
    EXPECT_FALSE(feed_->waits_for().picture) << "it is of the same text";
    follow_until([&] { return feed_->drawn(); });
    EXPECT_EQ(feed_->on_screen()->camera, *document_.camera);
}

TEST_F(PictureFeedTest, WantsNoPictureWithoutACameraOrPixels) {
    show("x = 0");
    EXPECT_FALSE(feed_->wanted(document_, {}, {0, 16}));
    document_.camera.reset();
    EXPECT_FALSE(wanted());
}

TEST_F(PictureFeedTest, KeepsItsFormulaWhileTheTextIsWrong) {
    show("x = 0");
    const auto formula = feed_->formula();
    read("x = 0 +");
    follow_until([&] { return feed_->has_read(document_); });
    ASSERT_TRUE(reading_);
    EXPECT_TRUE(reading_->reading.reports.begin()->second.error);
    EXPECT_EQ(feed_->formula(), formula);
    EXPECT_TRUE(feed_->drawn());
}

TEST_F(PictureFeedTest, ReadsColoursByAFormula) {
    show("x = 0");
    document_.coloring = {ColorBy::Expression, "y + z"};
    feed_->read(document_);
    EXPECT_FALSE(feed_->has_read(document_));
    follow_until([&] { return feed_->has_read(document_) && feed_->drawn(); });
    EXPECT_EQ(feed_->colors().expression, "y + z");
    document_.coloring.map = ColorMap::Ember;
    feed_->read(document_);
    EXPECT_TRUE(feed_->has_read(document_)) << "a map needs no formula";
}

TEST_F(PictureFeedTest, HasCodeInDoubleMadeForADeepView) {
    show("x^2 + y^2 + z^2 = 1");
    const auto before = feed_->newest();
    Camera& camera = *document_.camera;
    const glm::dvec3 to_eye = camera.eye - camera.look_at;
    camera.look_at = {1.0, 0.0, 0.0};
    camera.eye = camera.look_at + 1e-9 * to_eye;
    EXPECT_FALSE(feed_->submit(*wanted())) << "there is no such code yet";
    EXPECT_EQ(feed_->newest(), before);
    EXPECT_FALSE(feed_->drawn());
    EXPECT_TRUE(feed_->waits_for().code);
    EXPECT_GT(feed_->waits_for().nodes, 0U);
    follow_until([&] { return feed_->drawn(); });
    EXPECT_GT(feed_->newest(), before);
    EXPECT_EQ(picture_->precision, Precision::Double);
}

}  // namespace
}  // namespace zeroset::test::picture_feed_test
