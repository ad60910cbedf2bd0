// Tests of folders and files whose documents are chosen from by their pictures.

#include "document/json/collection.hpp"

#include "document/json/document_file.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace zeroset::test::collection_test {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view two_surfaces = R"({"MathModels": [
  {"Iso3D": {"Name": ["Ball"], "Fxyz": ["x*x + y*y + z*z - 1"],
             "Xmin": ["-2"], "Xmax": ["2"], "Ymin": ["-2"], "Ymax": ["2"],
             "Zmin": ["-2"], "Zmax": ["2"]}},
  {"Iso3D": {"Name": ["Plane"], "Fxyz": ["x"],
             "Xmin": ["-2"], "Xmax": ["2"], "Ymin": ["-2"], "Ymax": ["2"],
             "Zmin": ["-2"], "Zmax": ["2"]}}]})";

class Collections : public testing::Test {
protected:
    void write(const std::string& name, std::string_view text) {
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    void save(const std::string& name, const std::string& equation) {
        Document document = empty_document();
        document.statements[0].text = equation;
        ASSERT_TRUE(save_document(folder_ / name, document));
    }
    [[nodiscard]] std::string path_of(const std::string& name) const {
        return (folder_ / name).string();
    }

    TestFolder folder_;
};

TEST_F(Collections, HoldTheDocumentsOfAFolderByTheirNames) {
    save("b.zeroset.json", "x = 1");
    save("a.zeroset.json", "y = 2");
    save(".hidden.zeroset.json", "z = 3");
    write("b.png", "a picture beside its document is not read");
    write("notes.md", "x = 4");
    write("c.zeroset.json", "{ no document");
    write("d.js", two_surfaces);
    fs::create_directory(folder_ / "inner");
    const auto found = collection_at(path_of(""));
    ASSERT_TRUE(found) << found.error();
    const std::optional<Collection>& collection = *found;
    ASSERT_TRUE(collection);
    ASSERT_EQ(collection->items.size(), 4U);
    EXPECT_EQ(collection->unread, 1U);
    EXPECT_EQ(collection->items[0].title, "a");
    EXPECT_EQ(collection->items[0].path, path_of("a.zeroset.json"));
    EXPECT_EQ(collection->items[0].document.statements[0].text, "y = 2");
    EXPECT_EQ(collection->items[1].title, "b");
    EXPECT_EQ(collection->items[2].title, "Ball");
    EXPECT_EQ(collection->items[3].path, path_of("d.js#2"));
}

TEST_F(Collections, OfAFileOpenAsTheyAreNumbered) {
    write("two.js", two_surfaces);
    const auto chosen = collection_at(path_of("two.js#2"));
    ASSERT_TRUE(chosen) << chosen.error();
    EXPECT_FALSE(*chosen) << "it chooses one";
    const auto found = collection_at(path_of("two.js"));
    ASSERT_TRUE(found) << found.error();
    const std::optional<Collection>& collection = *found;
    ASSERT_TRUE(collection);
    EXPECT_EQ(collection->name, "two.js");
    ASSERT_EQ(collection->items.size(), 2U);
    for (const CollectionItem& item : collection->items) {
        const auto loaded = load_document(item.path);
        ASSERT_TRUE(loaded) << loaded.error();
        EXPECT_TRUE(same_work(loaded->document, item.document)) << item.path;
    }
}

TEST_F(Collections, AreNoFilesOfOneDocumentAndNoTexts) {
    save("one.zeroset.json", "x = 1");
    write("one.txt", "x^2 + y^2 + z^2 = 1");
    for (const std::string& path :
         {path_of("one.zeroset.json"), path_of("one.txt"), std::string("x^2 + y^2 = 1")}) {
        const auto found = collection_at(path);
        ASSERT_TRUE(found) << found.error();
        EXPECT_FALSE(*found) << path;
    }
    EXPECT_FALSE(collection_at("nowhere/two.js"));
}

TEST_F(Collections, SayWhyThereIsNone) {
    fs::create_directory(folder_ / "empty");
    const auto empty = collection_at(path_of("empty"));
    ASSERT_FALSE(empty);
    EXPECT_TRUE(empty.error().ends_with("there is no document in this folder")) << empty.error();
    const auto nowhere = collection_at(path_of("nowhere.js"));
    ASSERT_FALSE(nowhere);
    EXPECT_TRUE(nowhere.error().contains("there is no such file")) << nowhere.error();
}

}  // namespace
}  // namespace zeroset::test::collection_test
