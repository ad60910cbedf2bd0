// A fuzzer of everything that reads files: volumes, files of other programs, documents. It changes
// bytes of real files and reads each under the name of its own. Each is tried in a child process,
// so that a crash, too, is found and its file kept.

#include "document/import/import.hpp"
#include "document/json/document_json.hpp"
#include "document/json/share_text.hpp"
#include "engine/blobs/blob_file.hpp"
#include "engine/volume/files/volume_file.hpp"
#include "tests/fuzz/isolated.hpp"
#include "tests/support/random_numbers.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* usage =
    "usage: file_fuzz --seconds N [--seed S] FOLDER FILE...\n"
    "  FOLDER  holds what is tried; a file that fails stays there\n"
    "  FILE    is changed, and read under its own name\n";

std::string contents(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Why a reader's error is not the one short line that it is to be; nothing where it is.
std::optional<std::string> fault_of(const std::string& error) {
    if (error.empty()) return "an error without a word";
    if (error.size() > 600) return "a long error: " + error;
    if (error.contains('\n')) return "an error of several lines: " + error;
    return std::nullopt;
}

template <class Read>
std::optional<std::string> fault_of(const Read& read) {
    return read ? std::nullopt : fault_of(std::string(read.error()));
}

/// Reads a file as the program would, by its name; returns what is wrong, if anything.
std::optional<std::string> complaint_about_file(const fs::path& path) {
    const std::string name = path.filename().string();
    if (is_volume_file(path)) {
        const auto volume = open_volume(path, {});
        return fault_of(volume);
    }
    const std::string bytes = contents(path);
    if (is_import_name(name)) return fault_of(read_import(name, bytes));
    if (name.ends_with(".json")) return fault_of(document_from(bytes));
    if (is_share_text(bytes)) {
        const auto json = shared_json(bytes);
        return json ? fault_of(document_from(*json)) : fault_of(json);
    }
    return fault_of(blobs_of_text(bytes, 1.0));
}

/// Changes bytes: signs that formats care for, numbers at their ends, pieces moved and cut.
std::string changed(std::string bytes, RandomNumbers& random) {
    constexpr std::string_view likely = "(){}[]<>#;=,.\"'\\0123456789eE+-*/^xyz\n\t\0\x7f\x80\xff";
    const int changes = 1 << random.between(0, 4);
    for (int i = 0; i < changes && !bytes.empty(); ++i) {
        const std::size_t at = random.below(bytes.size());
        switch (random.below(8)) {
            case 0: bytes[at] = likely[random.below(likely.size())]; break;
            case 1: bytes[at] = static_cast<char>(random.below(256)); break;
            case 2: bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8))); break;
            case 3:
                bytes.insert(at, 1 + random.below(8), likely[random.below(likely.size())]);
                break;
            case 4: bytes.erase(at, 1 + random.below(20)); break;
            case 5:
                bytes.insert(at, bytes.substr(random.below(bytes.size()), random.below(200)));
                break;
            case 6:
                for (std::size_t k = at; k < std::min(at + 4, bytes.size()); ++k)
                    bytes[k] = random.one_in(2) ? '\xff' : '\0';
                break;
            default:
                if (random.one_in(4)) bytes.resize(at);
        }
    }
    return bytes;
}

struct Options {
    std::size_t seconds = 0, seed = 1;
    std::vector<fs::path> files{};
    fs::path folder;
};

std::optional<Options> options_of(const std::vector<std::string>& arguments) {
    Options options;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& argument = arguments[i];
        if ((argument == "--seconds" || argument == "--seed") && i + 1 < arguments.size()) {
            (argument == "--seed" ? options.seed : options.seconds) =
                std::strtoul(arguments[++i].c_str(), nullptr, 10);
        } else if (argument.starts_with("--")) {
            return std::nullopt;
        } else if (options.folder.empty()) {
            options.folder = argument;
        } else {
            options.files.emplace_back(argument);
        }
    }
    if (options.seconds == 0 || options.files.empty()) return std::nullopt;
    return options;
}

int fuzz(const Options& options) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::seconds(options.seconds);
    constexpr std::size_t timeout_s = 60;
    fs::create_directories(options.folder);
    std::vector<std::string> files;
    for (const fs::path& path : options.files)
        files.push_back(contents(path));
    RandomNumbers random(options.seed);
    std::size_t runs = 0;
    const Isolated isolated(
        [](std::string_view path) { return complaint_about_file(fs::path(path)); }, timeout_s);
    const auto next = [&](bool tried) -> std::optional<std::string> {
        static fs::path last;
        if (tried) fs::remove(last);
        if (Clock::now() >= end) {
            std::printf("%zu files are good\n", runs);
            return std::nullopt;
        }
        const std::size_t which = random.below(files.size());
        // Another name each time, as volumes are kept by name.
        last = options.folder /
               ("fuzz_" + std::to_string(options.seed) + "_" + std::to_string(runs++) + "_" +
                options.files[which].filename().string());
        std::ofstream(last, std::ios::binary) << changed(files[which], random);
        return last.string();
    };
    const auto failure = isolated.first_failure(next);
    if (!failure) return 0;
    std::printf("%s: %s\n", failure->text.c_str(), failure->reason.c_str());
    return 1;
}

}  // namespace
}  // namespace zeroset::test

int main(int argc, char** argv) {
    const auto options = zeroset::test::options_of({argv + 1, argv + argc});
    if (!options) {
        std::fputs(zeroset::test::usage, stderr);
        return 2;
    }
    return zeroset::test::fuzz(*options);
}
