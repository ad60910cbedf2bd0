#pragma once

#include "engine/kernel/kernel.hpp"
#include "engine/kernel/patch_model.hpp"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace zeroset {

/// The code of a parametric surface (SurfaceFacts::patch): where x and y are in the unit square,
/// the point is (point[0], point[1], point[2]). The kernels have code in double
/// (Kernel::has_double); z is 0.
struct PatchCode {
    std::array<Kernel, 3> point;
    /// The patch is cut to this box, too: from and to in x, in y and in z.
    std::optional<std::array<double, 6>> box = std::nullopt;
    std::shared_ptr<const PatchModeler> modeler = nullptr;  ///< nullptr: there is none
    /// The items of the uniforms that the coordinates read; nothing: all of them, perhaps.
    std::optional<std::vector<std::size_t>> reads = std::nullopt;
};

/// The kernel of a surface that is drawn by its patch. Its functions know nothing of any place, so
/// that whoever asks them for an f finds no root and proves nothing.
Kernel patch_kernel(std::array<Kernel, 3> point,
                    const std::optional<std::array<double, 6>>& box = std::nullopt,
                    std::shared_ptr<const PatchModeler> modeler = nullptr,
                    std::optional<std::vector<std::size_t>> reads = std::nullopt);

/// Whether the kernel was made by patch_kernel.
bool is_patch(const Kernel& kernel);

}  // namespace zeroset
