#include "tests/support/blob_reference.hpp"

#include "tests/support/random_numbers.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace zeroset::test {
namespace {

MpfrNumber fraction(double p, double q) { return MpfrNumber(p) / MpfrNumber(q); }

/// The height by the formulas of the papers, by the distance d and the radius of influence R = 2 r.
MpfrNumber height(BlobKind kind, const MpfrNumber& squares, double radius) {
    const MpfrNumber r(radius);
    const MpfrNumber reach = MpfrNumber(2.0) * r;
    if (kind == BlobKind::Blinn) {
        MpfrNumber power = MpfrNumber(2.0) - MpfrNumber(2.0) * squares / (r * r);
        mpfr_exp(power.get(), power.get(), MPFR_RNDN);
        return power;
    }
    const MpfrNumber c = squares / (reach * reach);
    if (c > 1.0) return MpfrNumber(0.0);
    if (kind == BlobKind::Wyvill) {
        const MpfrNumber sum = MpfrNumber(1.0) - fraction(22, 9) * c + fraction(17, 9) * c * c -
                               fraction(4, 9) * c * c * c;
        return MpfrNumber(2.0) * sum;
    }
    MpfrNumber share;
    mpfr_sqrt(share.get(), c.get(), MPFR_RNDN);
    const MpfrNumber rest = MpfrNumber(1.0) - share;
    const MpfrNumber three(3.0);
    const MpfrNumber sum = mpfr_cmp((three * share).get(), MpfrNumber(1.0).get()) <= 0
                               ? MpfrNumber(1.0) - three * c
                               : fraction(3, 2) * rest * rest;
    return fraction(8, 3) * sum;
}

}  // namespace

MpfrNumber blobs_reference(const Blobs& blobs, const MpfrNumber& x, const MpfrNumber& y,
                           const MpfrNumber& z) {
    const std::array point{x, y, z};
    MpfrNumber sum(0.0);
    for (std::size_t n = 0; n < blobs.set().size(); ++n) {
        MpfrNumber squares(0.0);
        for (std::size_t i = 0; i < 3; ++i) {
            const MpfrNumber from = point[i] - MpfrNumber(blobs.set().center(i)[n]);
            squares = squares + from * from;
        }
        sum = sum + MpfrNumber(blobs.set().strength()[n]) *
                        height(blobs.kind(), squares, blobs.set().radius()[n]);
    }
    return sum;
}

std::shared_ptr<const Field> sample_blobs(BlobKind kind) {
    RandomNumbers random(1982);
    std::vector<Blob> blobs;
    for (int n = 0; n < 30; ++n) {
        Blob blob;
        for (double& x : blob.center)
            x = random.uniform(-2, 2);
        blob.radius = std::exp2(random.uniform(-4, 0));
        blob.strength = random.one_in(5) ? -random.uniform(0.1, 1) : random.uniform(0.3, 2);
        blobs.push_back(blob);
    }
    return blobs_field(kind, blobs, std::string(blob_name(kind)) + "(\"sample\")");
}

}  // namespace zeroset::test
