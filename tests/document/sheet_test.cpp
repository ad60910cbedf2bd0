// Tests of reading rows together, and of the effect of a wrong row on the others.

#include "document/sheet.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace zeroset::test::sheet_test {
namespace {

class Sheets : public testing::Test {
protected:
    /// Reads these texts as rows with the ids 1, 2, ...
    const SheetReading& read(const std::vector<std::string>& texts, bool draws_old = true) {
        Sheet sheet;
        for (const std::string& text : texts)
            sheet.push_back({static_cast<int>(sheet.size()) + 1, text});
        reading_ = reader_.read(sheet, nullptr, draws_old);
        return reading_;
    }
    std::string reading(int row) {
        const auto& readings = reading_.reports.at(row).readings;
        return readings.empty() ? "" : readings.front().text;
    }
    const RowError& error(int row) { return *reading_.reports.at(row).error; }

    SheetReader reader_;
    SheetReading reading_;
};

TEST_F(Sheets, ReportEachRow) {
    read({"a = 2", "f(u) = u^2", "", "f(x) + f(y) = a b", "# remark", "x = 1; y = 2"});
    EXPECT_EQ(reading_.surface_rows, (std::vector{4, 6, 6}));
    EXPECT_EQ(reading_.program->parameters, (std::vector<std::string>{"b"}));
    EXPECT_EQ(reading(1), "a = 2");
    EXPECT_EQ(reading(3), "");
    EXPECT_EQ(reading(5), "");
    EXPECT_EQ(reading_.reports.at(6).readings.size(), 2U);
    for (const auto& [id, report] : reading_.reports)
        EXPECT_FALSE(report.error) << id;
    EXPECT_TRUE(read_program(reading_.text));
}

TEST_F(Sheets, MarkTheErrorWithinItsRow) {
    read({"x^2 + y^2 = 1", "y + @ = 2"});
    EXPECT_EQ(error(2).at, 4U);
    EXPECT_FALSE(error(2).unfinished);
    EXPECT_EQ(reading_.surface_rows, std::vector{1}) << "the others are drawn";
}

TEST_F(Sheets, SayWhatAnUnknownNameIsLikelyMeantAs) {
    read({"x = 1", "y = sinn x", "z = ksin + 1", "w = sqt(x)", "y = wxyzq + 1"});
    EXPECT_EQ(error(2).mend, (Mend{.word = "sinn", .by = "sin"}));
    EXPECT_EQ(reading_.reports.at(2).text.substr(error(2).at, 4), "sinn");
    EXPECT_EQ(error(4).mend, (Mend{.word = "sqt", .by = "sqrt"}));
    EXPECT_EQ(error(5).mend, std::nullopt);
    read({"y = (x"});
    EXPECT_EQ(error(1).mend, std::nullopt);
}

TEST_F(Sheets, MarkTheErrorsOfAllRows) {
    read({"x + * y", "y = 1", "z = )", "a = 3"});
    EXPECT_TRUE(reading_.reports.at(1).error);
    EXPECT_FALSE(reading_.reports.at(2).error);
    EXPECT_TRUE(reading_.reports.at(3).error);
    EXPECT_EQ(reading(4), "a = 3");
    EXPECT_EQ(reading_.surface_rows, std::vector{2});
}

TEST_F(Sheets, LetTheLastGoodTextStandIn) {
    read({"a = 2", "x^2 + y^2 = a"});
    read({"a = 2 +", "x^2 + y^2 = a"});
    EXPECT_TRUE(error(1).unfinished);
    EXPECT_EQ(error(1).at, 7U);
    EXPECT_TRUE(reading_.program->parameters.empty()) << "a is still a constant";
    EXPECT_EQ(reading(1), "a = 2");
    EXPECT_EQ(reading_.surface_rows, std::vector{2});
    read({"a = 2 + b", "x^2 + y^2 = a"});
    EXPECT_FALSE(reading_.reports.at(1).error);
    EXPECT_EQ(reading_.program->parameters, (std::vector<std::string>{"b"}));
}

TEST_F(Sheets, ForgetWhatTheyDrewOnRequest) {
    read({"b = 2", "z = s i b", "x = 1"});
    read({"b = 2 +", "z = sin(", "x = 1"});
    EXPECT_EQ(reading_.program->parameters, (std::vector<std::string>{"s", "i"}));
    EXPECT_EQ(reading_.surface_rows, (std::vector{2, 3}));
    read({"b = 2 +", "z = sin(", "x = b"}, false);
    EXPECT_TRUE(reading_.program->parameters.empty()) << "b = 2 stands in";
    EXPECT_EQ(reading_.surface_rows, std::vector{3});
    EXPECT_TRUE(error(1).unfinished && error(2).unfinished);
    read({"b = 2 +", "z = sin(x", "x = b"});
    EXPECT_EQ(reading_.surface_rows, std::vector{3}) << "it is gone until the row is right";
    read({"b = 2 +", "z = sin(x)", "x = b"});
    EXPECT_EQ(reading_.surface_rows, (std::vector{2, 3}));
}

TEST_F(Sheets, LeaveOutALastGoodTextThatFitsNoMore) {
    read({"a = 2", "b = 3; x = a b"});
    read({"b = 2 +", "b = 3; x = a b"});
    EXPECT_TRUE(reading_.reports.at(1).error);
    EXPECT_EQ(reading_.surface_rows, std::vector{2});
    EXPECT_TRUE(reading_.program->parameters.empty()) << "a = 2 stands in";
    read({"b = 5 +", "x = * b"});
    EXPECT_TRUE(reading_.reports.at(1).error);
    EXPECT_EQ(error(2).at, 4U);
}

TEST_F(Sheets, TakeTheLastOfTwoDefinitions) {
    read({"b = 5", "b = 3; x = b"});
    EXPECT_FALSE(reading_.reports.at(1).error);
    EXPECT_FALSE(reading_.reports.at(2).error);
    EXPECT_EQ(reading_.reports.at(2).readings.back().text, "x - 3 = 0");
    EXPECT_EQ(reading_.reports.at(2).readings.front().notes.size(), 1U);
    EXPECT_TRUE(reading_.reports.at(1).readings.front().notes.empty());
}

TEST_F(Sheets, HaveTheNotesOfTheirRows) {
    read({"r = 0.5", "x^2 + y^2 = r^2", "0,5 z = 1"});
    EXPECT_EQ(reading(1), "r = 0.5");
    EXPECT_TRUE(reading_.reports.at(1).readings.front().notes.front().contains("built-in r"));
    EXPECT_TRUE(reading_.reports.at(2).readings.front().notes.empty());
    EXPECT_TRUE(reading_.reports.at(3).readings.front().notes.front().contains("0.5"));
    read({"r = 0.5", "x^2 + y^2 = 1"});
    EXPECT_EQ(reading(1), "sqrt(x^2 + y^2 + z^2) - 0.5 = 0") << "nothing uses r any more";
}

TEST_F(Sheets, CutWhatTheirRowsDraw) {
    const auto surfaces = [](const std::optional<Box>& box) {
        const Sheet sheet{{.id = 1, .text = "x = 1"},
                          {.id = 2, .text = "y = 2 # remark", .box = box}};
        return SheetReader().read(sheet);
    };
    const SheetReading plain = surfaces(std::nullopt);
    const SheetReading cut = surfaces(Box::cube(1.0));
    EXPECT_EQ(cut.surface_texts, plain.surface_texts);
    EXPECT_EQ(cut.program->surfaces[0].key(), plain.program->surfaces[0].key());
    EXPECT_NE(cut.program->surfaces[1].key(), plain.program->surfaces[1].key());
    EXPECT_NE(cut.text, plain.text) << "texts tell formulas apart";
    EXPECT_NE(cut.text, surfaces(Box::cube(1.5)).text);
    EXPECT_TRUE(read_program(cut.text));
}

TEST_F(Sheets, GoOnWithinARowBehindALineThatCouldEnd) {
    for (const std::string sign : {"+", "-", "\u2212", "  +", "\t-", "\r+"}) {
        read({"x^2 + y^2\n" + sign + " z^2 = 1", "y = 2"});
        EXPECT_EQ(reading_.surface_rows, (std::vector{1, 2})) << sign;
        EXPECT_EQ(reading_.reports.at(1).readings.size(), 1U) << sign;
        EXPECT_TRUE(read_program(reading_.text)) << "the text says the same by itself";
    }
    read({"x^2 // one\n+ y^2 // two\n- z = 1 # three"});
    EXPECT_EQ(reading(1), "x^2 + y^2 - z - 1 = 0");
    read({"x = 1\n-y = 2"});
    EXPECT_EQ(reading_.reports.at(1).readings.size(), 2U) << "two equations";
    read({"x\n\n-y"});
    EXPECT_EQ(reading_.reports.at(1).readings.size(), 2U) << "an empty line parts them";
    read({"a = 2", "-x + y = a", "+ z"});
    EXPECT_EQ(reading_.surface_rows, (std::vector{2, 3})) << "rows are apart";
}

TEST_F(Sheets, MarkTheErrorBehindAJoinedLine) {
    read({"x^2\n+ * y", "y = 1"});
    EXPECT_EQ(error(1).at, 6U);
    EXPECT_EQ(reading_.surface_rows, std::vector{2});
}

TEST_F(Sheets, KeepAnOpenRemarkInItsRow) {
    read({"x = 1 /* more", "y = 1"});
    EXPECT_TRUE(error(1).unfinished);
    EXPECT_EQ(error(1).at, 6U);
    EXPECT_EQ(reading_.surface_rows, std::vector{2});
}

TEST_F(Sheets, TakeAListOfInstructionsInOneRow) {
    read({"a var-x\nb const 2\nc mul a b", "y = a"});
    EXPECT_EQ(reading(1), "x*2 = 0");
    EXPECT_EQ(reading_.surface_rows, (std::vector{1, 2}));
    EXPECT_EQ(reading_.program->parameters, (std::vector<std::string>{"a"}))
        << "its names are its own";
}

TEST_F(Sheets, DoNotGoOnInTheNextRow) {
    read({"x^2 +", "y = 1"});
    EXPECT_TRUE(error(1).unfinished);
    EXPECT_EQ(error(1).at, 5U);
    EXPECT_FALSE(reading_.reports.at(2).error);
    read({"x^2 + # more", "y = 1"});
    EXPECT_TRUE(reading_.reports.at(1).error);
}

TEST_F(Sheets, MayHaveNoSurface) {
    for (const auto& rows : {std::vector<std::string>{}, {""}, {"", "  "}, {"# only a remark"}}) {
        read(rows);
        EXPECT_EQ(reading_.surface_rows, std::vector{0});
        EXPECT_TRUE(read_program(reading_.text));
    }
    read({"a = 2 c", "f(u) = u"});
    EXPECT_EQ(reading_.surface_rows, std::vector{0});
    EXPECT_EQ(reading(2), "f(u) = u");
    EXPECT_FALSE(reading_.reports.at(1).error);
}

TEST_F(Sheets, EndWithManyErrors) {
    read(std::vector<std::string>(200, "x + *"));
    EXPECT_EQ(reading_.surface_rows, std::vector{0});
    EXPECT_TRUE(reading_.reports.at(1).error);
}

}  // namespace
}  // namespace zeroset::test::sheet_test
