#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// Paths of the documents used last, the newest first; kept in a file of the state folder.
class RecentFiles {
public:
    static constexpr std::size_t most = 10;

    explicit RecentFiles(std::optional<std::filesystem::path> folder);
    [[nodiscard]] const std::vector<std::string>& paths() const { return paths_; }
    void add(const std::filesystem::path& path);

private:
    std::optional<std::filesystem::path> file_;
    std::vector<std::string> paths_;
};

}  // namespace zeroset
