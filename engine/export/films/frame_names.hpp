#pragma once

#include <expected>
#include <filesystem>
#include <optional>
#include <string>

namespace zeroset {

/// The names of numbered frames: "frames/f####.png", where the last run of # stands for the number
/// with as many digits, or more where it needs them.
class FrameNames {
public:
    /// Nothing where the file name has no #.
    static std::optional<FrameNames> from(const std::filesystem::path& pattern);
    [[nodiscard]] std::filesystem::path path(int number) const;

private:
    std::string before_, after_;
    std::size_t digits_ = 1;
};

}  // namespace zeroset
