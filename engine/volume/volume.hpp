#pragma once

#include "engine/real/field.hpp"
#include "engine/volume/geometry.hpp"
#include "engine/volume/pyramid.hpp"
#include "engine/volume/samples.hpp"

#include <array>
#include <cstdint>
#include <expected>
#include <memory>
#include <string>

namespace zeroset {

/// The behaviour of a volume beyond its outermost samples.
enum class Outside : std::uint8_t {
    Undefined,
    Edge,     ///< as at the nearest point of the grid
    Constant  ///< jumps to a number
};

struct VolumeOptions {
    Outside outside = Outside::Undefined;
    double constant = 0;  ///< for Outside::Constant; finite

    bool operator==(const VolumeOptions&) const = default;
};

/// Samples at their place with the pyramid over them: what the volumes of one file share.
class VolumeData {
public:
    /// Builds the pyramid, on all cores: this reads all samples once. An error is one line without
    /// the file's name: fewer than two samples along an axis, axes that lie in one plane, no sample
    /// that is a number.
    static std::expected<std::shared_ptr<const VolumeData>, std::string> make(
        const Samples& samples, const Geometry& geometry);

    [[nodiscard]] const Samples& samples() const { return samples_; }
    [[nodiscard]] const Geometry& geometry() const { return geometry_; }
    [[nodiscard]] const IndexMap& map() const { return map_; }
    /// The range of all samples.
    [[nodiscard]] const SampleRange& range() const { return range_; }
    /// The box about the grid in the world: lower ends, then upper ends.
    [[nodiscard]] std::array<double, 6> bounds() const;
    /// The pyramid; `Sample` must be the samples' type.
    template <class Sample>
    [[nodiscard]] const Pyramid<Sample>& pyramid() const {
        return *static_cast<const Pyramid<Sample>*>(pyramid_.get());
    }

private:
    VolumeData() = default;

    Samples samples_;
    Geometry geometry_;
    IndexMap map_{};
    SampleRange range_;
    std::shared_ptr<const void> pyramid_;
};

/// The data themselves, as what a Trilinear is made of (SplineData has another).
inline std::shared_ptr<const VolumeData> volume_data(std::shared_ptr<const VolumeData> data) {
    return data;
}

class SplineData;

/// A volume as a function: trilinear between the samples, or a cubic spline. In a cell one of whose
/// corners, or one of the spline's coefficients about it, is infinite or NaN it is undefined.
class Volume : public Field {
public:
    static std::shared_ptr<const Volume> make(std::shared_ptr<const VolumeData> data,
                                              const VolumeOptions& options, std::string text);
    static std::shared_ptr<const Volume> make(std::shared_ptr<const SplineData> spline,
                                              const VolumeOptions& options, std::string text);

    [[nodiscard]] const VolumeData& data() const { return *data_; }
    [[nodiscard]] std::shared_ptr<const VolumeData> shared_data() const { return data_; }
    [[nodiscard]] const VolumeOptions& options() const { return options_; }
    /// Its spline; nullptr where it is trilinear.
    [[nodiscard]] virtual const SplineData* spline() const = 0;
    [[nodiscard]] std::string text() const override { return text_; }
    [[nodiscard]] bool is_total() const override;
    [[nodiscard]] bool is_continuous() const override;

protected:
    Volume(std::shared_ptr<const VolumeData> data, const VolumeOptions& options, std::string text);

private:
    std::shared_ptr<const VolumeData> data_;
    VolumeOptions options_;
    std::string text_;
};

}  // namespace zeroset
