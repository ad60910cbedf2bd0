#include "document/look.hpp"

#include "document/history.hpp"
#include "document/json/document_json.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace zeroset::test::look_test {
namespace {

Document marked_document() {
    Document document = empty_document();
    add_marker(document.markers, {0.1, -2, 3});
    add_marker(document.markers, {1.0 / 3.0, 0, 1e-17});
    return document;
}

TEST(Markers, AreNumberedOn) {
    std::vector<Marker> markers;
    EXPECT_EQ(add_marker(markers, {1, 2, 3}), 1);
    EXPECT_EQ(add_marker(markers, {4, 5, 6}), 2);
    remove_marker(markers, 1);
    EXPECT_EQ(add_marker(markers, {7, 8, 9}), 3);
    ASSERT_EQ(markers.size(), 2U);
    EXPECT_EQ(find_marker(markers, 1), nullptr);
    EXPECT_EQ(find_marker(markers, 2)->at, glm::dvec3(4, 5, 6));
    markers.resize(most_markers);
    EXPECT_EQ(add_marker(markers, {0, 0, 0}), 0);
}

TEST(Markers, AreKeptByFiles) {
    const Document document = marked_document();
    const auto read = document_from(text_of(document));
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->document.markers, document.markers);
    EXPECT_TRUE(read->unknown.empty());
    EXPECT_FALSE(text_of(empty_document()).contains("markers"));
}

TEST(Markers, AreStepsOfUndo) {
    Document document = empty_document();
    History history(document);
    for (unsigned click = 1; click <= 3; ++click) {
        add_marker(document.markers, {static_cast<double>(click), 0, 0});
        history.follow(document, 0.1 * click, click);
    }
    remove_marker(document.markers, 2);
    history.follow(document, 5.0, 4);
    EXPECT_EQ(history.undo().markers.size(), 3U);
    EXPECT_EQ(history.undo().markers.size(), 2U);
    EXPECT_EQ(history.undo().markers.size(), 1U);
    EXPECT_EQ(history.redo().markers.size(), 2U);
}

TEST(Coloring, IsKeptByFilesAndUndo) {
    Document document = empty_document();
    document.coloring = {ColorBy::Expression, "x^2 + a", ColorMap::Cycle, ValueRange{-0.1, 2.5}};
    const auto read = document_from(text_of(document));
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->document.coloring, document.coloring);
    EXPECT_TRUE(read->unknown.empty());

    History history(empty_document());
    history.follow(document, 0.0, 1);
    EXPECT_EQ(history.undo().coloring, ColorChoice());
    EXPECT_EQ(history.redo().coloring, document.coloring);
}

std::string why(const std::string& fields) {
    const auto read =
        document_from(R"({"zeroset": 1, "statements": [{"text": "x"}], )" + fields + "}");
    return read ? "" : read.error();
}

TEST(Coloring, SaysWhatIsDamaged) {
    EXPECT_EQ(why(R"("color": {"by": "normal"})"), "");
    EXPECT_EQ(why(R"("color": {})"), "it is damaged: color.by is missing");
    EXPECT_EQ(why(R"("color": {"by": "taste"})"),
              "it is damaged: color.by is nothing that surfaces are colored by");
    EXPECT_EQ(why(R"("color": {"by": "height", "map": "jet"})"),
              "it is damaged: color.map is no color map");
    EXPECT_EQ(why(R"("color": {"by": "height", "range": [1, 1]})"),
              "it is damaged: color.range is empty");
    EXPECT_EQ(why(R"("markers": {})"), "it is damaged: markers is no list");
    EXPECT_EQ(why(R"("markers": [{"number": 0, "at": [1, 2, 3]}])"),
              "it is damaged: markers[0].number is no whole number from 1 to 1000000");
    EXPECT_EQ(why(R"("markers": [{"number": 2, "at": [1, 2, 3]}, {"number": 2, "at": [1, 2, 3]}])"),
              "it is damaged: markers[1].number is that of another marker");
    EXPECT_EQ(why(R"("markers": [{"number": 1, "at": [1, 2]}])"),
              "it is damaged: markers[0].at is no list of 3 numbers");
}

TEST(NumberText, HasAsManyDecimalsAsAreKnown) {
    EXPECT_EQ(number_text(0.577350269, 1e-3), "0.577");
    EXPECT_EQ(number_text(0.577350269, 2e-3), "0.577");
    EXPECT_EQ(number_text(2.5, 1e-9), "2.5");
    EXPECT_EQ(number_text(-1e-9, 1e-3), "0");
    EXPECT_EQ(number_text(1234.56, 10), "1235");
    EXPECT_EQ(number_text(0.1), "0.1");
    EXPECT_EQ(number_text(1.0 / 3.0), "0.3333333333333333");
    EXPECT_EQ(number_text(1e12, 1e-3), "1e+12");
    EXPECT_EQ(coordinates_text({1, -0.5, 2e-17}, 1e-4), "(1, -0.5, 0)");
}

}  // namespace
}  // namespace zeroset::test::look_test
