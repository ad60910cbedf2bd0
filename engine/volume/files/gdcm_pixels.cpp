#include "engine/base/module.hpp"
#include "engine/volume/files/dicom_packed.hpp"
#include "engine/volume/files/gdcm_module.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <new>

// Debian's GDCM ends the process by an assertion at many a file that is wrong. So it reads in a
// child, and the samples come back in memory that both share. GDCM is loaded only here, as it takes
// as long as the rest of the program's start: it is in a module, gdcm_module.cpp.

namespace zeroset {
namespace {

using Pixels = std::expected<DicomPixels, std::string>;

/// Nothing is unpacked to more than so many times the file's bytes.
constexpr std::uint64_t best_ratio = 1U << 13U;
constexpr std::uint64_t most_samples = std::uint64_t{1} << 28U;
constexpr std::uint64_t spare = std::uint64_t{1} << 28U;  ///< bytes for what GDCM makes besides
constexpr unsigned most_seconds = 60;

/// Memory that a child shares.
class SharedMemory {
public:
    explicit SharedMemory(std::size_t bytes)
        : bytes_(bytes),
          memory_(mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                       MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0)) {}
    SharedMemory(const SharedMemory&) = delete;
    SharedMemory& operator=(const SharedMemory&) = delete;
    ~SharedMemory() {
        if (is_there()) munmap(memory_, bytes_);
    }
    [[nodiscard]] bool is_there() const { return memory_ != MAP_FAILED; }
    [[nodiscard]] char* data() const { return static_cast<char*>(memory_); }

private:
    std::size_t bytes_;
    void* memory_;
};

/// The module's function, or why there is none.
std::expected<UnpackByGdcm, std::string> loaded_module() {
    const auto function = load_module(gdcm_module_file, gdcm_module_function);
    if (function) return reinterpret_cast<UnpackByGdcm>(*function);
    return std::unexpected("its samples are packed, and what unpacks them cannot be loaded: " +
                           function.error());
}

/// The module's function, loaded by the first call, or why there is none. Thread-safe.
const std::expected<UnpackByGdcm, std::string>& gdcm_module() {
    static const auto module = loaded_module();
    return module;
}

/// The child: it tells nothing but in the memory, and leaves no trace.
[[noreturn]] void run_child(UnpackByGdcm unpack, std::string_view file, std::uint64_t count,
                            std::uint64_t most_memory, GdcmReport& report, char* samples) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg)
    prctl(PR_SET_DUMPABLE, 0);  // no core
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg)
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const rlimit memory{.rlim_cur = most_memory, .rlim_max = most_memory};
    setrlimit(RLIMIT_AS, &memory);
    const rlimit seconds{.rlim_cur = most_seconds, .rlim_max = most_seconds};
    setrlimit(RLIMIT_CPU, &seconds);
    signal(SIGALRM, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    alarm(2 * most_seconds);  // it may wait for what another thread of the parent held
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg)
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    unpack(file.data(), file.size(), count, report, samples);
    _exit(0);
}

/// The size of the process's address space now, bytes.
std::uint64_t memory_now() {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

const char* what_is_wrong(GdcmOutcome outcome) {
    switch (outcome) {
        case GdcmOutcome::NoNumbers: return "its samples are no single numbers";
        case GdcmOutcome::OtherCount:
            return "its packed samples are not as many as its header says";
        case GdcmOutcome::Done:
        case GdcmOutcome::None:
        case GdcmOutcome::Unreadable: break;
    }
    return "its packed samples are damaged, or of a kind that GDCM does not read";
}

}  // namespace

Pixels unpacked_pixels(std::string_view file, std::uint64_t count) {
    if (count / best_ratio > file.size()) {
        return std::unexpected("it is too short: " + std::to_string(count) +
                               " packed samples are announced, " + std::to_string(file.size()) +
                               " bytes are there");
    }
    if (count > most_samples) {
        return std::unexpected("it announces " + std::to_string(count) +
                               " packed samples; at most " + std::to_string(most_samples) +
                               " of a file are unpacked");
    }
    const auto& unpack = gdcm_module();
    if (!unpack) return std::unexpected(unpack.error());
    constexpr std::size_t before = 64;  // bytes for the report
    static_assert(sizeof(GdcmReport) <= before);
    const SharedMemory memory(before + count * gdcm_widest);
    if (!memory.is_there()) return std::unexpected("there is no memory for its samples");
    GdcmReport& report = *new (memory.data()) GdcmReport;
    char* const samples = memory.data() + before;
    const std::uint64_t most_memory =
        memory_now() + 4 * (file.size() + count * gdcm_widest) + spare;
    const pid_t child = fork();
    if (child == 0) run_child(*unpack, file, count, most_memory, report, samples);
    if (child < 0) return std::unexpected("there is no process to unpack its samples");
    while (waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
    }
    if (report.outcome != GdcmOutcome::Done) return std::unexpected(what_is_wrong(report.outcome));
    const auto bytes = count * static_cast<std::uint64_t>(report.bits_allocated) / 8;
    try {
        return DicomPixels{.bytes = std::string(samples, std::min(bytes, count * gdcm_widest)),
                           .bits_allocated = report.bits_allocated,
                           .bits_stored = report.bits_stored,
                           .is_signed = report.is_signed};
    } catch (const std::bad_alloc&) {
        return std::unexpected("there is no memory for its samples");
    }
}

}  // namespace zeroset
