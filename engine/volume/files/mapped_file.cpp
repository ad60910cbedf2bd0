#include "engine/volume/files/mapped_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <limits>
#include <system_error>

namespace zeroset {
namespace {

/// Where a mapped file lies. A handler of signals reads it, so it has no lock.
struct Place {
    std::atomic<bool> taken = false;
    std::atomic<std::uintptr_t> begin = 0;
    std::atomic<std::uintptr_t> end = 0;  ///< 0: there is no file yet, or none any more
};

constexpr std::size_t most_places = 4096;
constexpr std::size_t no_slot = std::numeric_limits<std::size_t>::max();

std::array<Place, most_places>& places() {
    static constinit std::array<Place, most_places> all;
    return all;
}

/// Takes a place for a file's bytes; where none is free, fill_lost_pages does not know of the file.
std::size_t take_slot(std::span<const std::byte> bytes) {
    const auto free = std::ranges::find_if(places(), [](Place& place) {
        bool is_taken = false;
        return place.taken.compare_exchange_strong(is_taken, true);
    });
    if (free == places().end()) return no_slot;
    const auto begin = reinterpret_cast<std::uintptr_t>(bytes.data());
    free->begin = begin;
    free->end = begin + bytes.size();
    return static_cast<std::size_t>(free - places().begin());
}

void give_slot_back(std::size_t slot) {
    if (slot == no_slot) return;
    places().at(slot).end = 0;
    places().at(slot).taken = false;
}

/// The end of the mapped file that has the address; 0 where none has.
std::uintptr_t end_behind(const void* address) noexcept {
    const auto at = reinterpret_cast<std::uintptr_t>(address);
    for (const Place& place : places()) {
        const std::uintptr_t end = place.end;
        // The end that is still there: the place was not given to another file meanwhile.
        if (at >= place.begin && at < end && place.end == end) return end;
    }
    return 0;
}

std::unexpected<std::string> cannot_open(int reason) {
    return std::unexpected("it cannot be read: " + std::generic_category().message(reason));
}

}  // namespace

std::expected<std::shared_ptr<const MappedFile>, std::string> MappedFile::open(
    const std::filesystem::path& path) {
    std::error_code error;
    const std::uint64_t size = std::filesystem::file_size(path, error);
    if (error) return std::unexpected("it cannot be read: " + error.message());
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return cannot_open(errno);
    void* const data = size == 0 ? nullptr : ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    const int reason = errno;
    ::close(file);
    if (data == MAP_FAILED) return cannot_open(reason);
    const std::span bytes(static_cast<const std::byte*>(data), size);
    return std::shared_ptr<const MappedFile>(new MappedFile(bytes));
}

MappedFile::MappedFile(std::span<const std::byte> bytes) : bytes_(bytes), slot_(take_slot(bytes)) {}

MappedFile::~MappedFile() {
    give_slot_back(slot_);
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): munmap takes no const
    if (!bytes_.empty()) ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
}

bool is_mapped(const void* address) noexcept { return end_behind(address) != 0; }

bool fill_lost_pages(const void* address) noexcept {
    const std::uintptr_t end = end_behind(address);
    if (end == 0) return false;
    const auto at = reinterpret_cast<std::uintptr_t>(address);
    const std::uintptr_t begin = at - at % static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
    // NOLINTNEXTLINE(performance-no-int-to-ptr): a page has no other name
    void* const wanted = reinterpret_cast<void*>(begin);
    return ::mmap(wanted, end - begin, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0) ==
           wanted;
}

}  // namespace zeroset
