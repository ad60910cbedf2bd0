// The main function of the programs of tests: that of GoogleTest, with one more way to choose.

#include <gtest/gtest.h>

#include <iostream>
#include <string>
#include <string_view>

namespace zeroset::test {
namespace {

constexpr std::string_view option = "--file=";

/// The filter that takes all cases of a source file, a path that ends as theirs; empty if there are
/// none.
std::string filter_of(std::string_view file) {
    std::string filter;
    const testing::UnitTest& tests = *testing::UnitTest::GetInstance();
    for (int s = 0; s < tests.total_test_suite_count(); ++s) {
        const testing::TestSuite& suite = *tests.GetTestSuite(s);
        for (int i = 0; i < suite.total_test_count(); ++i) {
            const testing::TestInfo& test = *suite.GetTestInfo(i);
            if (!std::string_view(test.file()).ends_with(file)) continue;
            filter += std::string(suite.name()) + '.' + test.name() + ':';
        }
    }
    return filter;
}

int run(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        if (!argument.starts_with(option)) continue;
        const std::string filter = filter_of(argument.substr(option.size()));
        if (filter.empty()) {
            std::cerr << "no test of this program is in " << argument.substr(option.size()) << '\n';
            return EXIT_FAILURE;
        }
        testing::GTEST_FLAG(filter) = filter;
    }
    return RUN_ALL_TESTS();
}

}  // namespace
}  // namespace zeroset::test

int main(int argc, char** argv) { return zeroset::test::run(argc, argv); }
