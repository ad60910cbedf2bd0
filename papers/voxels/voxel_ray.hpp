#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// A ray in a voxel, in the voxel's own coordinates: R(t) = a + t b is in the unit cube for t from
/// 0 to t_out.
struct VoxelRay {
    /// rho at the corners, less rho_iso: bit 0 of the place says whether it is at u = 1, bit 1 at
    /// v = 1, bit 2 at w = 1.
    std::array<float, 8> rho{};
    std::array<float, 3> a{}, b{};
    float t_out = 0.0F;
};

/// The columns of numbers that a VoxelRay is stored in.
inline constexpr std::size_t voxel_columns = 15;

/// Many of them, column by column.
class VoxelRays {
public:
    /// No ray meets anything in the ones added by `pad`.
    void add(const VoxelRay& ray) {
        std::size_t column = 0;
        for (const float rho : ray.rho)
            columns_[column++].push_back(rho);
        for (const float a : ray.a)
            columns_[column++].push_back(a);
        for (const float b : ray.b)
            columns_[column++].push_back(b);
        columns_[column].push_back(ray.t_out);
        ++count_;
    }
    /// Makes the columns as long as the widest vectors need.
    void pad() {
        constexpr std::size_t widest = 16;
        const std::size_t size = (count_ + widest - 1) / widest * widest;
        for (std::vector<float>& column : columns_)
            column.resize(size, 1.0F);
    }
    [[nodiscard]] std::size_t count() const { return count_; }
    /// The length of the columns.
    [[nodiscard]] std::size_t size() const { return columns_[0].size(); }
    [[nodiscard]] const float* column(std::size_t column) const { return columns_[column].data(); }
    [[nodiscard]] VoxelRay ray(std::size_t i) const {
        VoxelRay ray;
        std::size_t column = 0;
        for (float& rho : ray.rho)
            rho = columns_[column++][i];
        for (float& a : ray.a)
            a = columns_[column++][i];
        for (float& b : ray.b)
            b = columns_[column++][i];
        ray.t_out = columns_[column][i];
        return ray;
    }

private:
    std::array<std::vector<float>, voxel_columns> columns_;
    std::size_t count_ = 0;
};

}  // namespace zeroset
