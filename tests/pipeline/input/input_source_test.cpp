#include "pipeline/input/input_source.hpp"

#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace zeroset::test::input_source_test {
namespace {

TEST(InputSource, IsToldByTheFormOfATextWhereThereIsNoFile) {
    EXPECT_EQ(classify("x^2 + y^2 = 1").kind, InputKind::Formula);
    EXPECT_EQ(classify("").kind, InputKind::Formula);
    EXPECT_EQ(classify("x/y = z").kind, InputKind::Formula);
    EXPECT_EQ(classify("-").kind, InputKind::StandardInput);
    EXPECT_EQ(classify("@klein").kind, InputKind::Gallery);
    EXPECT_EQ(classify("a.zeroset.json").kind, InputKind::Document);
    EXPECT_EQ(classify("a.png").kind, InputKind::Document);
    EXPECT_EQ(classify("a.nrrd").kind, InputKind::Volume);
    EXPECT_EQ(classify("scan = volume(\"a.nrrd").kind, InputKind::Formula);
    EXPECT_EQ(classify("zeroset:abc").kind, InputKind::Shared);
}

TEST(InputSource, IsToldByTheFilesThatThereAre) {
    const TestFolder folder;
    const auto file = [&](const char* name) {
        const std::filesystem::path path = folder.path() / name;
        std::ofstream(path) << "x";
        return path.string();
    };
    EXPECT_EQ(classify(file("list.xyz123")).kind, InputKind::OtherFile);
    EXPECT_EQ(classify(file("a \"b\".nrrd")).kind, InputKind::Volume);
    EXPECT_EQ(classify(file("zitrus.jsurf")).kind, InputKind::OtherProgram);
    EXPECT_EQ(classify(folder.path().string()).kind, InputKind::Folder);
}

TEST(InputSource, LetsADocumentNameWhatIsBesideIt) {
    EXPECT_EQ(classify("scans/head.zeroset.json").volumes,
              (VolumeFolder{.folder = "scans", .closed = true}));
    EXPECT_EQ(classify("zeroset:abc").volumes, (VolumeFolder{.folder = {}, .closed = true}));
    EXPECT_EQ(classify("scan = volume(\"a.nrrd\")").volumes, VolumeFolder{});
}

}  // namespace
}  // namespace zeroset::test::input_source_test
