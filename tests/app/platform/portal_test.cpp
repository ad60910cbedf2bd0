#include "app/platform/portal.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>

// The connection to a portal is tested on a real bus: tests/end_to_end/portal_test.py.

namespace zeroset::test::portal_test {
namespace {

TEST(Portal, FindsThePathInAUri) {
    EXPECT_EQ(path_of_uri("file:///home/a/b.json"), "/home/a/b.json");
    EXPECT_EQ(path_of_uri("file:///a%20b%C3%A9%25"), "/a b\u00e9%");
    EXPECT_EQ(uri_of_path("/a b\u00e9%"), "file:///a%20b%C3%A9%25");
    EXPECT_EQ(path_of_uri(uri_of_path("/home/a_b/c-1.png")), "/home/a_b/c-1.png");
    EXPECT_EQ(path_of_uri("file://host/a"), "/a");
    for (const char* wrong : {"", "/a", "http://a/b", "file://", "file:///%", "file:///%2",
                              "file:///%2x", "file:///%00"}) {
        EXPECT_FALSE(path_of_uri(wrong)) << wrong;
    }
}

TEST(Portal, SaysWhereThereIsNoBus) {
    ::setenv("DBUS_SESSION_BUS_ADDRESS", "unix:path=/dev/null", 1);
    std::mutex mutex;
    std::condition_variable changed;
    bool told = false;
    Portal portal([&] {
        const std::scoped_lock lock(mutex);
        told = true;
        changed.notify_one();
    });
    portal.ask({});
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return told; });
    const auto answer = portal.take_answer();
    ASSERT_TRUE(answer);
    EXPECT_FALSE(answer->asked);
    EXPECT_FALSE(portal.take_answer());
    EXPECT_FALSE(portal.take_wish());
}

}  // namespace
}  // namespace zeroset::test::portal_test
