#pragma once

#include "engine/kernel/kernel.hpp"

#include <array>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace zeroset {

/// A box in x, y and z; lo <= hi.
struct ReachBox {
    std::array<float, 3> lo, hi;

    bool operator==(const ReachBox&) const = default;
};

/// Where in a box f may be <= 0.
struct Reach {
    bool any = false;         ///< else f > 0 and continuous in the whole box
    ReachBox box{};           ///< beside it f > 0 and continuous
    bool continuous = false;  ///< in this box, too
    /// Whether f > 0 in a layer under the faces of the whole box, `face_layer` of its longest edge
    /// thick.
    bool within = false;
};

inline constexpr double face_layer = 0x1p-20;

/// Finds where f may be <= 0, as tightly as natural interval extensions tell for slices of the box.
/// `uniforms`: for boxes. In upward rounding.
Reach reach_of(const Kernel& kernel, const ReachBox& domain, const float* uniforms);

/// The parts of a union: f is the least of these functions wherever all are defined; elsewhere f is
/// undefined. Constant but for what it remembers; any thread.
class UnionParts {
public:
    /// `kernels` are alive as long as `owners`.
    UnionParts(std::vector<const Kernel*> kernels, std::vector<std::shared_ptr<const void>> owners)
        : kernels_(std::move(kernels)), owners_(std::move(owners)) {}

    [[nodiscard]] std::span<const Kernel* const> kernels() const { return kernels_; }
    /// The reach of each part; those of the last box and uniforms are remembered.
    [[nodiscard]] std::shared_ptr<const std::vector<Reach>> reaches(const ReachBox& domain,
                                                                    const Uniforms& uniforms) const;

private:
    std::vector<const Kernel*> kernels_;
    std::vector<std::shared_ptr<const void>> owners_;

    mutable std::mutex mutex_;  ///< of the following
    mutable ReachBox domain_{};
    mutable std::vector<float> uniforms_;
    mutable std::shared_ptr<const std::vector<Reach>> reaches_;
};

}  // namespace zeroset
