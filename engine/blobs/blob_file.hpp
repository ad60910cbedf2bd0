#pragma once

#include "engine/blobs/blob_set.hpp"

#include <cstddef>
#include <expected>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// The most balls of a list.
inline constexpr std::size_t most_blobs = 4'000'000;

/// Reads balls from a text: in each line x y z, or x y z r, or x y z r strength, apart by spaces,
/// tabs, commas or semicolons. `radius` is that of balls without one. A first line without numbers,
/// empty lines and those that start with # or // are passed over; so are the first two lines of an
/// XYZ file and the names of its atoms. An error is one line that says which line is wrong,
/// or where there are more than `most`.
std::expected<std::vector<Blob>, std::string> blobs_of_text(std::string_view text, double radius,
                                                            std::size_t most = most_blobs);

/// Reads balls from a file, as blobs_of_text does.
std::expected<std::vector<Blob>, std::string> read_blobs(const std::filesystem::path& file,
                                                         double radius);

}  // namespace zeroset
