#pragma once

#include "pipeline/file_access.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {

/// Asks whether a document that comes from elsewhere may read volumes outside its folder. Each file
/// is asked about once. One thread owns it.
class VolumePermission {
public:
    explicit VolumePermission(std::shared_ptr<FileAccess> files) : files_(std::move(files)) {}

    /// The question about files that texts have named since, or nothing. It waits for its answer.
    std::optional<std::string> question();
    void answer(bool allow);
    /// Another document may be asked about all files again.
    void forget();

private:
    std::shared_ptr<FileAccess> files_;
    std::set<std::filesystem::path> asked_;
    std::vector<std::filesystem::path> waiting_;
};

}  // namespace zeroset
