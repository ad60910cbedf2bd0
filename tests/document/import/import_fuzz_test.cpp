// Cuts and changed bytes of each sample: every reader ends, with documents or with one line.

#include "document/import/import.hpp"
#include "tests/document/import/samples.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace zeroset::test::import_fuzz_test {
namespace {

void expect_an_answer(std::string_view file, const std::string& bytes) {
    const ImportFormat* const format = import_format(file);
    ASSERT_NE(format, nullptr);
    const ReadImport imported = format->read(bytes, {});
    if (imported) {
        EXPECT_FALSE(imported->documents.empty());
        for (const ImportedDocument& document : imported->documents)
            EXPECT_EQ(document.row_lines.size(), document.document.statements.size());
    } else {
        EXPECT_FALSE(imported.error().empty()) << bytes;
        EXPECT_FALSE(imported.error().contains('\n')) << bytes;
    }
}

TEST(ImportFuzz, CutsOfEachSample) {
    for (const Sample& sample : samples) {
        for (std::size_t end = 0; end < sample.bytes.size(); end += 7)
            expect_an_answer(sample.file, std::string(sample.bytes.substr(0, end)));
    }
}

TEST(ImportFuzz, ChangedBytesOfEachSample) {
    std::mt19937 random(20260101);
    constexpr std::string_view likely = "(){}[]<>#;=,.\"'\\0123456789eE+-*/^xyz\n\t";
    for (const Sample& sample : samples) {
        for (int round = 0; round < 60; ++round) {
            std::string bytes(sample.bytes);
            const int changes = 1 + static_cast<int>(random() % 6);
            for (int i = 0; i < changes; ++i) {
                const std::size_t at = random() % bytes.size();
                const char letter = likely[random() % likely.size()];
                switch (random() % 3) {
                    case 0: bytes[at] = letter; break;
                    case 1: bytes.insert(at, 1 + random() % 4, letter); break;
                    default: bytes.erase(at, 1 + random() % 20);
                }
            }
            expect_an_answer(sample.file, bytes);
        }
    }
}

TEST(ImportFuzz, EachSampleUnderEachName) {
    for (const Sample& name : samples) {
        for (const Sample& sample : samples)
            expect_an_answer(name.file, std::string(sample.bytes));
    }
}

}  // namespace
}  // namespace zeroset::test::import_fuzz_test
