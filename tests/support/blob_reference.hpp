#pragma once

#include "engine/blobs/blobs.hpp"
#include "tests/support/mpfr_number.hpp"

#include <memory>

// Soft balls as their documentation tells them, in 256 bits.

namespace zeroset::test {

MpfrNumber blobs_reference(const Blobs& blobs, const MpfrNumber& x, const MpfrNumber& y,
                           const MpfrNumber& z);

/// Some thirty balls about the origin, of all sizes, a few of which take away.
std::shared_ptr<const zeroset::Field> sample_blobs(BlobKind kind);

}  // namespace zeroset::test
