#pragma once

#include "engine/noise/lattice_noise.hpp"
#include "tests/support/mpfr_number.hpp"

#include <cstdint>

// Noise as its documentation tells it, in 256 bits; shares nothing with the engine's code.

namespace zeroset::test {

/// The hash of a lattice point.
std::uint32_t reference_hash(std::uint32_t seed, std::int64_t i, std::int64_t j, std::int64_t k);

MpfrNumber lattice_noise_reference(NoiseKind kind, std::uint32_t seed, const MpfrNumber& x,
                                   const MpfrNumber& y, const MpfrNumber& z);
/// The distance from the point of rank 1, 2, ... in order of distance.
MpfrNumber cellular_reference(int rank, std::uint32_t seed, const MpfrNumber& x,
                              const MpfrNumber& y, const MpfrNumber& z);

}  // namespace zeroset::test
