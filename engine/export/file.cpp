#include "engine/export/file.hpp"

#include "engine/export/png.hpp"

#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <mutex>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

namespace fs = std::filesystem;

std::unexpected<FileError> cannot_write(const fs::path& path, const std::string& reason) {
    return std::unexpected(FileError{"cannot write '" + path.string() + "': " + reason});
}

/// A temporary name in the folder of `path` that no other process uses.
fs::path beside(const fs::path& path) {
    fs::path temporary = path;
    temporary += "." + std::to_string(::getpid()) + ".part";
    return temporary;
}

/// Files that are written but not renamed yet. Holding the mutex keeps all threads from beginning
/// and from renaming one.
struct Unfinished {
    std::mutex mutex;
    std::vector<fs::path> files;
};

Unfinished& unfinished() {
    static Unfinished instance;
    return instance;
}

/// A new file, which the destructor removes unless keep_as has renamed it.
class NewFile {
public:
    explicit NewFile(fs::path path) : path_(std::move(path)) {
        const std::scoped_lock lock(unfinished().mutex);
        unfinished().files.push_back(path_);
        stream_.open(path_, std::ios::binary);
    }
    ~NewFile() {
        const std::scoped_lock lock(unfinished().mutex);
        std::erase(unfinished().files, path_);
        std::error_code ignored;
        if (!kept_) fs::remove(path_, ignored);
    }
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    std::ofstream& stream() { return stream_; }
    std::error_code keep_as(const fs::path& path) {
        const std::scoped_lock lock(unfinished().mutex);
        std::error_code error;
        fs::rename(path_, path, error);
        kept_ = !error;
        return error;
    }

private:
    fs::path path_;
    std::ofstream stream_;
    bool kept_ = false;
};

/// Whether all bytes were written.
bool write_all(std::ofstream& file, std::span<const std::byte> bytes) {
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    file.close();
    return static_cast<bool>(file);
}

std::string last_error() { return std::generic_category().message(errno); }

}  // namespace

std::expected<void, FileError> check_writable(const fs::path& path) {
    if (path.empty()) return cannot_write(path, "the name is empty");
    if (fs::is_directory(path)) return cannot_write(path, "it is a directory; name a file in it");
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder)) {
        return cannot_write(path, "the folder '" + folder.string() + "' does not exist");
    }
    if (::access(folder.c_str(), W_OK) != 0) return cannot_write(path, last_error());
    return {};
}

std::expected<void, FileError> write_file(const fs::path& path, std::span<const std::byte> bytes) {
    if (auto writable = check_writable(path); !writable) return writable;
    // A device such as /dev/stdout cannot be replaced by a rename: write into it.
    if (fs::exists(path) && !fs::is_regular_file(path)) {
        std::ofstream device(path, std::ios::binary);
        if (!write_all(device, bytes)) return cannot_write(path, last_error());
        return {};
    }
    NewFile file(beside(path));
    if (!write_all(file.stream(), bytes)) return cannot_write(path, last_error());
    if (const auto error = file.keep_as(path)) return cannot_write(path, error.message());
    return {};
}

void abandon_files() {
    unfinished().mutex.lock();  // never unlocked
    for (const fs::path& file : unfinished().files) {
        std::error_code ignored;
        fs::remove(file, ignored);
    }
}

std::expected<void, FileError> write_png(const fs::path& path, const Framebuffer& frame) {
    std::vector<unsigned char> rgb(frame.color.size() * 3);
    unsigned char* out = rgb.data();
    for (const std::uint32_t pixel : frame.color) {
        for (const unsigned shift : {0U, 8U, 16U})
            *out++ = static_cast<unsigned char>((pixel >> shift) & 0xFFU);
    }
    const std::vector<std::byte> bytes = encoded_png(rgb.data(), frame.width, frame.height, 3);
    if (bytes.empty()) return cannot_write(path, "the PNG encoder failed");
    return write_file(path, bytes);
}

std::expected<void, FileError> write_png(const fs::path& path, const RgbaImage& image) {
    const std::vector<std::byte> bytes = png_of(image);
    if (bytes.empty()) return cannot_write(path, "the PNG encoder failed");
    return write_file(path, bytes);
}

std::expected<void, FileError> write_pfm(const fs::path& path, const Framebuffer& frame) {
    static_assert(std::endian::native == std::endian::little);
    const std::string header =
        "Pf\n" + std::to_string(frame.width) + " " + std::to_string(frame.height) + "\n-1.0\n";
    std::vector<std::byte> bytes(header.size() + frame.depth.size() * sizeof(float));
    std::memcpy(bytes.data(), header.data(), header.size());
    std::byte* out = bytes.data() + header.size();
    const std::size_t row_bytes = static_cast<std::size_t>(frame.width) * sizeof(float);
    for (int row = frame.height; row-- > 0;) {
        std::memcpy(out, frame.depth.data() + frame.index(0, row), row_bytes);
        out += row_bytes;
    }
    return write_file(path, bytes);
}

std::expected<void, FileError> write_text(const std::string& path, const std::string& text) {
    if (path != "-") return write_file(path, std::as_bytes(std::span(text)));
    std::cout << text << std::flush;
    if (!std::cout) return std::unexpected(FileError{"cannot write to standard output"});
    return {};
}

}  // namespace zeroset
