#include "app/desktop/recent_files.hpp"

#include "engine/export/file.hpp"

#include <fstream>
#include <system_error>
#include <utility>

namespace zeroset {

namespace fs = std::filesystem;

RecentFiles::RecentFiles(std::optional<fs::path> folder) {
    if (!folder) return;
    file_ = *folder / "recent";
    std::ifstream file(*file_);
    for (std::string line; paths_.size() < most && std::getline(file, line);) {
        if (!line.empty()) paths_.push_back(line);
    }
}

void RecentFiles::add(const fs::path& path) {
    std::error_code error;
    const std::string name = fs::absolute(path, error).lexically_normal().string();
    if (error || name.contains('\n')) return;
    std::erase(paths_, name);
    paths_.insert(paths_.begin(), name);
    if (paths_.size() > most) paths_.resize(most);
    if (!file_) return;
    fs::create_directories(file_->parent_path(), error);
    std::string text;
    for (const std::string& line : paths_)
        text += line + "\n";
    // A failure is ignored: the program works without the list.
    (void)write_text(file_->string(), text);
}

}  // namespace zeroset
