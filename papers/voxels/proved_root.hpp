#pragma once

#include "papers/voxels/voxel_ray.hpp"

#include <cstdint>

namespace zeroset {

/// A proof about the roots of a ray in a voxel, for the numbers of the VoxelRay as they are.
struct ProvedRoot {
    enum class Kind : std::uint8_t {
        None,     ///< rho is nowhere 0
        Root,     ///< the first root is at t, to 2^-24 of t_out
        Unknown,  ///< rho stays so near to 0 somewhere that rounding does not tell
    };
    Kind kind = Kind::Unknown;
    double t = 0;
};

/// The first root on a ray in a voxel, by Bernstein polynomials: the cubic's coefficients over
/// [0, t_out] are means of rho with u, v and w at different ends, between which its values lie.
ProvedRoot proved_first_root(const VoxelRay& ray);

}  // namespace zeroset
