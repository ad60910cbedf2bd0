#include "engine/volume/volume.hpp"

#include "engine/real/rounding.hpp"
#include "engine/volume/cubic_spline.hpp"
#include "engine/volume/volume_of.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace zeroset {

std::expected<std::shared_ptr<const VolumeData>, std::string> VolumeData::make(
    const Samples& samples, const Geometry& geometry) {
    const NearestRounding nearest;
    if (std::ranges::any_of(samples.size, [](std::uint64_t n) { return n < 2; })) {
        return std::unexpected("it has " + std::to_string(samples.size[0]) + " x " +
                               std::to_string(samples.size[1]) + " x " +
                               std::to_string(samples.size[2]) +
                               " samples; a volume needs two along each axis");
    }
    const auto map = index_map(geometry);
    if (!map) return std::unexpected("its axes lie in one plane or are no finite numbers");
    std::shared_ptr<VolumeData> data(new VolumeData);
    data->samples_ = samples;
    data->geometry_ = geometry;
    data->map_ = *map;
    visit_samples(samples, [&](const auto* first) {
        using Sample = std::remove_cvref_t<decltype(*first)>;
        const auto pyramid = std::make_shared<const Pyramid<Sample>>(samples);
        data->range_ = pyramid->range();
        data->pyramid_ = pyramid;
    });
    if (!data->range_.any()) return std::unexpected("none of its samples is a finite number");
    return data;
}

std::array<double, 6> VolumeData::bounds() const {
    std::array<double, 6> box{};
    for (unsigned corner = 0; corner < 8; ++corner) {
        std::array<double, 3> index{};
        for (std::size_t i = 0; i < 3; ++i)
            index[i] = (corner >> i & 1U) != 0 ? static_cast<double>(samples_.size[i] - 1) : 0;
        const auto point = world_point(geometry_, index);
        for (std::size_t i = 0; i < 3; ++i) {
            box[i] = corner == 0 ? point[i] : std::min(box[i], point[i]);
            box[i + 3] = corner == 0 ? point[i] : std::max(box[i + 3], point[i]);
        }
    }
    return box;
}

Volume::Volume(std::shared_ptr<const VolumeData> data, const VolumeOptions& options,
               std::string text)
    : data_(std::move(data)), options_(options), text_(std::move(text)) {}

bool Volume::is_total() const {
    return options_.outside != Outside::Undefined && !data_->range().holes;
}

bool Volume::is_continuous() const { return options_.outside != Outside::Constant; }

std::shared_ptr<const Volume> Volume::make(std::shared_ptr<const VolumeData> data,
                                           const VolumeOptions& options, std::string text) {
    return visit_samples(data->samples(), [&](const auto* first) -> std::shared_ptr<const Volume> {
        using Sample = std::remove_cvref_t<decltype(*first)>;
        return std::make_shared<const VolumeOf<Trilinear<Sample>>>(std::move(data), options,
                                                                   std::move(text));
    });
}

std::shared_ptr<const Volume> Volume::make(std::shared_ptr<const SplineData> spline,
                                           const VolumeOptions& options, std::string text) {
    const auto volume = [&](auto number) -> std::shared_ptr<const Volume> {
        using Between = CubicSpline<decltype(number)>;
        return std::make_shared<const VolumeOf<Between>>(std::move(spline), options,
                                                         std::move(text));
    };
    return spline->coefficients().type == SampleType::Float ? volume(float{}) : volume(double{});
}

}  // namespace zeroset
