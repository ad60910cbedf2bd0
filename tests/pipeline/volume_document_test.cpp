#include "pipeline/volume_document.hpp"

#include "pipeline/volume_source.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace zeroset::volume_document_test {
namespace {

std::vector<std::string> isovalues_in(const std::string& text) {
    const auto program = read_program(text, volume_source({}).get());
    if (!program) return {program.error().reason};
    std::vector<std::string> names;
    for (const auto& [name, volume] : isovalues(*program))
        names.push_back(name + " of " + std::string(volume->text()));
    return names;
}

TEST(Isovalues, AreTheParametersThatAVolumeIsComparedWith) {
    const std::vector<std::string> a{"a of volume(\"@bone\")"};
    EXPECT_EQ(isovalues_in("s = volume(\"@bone\"); s(x,y,z) = a"), a);
    EXPECT_EQ(isovalues_in("s = volume(\"@bone\"); a = s(x,y,z)"), a);
    EXPECT_EQ(isovalues_in("s = volume(\"@bone\"); max(s(x,y,z) - a, x) = 0"), a);
    EXPECT_EQ(isovalues_in("s = volume(\"@bone\"); s(x + b, y, z) = a"), a)
        << "b moves it, and is no value of it";
}

TEST(Isovalues, AreNotThereWithoutAVolume) {
    EXPECT_TRUE(isovalues_in("x^2 + y^2 = a").empty());
    EXPECT_TRUE(isovalues_in("s = volume(\"@bone\"); s(x,y,z) = 0.5").empty());
    EXPECT_TRUE(isovalues_in("s = volume(\"@bone\"); s(x,y,z) = w").empty());
}

}  // namespace
}  // namespace zeroset::volume_document_test
