#include "app/desktop/export_target.hpp"

#include <filesystem>
#include <system_error>

namespace zeroset {

std::string unused_file(const std::string& folder, const std::string& name,
                        const std::string& ending) {
    constexpr int most = 10'000;
    for (int number = 1; number < most; ++number) {
        const std::string suffix = number == 1 ? "" : "-" + std::to_string(number);
        const std::filesystem::path path = std::filesystem::path(folder) / (name + suffix + ending);
        std::error_code error;
        // A link that leads nowhere is there, too.
        const auto status = std::filesystem::symlink_status(path, error);
        if (status.type() == std::filesystem::file_type::not_found) return path.string();
    }
    return {};
}

}  // namespace zeroset
