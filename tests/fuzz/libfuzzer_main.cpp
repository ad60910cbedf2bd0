#include "tests/fuzz/language_target.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// The entry point of libFuzzer, with its name and types.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto complaint =
        zeroset::test::complaint_about({reinterpret_cast<const char*>(data), size});
    if (!complaint) return 0;
    std::fprintf(stderr, "%s\n", complaint->c_str());
    std::abort();
}
