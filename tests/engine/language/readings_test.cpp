// Checks the files of readings/, which hold typed texts and how each must be read. A case is:
//
//   input, one line or more
//   => TEXT         the reading of a statement; one such line for each, in order
//   == TEXT         in place of "=> TEXT": the surface has the same graph as this text
//   ~~ WORDS        after these: a note with these words; one such line for each note, in order
//   !! OFFSET WORDS in place of all: an error at this byte whose reason or hint has these words
//   ?? OFFSET WORDS in place of all: an error that says the input is unfinished
//
// Lines that start with #, and empty lines between cases, are ignored.

#include "engine/expr/patch_graph.hpp"
#include "engine/language/parse.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset::readings_test {
namespace {

struct Case {
    std::string place;  ///< file:line
    std::string input;
    std::vector<std::string> expected;
};

bool is_expectation(std::string_view line) {
    return line.starts_with("=> ") || line.starts_with("== ") || line.starts_with("~~ ") ||
           line.starts_with("!! ") || line.starts_with("?? ");
}

void add_line(std::vector<Case>& cases, const std::string& line, const std::string& place) {
    const bool between = cases.empty() || !cases.back().expected.empty();
    if (is_expectation(line)) {
        ASSERT_FALSE(cases.empty()) << place;
        cases.back().expected.push_back(line);
    } else if (!between) {
        cases.back().input += "\n" + line;
    } else if (!line.empty() && !line.starts_with('#')) {
        cases.push_back({place, line, {}});
    }
}

std::vector<Case> cases_of(const std::filesystem::path& path) {
    std::vector<Case> cases;
    std::ifstream file(path);
    std::string line;
    for (int number = 1; std::getline(file, line); ++number)
        add_line(cases, line, path.filename().string() + ":" + std::to_string(number));
    return cases;
}

std::string shown(const std::expected<Program, ParseError>& program) {
    std::string text;
    if (program) {
        for (const Reading& reading : program->readings)
            text += "=> " + reading.text + "\n";
        for (const Reading& reading : program->readings) {
            for (const std::string& note : reading.notes)
                text += "~~ " + note + "\n";
        }
        return text;
    }
    const ParseError& error = program.error();
    return (error.unfinished ? "?? " : "!! ") + std::to_string(error.offset) + " " + error.reason +
           " | " + error.hint + "\n";
}

/// Returns the key of the surface's graph or, if there is none, a text that says why.
std::string graph_of(const std::string& text) {
    const auto program = read_program(text);
    if (!program) return "no graph: " + shown(program);
    return program->surfaces.front().key();
}

void expect_error(const Case& test, const std::expected<Program, ParseError>& program) {
    ASSERT_FALSE(program.has_value());
    const std::string& expected = test.expected.front();
    std::size_t end = 0;
    const std::size_t offset = std::stoul(expected.substr(3), &end);
    const std::string words = expected.substr(std::min(expected.size(), 3 + end + 1));
    const ParseError& error = program.error();
    EXPECT_EQ(error.offset, offset);
    EXPECT_EQ(error.unfinished, expected.starts_with("??"));
    EXPECT_NE((error.reason + "\n" + error.hint).find(words), std::string::npos);
    EXPECT_EQ(error.reason.find('\n'), std::string::npos);
}

void expect_readings(const Case& test, const std::expected<Program, ParseError>& program) {
    ASSERT_TRUE(program.has_value());
    std::vector<std::string> readings;
    for (const Reading& reading : program->readings)
        readings.push_back("=> " + reading.text);
    std::vector<std::string> expected = test.expected;
    std::erase_if(expected, [](const std::string& line) { return line.starts_with("~~ "); });
    EXPECT_EQ(readings, expected);
}

/// Expects exactly the notes of the case; usual notation gets none.
void expect_notes(const Case& test, const Program& program) {
    std::vector<std::string> notes;
    for (const Reading& reading : program.readings)
        notes.insert(notes.end(), reading.notes.begin(), reading.notes.end());
    std::vector<std::string> expected = test.expected;
    std::erase_if(expected, [](const std::string& line) { return !line.starts_with("~~ "); });
    ASSERT_EQ(notes.size(), expected.size());
    for (std::size_t i = 0; i < notes.size(); ++i) {
        EXPECT_TRUE(notes[i].contains(expected[i].substr(3))) << notes[i];
        EXPECT_FALSE(notes[i].contains('\n'));
        EXPECT_LE(notes[i].size(), 150) << notes[i];
    }
}

/// Expects that the reading of a surface, typed again, gives the same surface.
void expect_round_trip(const Program& program) {
    std::size_t surface = 0;
    for (const Reading& reading : program.readings) {
        if (reading.kind != StatementKind::Surface) continue;
        const Expr& drawn = program.surfaces[surface++];
        EXPECT_EQ(graph_of(reading.text), drawn.key()) << reading.text;
        // A point over the shares of its ranges cannot be typed.
        if (is_patch(drawn)) continue;
        EXPECT_EQ(graph_of(reading.text), graph_of(drawn.canonical())) << reading.text;
    }
}

void check(const Case& test) {
    const auto program = read_program(test.input);
    SCOPED_TRACE(test.place + "\n" + test.input + "\n" + shown(program));
    const std::string mark = test.expected.front().substr(0, 2);
    if (mark == "=>") {
        expect_readings(test, program);
    } else if (mark == "==") {
        ASSERT_TRUE(program.has_value());
        EXPECT_EQ(program->surfaces.front().key(), graph_of(test.expected.front().substr(3)));
    } else {
        expect_error(test, program);
    }
    if (program) expect_notes(test, *program);
    if (program && program->parameters.empty()) expect_round_trip(*program);
}

const std::filesystem::path folder = ZEROSET_SOURCE_DIR "/tests/engine/language/readings";

class Readings : public testing::TestWithParam<std::string> {};

TEST_P(Readings, AreAsExpected) {
    const std::vector<Case> cases = cases_of(folder / (GetParam() + ".txt"));
    EXPECT_GE(cases.size(), 20);
    for (const Case& test : cases)
        check(test);
}

/// The names of all files, without their ending.
std::vector<std::string> names_of_files() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.push_back(entry.path().stem().string());
    return names;
}

INSTANTIATE_TEST_SUITE_P(Files, Readings, testing::ValuesIn(names_of_files()),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace zeroset::readings_test
