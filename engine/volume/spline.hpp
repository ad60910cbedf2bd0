#pragma once

#include "engine/volume/pyramid.hpp"
#include "engine/volume/samples.hpp"
#include "engine/volume/volume.hpp"

#include <cstdint>
#include <expected>
#include <memory>
#include <string>

namespace zeroset {

enum class SplineKind : std::uint8_t {
    Interpolating,  ///< goes through the samples
    Smoothing       ///< the samples are its coefficients
};

/// The coefficients of a cubic B-spline over a volume's grid, mirrored at the outermost samples,
/// with the pyramid over them. As they are stored, they define the spline: they were rounded once.
/// Along each axis there is one more on both sides: coefficient i belongs to sample i - 1.
class SplineData {
public:
    /// The spline of a volume; while it lives it is given again. An error is one line without the
    /// file's name: a spline goes through no samples that are not finite, and there may be no
    /// memory for it. Thread-safe, in any rounding mode.
    static std::expected<std::shared_ptr<const SplineData>, std::string> of(
        const std::shared_ptr<const VolumeData>& volume, SplineKind kind);

    [[nodiscard]] const std::shared_ptr<const VolumeData>& volume() const { return volume_; }
    /// The coefficients, as Float where the samples are exact in it, else as Double.
    [[nodiscard]] const Samples& coefficients() const { return coefficients_; }
    /// The pyramid over them; `Number` must be their type. Its cell i lies between the coefficients
    /// i and i + 1.
    template <class Number>
    [[nodiscard]] const Pyramid<Number>& pyramid() const {
        return *static_cast<const Pyramid<Number>*>(pyramid_.get());
    }

private:
    SplineData() = default;
    static std::expected<std::shared_ptr<const SplineData>, std::string> make(
        const std::shared_ptr<const VolumeData>& volume, SplineKind kind);

    std::shared_ptr<const VolumeData> volume_;
    Samples coefficients_;
    std::shared_ptr<const void> pyramid_;
};

inline std::shared_ptr<const VolumeData> volume_data(
    const std::shared_ptr<const SplineData>& spline) {
    return spline->volume();
}

}  // namespace zeroset
