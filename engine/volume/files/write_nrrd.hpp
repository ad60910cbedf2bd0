#pragma once

#include "engine/volume/geometry.hpp"
#include "engine/volume/samples.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace zeroset {

/// The bytes of an NRRD file with raw samples, which begin at a multiple of 64 bytes, so that they
/// can be mapped. `content`: one line about them.
std::vector<std::byte> nrrd_bytes(const Samples& samples, const Geometry& geometry,
                                  const std::string& content);

}  // namespace zeroset
