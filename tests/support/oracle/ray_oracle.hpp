#pragma once

#include "tests/support/oracle/blob_oracle.hpp"
#include "tests/support/oracle/noise_oracle.hpp"
#include "tests/support/oracle/polynomial_oracle.hpp"
#include "tests/support/oracle/subdivision_oracle.hpp"
#include "tests/support/oracle/volume_oracle.hpp"

#include <optional>
#include <span>

namespace zeroset::test {

/// The exact oracle where a formula is a polynomial, or a volume, noise or blobs less a number;
/// else the one by subdivision.
class RayOracle {
public:
    RayOracle(const Expr& expr, std::span<const double> uniforms)
        : polynomial_(PolynomialOracle::of(expr, uniforms)),
          volume_(VolumeOracle::of(expr)),
          noise_(NoiseOracle::of(expr)),
          blobs_(BlobOracle::of(expr)),
          subdivision_(expr, uniforms) {}

    RayAnswer answer(const RayQuestion& ray) {
        if (volume_) return volume_->answer(ray);
        if (noise_) return noise_->answer(ray);
        if (blobs_) return blobs_->answer(ray);
        return polynomial_ ? polynomial_->answer(ray) : subdivision_.answer(ray);
    }

private:
    std::optional<PolynomialOracle> polynomial_;
    std::optional<VolumeOracle> volume_;
    std::optional<NoiseOracle> noise_;
    std::optional<BlobOracle> blobs_;
    SubdivisionOracle subdivision_;
};

}  // namespace zeroset::test
