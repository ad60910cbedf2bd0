// Fields of files: each opened once, and errors where they are in the call.

#include "engine/language/expressions/field_files.hpp"

#include "engine/language/vocabulary/field_source.hpp"
#include "engine/noise/noise.hpp"

#include <gtest/gtest.h>

#include <expected>
#include <memory>

namespace zeroset::field_files_test {
namespace {

/// Opens everything but "missing".
class Source : public FieldSource {
public:
    [[nodiscard]] std::expected<std::shared_ptr<const Field>, FieldError> open(
        const FieldCall& call) const override {
        ++opened;
        if (call.file == "missing")
            return std::unexpected(FieldError{.reason = "not there", .hint = "", .at = call.file});
        return noise_field(NoiseWord::Noise, 0);
    }

    mutable int opened = 0;
};

TEST(FieldFiles, OpenEachCallOnce) {
    Notes notes;
    GraphValues values(notes);
    const Source source;
    FieldFiles files(&source, values);
    EXPECT_NE(files.field("volume(\"a\")", 0), nullptr);
    EXPECT_NE(files.field("volume(\"a\")", 20), nullptr);
    EXPECT_EQ(source.opened, 1);
}

TEST(FieldFiles, ShowErrorsWithinTheCall) {
    Notes notes;
    GraphValues values(notes);
    const Source source;
    EXPECT_EQ(FieldFiles(&source, values).field("volume(\"missing\")", 10), nullptr);
    EXPECT_EQ(values.failure().error().offset, 18U);
    EXPECT_EQ(FieldFiles(nullptr, values).field("volume(\"a\")", 10), nullptr);
    EXPECT_EQ(values.failure().error().reason, "no files are read here");
}

}  // namespace
}  // namespace zeroset::field_files_test
