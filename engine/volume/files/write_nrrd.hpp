#pragma once

#include "engine/volume/geometry.hpp"
#include "engine/volume/samples.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace zeroset {

/// All before the samples of an NRRD file with raw ones, which follow at a multiple of 64 bytes, so
/// that they can be mapped. `content`: one line about them.
std::string nrrd_header(SampleType type, const GridSize& size, const Geometry& geometry,
                        const std::string& content);

/// The bytes of a whole file.
std::vector<std::byte> nrrd_bytes(const Samples& samples, const Geometry& geometry,
                                  const std::string& content);

}  // namespace zeroset
