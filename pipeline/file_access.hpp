#pragma once

#include "engine/base/file_stamp.hpp"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <set>
#include <vector>

namespace zeroset {

/// The files that documents may read though they lie outside their folders, and those that were
/// read, which other programs may change meanwhile: of one window, or of one command. Thread-safe.
class FileAccess {
public:
    /// Allows a file that someone has chosen, wherever it lies.
    void allow(const std::filesystem::path& file);
    /// Whether that was allowed; `file` is kept for take_refused() where it was not.
    bool allows(const std::filesystem::path& file);
    /// The files that were refused since the last call.
    std::vector<std::filesystem::path> take_refused();

    /// Says from which files something has been read, as they were then; they are looked at while
    /// it lives.
    void note_read(const std::shared_ptr<const void>& what, std::vector<FileStamp> files);
    /// Looks at all these files, from time to time. True if those of something have changed since
    /// it was read and all are as they were at the last call, so that no one is still writing them;
    /// of each change once. version() has grown then.
    bool look_for_changes();

    /// FieldSource::version() of the sources that read by this.
    [[nodiscard]] std::uint64_t version() const { return version_; }

private:
    /// Something that was read from files.
    struct ReadThing {
        std::weak_ptr<const void> what;
        std::vector<FileStamp>
            told;  ///< as they were when read, or at the last change that was told
        std::vector<FileStamp> latest;  ///< as they were when they were looked at last

        /// Looks at the files.
        bool has_changed();
    };

    std::atomic<std::uint64_t> version_ = 0;
    std::mutex allowed_mutex_;
    std::set<std::filesystem::path> allowed_;  ///< without links, as `refused_`
    std::set<std::filesystem::path> refused_;  ///< since they were last taken
    std::mutex things_mutex_;                  ///< held while files are looked at
    std::vector<ReadThing> things_;
};

/// The path without links and dots, as far as its folders exist.
std::filesystem::path real_path(const std::filesystem::path& file);

}  // namespace zeroset
