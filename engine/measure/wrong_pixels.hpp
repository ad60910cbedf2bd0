#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/view/camera.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// Pixels of a picture that are not as those proved in another picture of the same view.
struct WrongPixels {
    std::size_t missed = 0;   ///< a certified root there, nothing shown
    std::size_t added = 0;    ///< proved empty there, something shown
    std::size_t moved = 0;    ///< a certified root there, shown farther from it than allowed
    std::size_t refuted = 0;  ///< those of all these that the picture claims to have proved

    [[nodiscard]] std::size_t all() const { return missed + added + moved; }
};

/// `tolerance`: how far hits of `frame` may be from the roots of `proved`, world units along the
/// ray's dominant axis. `proved`: of the same size; traced so finely that its own error does not
/// count, or `tolerance` allows for it, too.
WrongPixels wrong_pixels(const Framebuffer& frame, const Framebuffer& proved, const Camera& camera,
                         double tolerance);

/// `frame` in grey, as opaque colours of Framebuffer, and its wrong pixels over it, each marked in
/// a square of three by three: red missed ones, violet added ones, amber moved ones.
std::vector<std::uint32_t> difference_colors(const Framebuffer& frame, const Framebuffer& proved,
                                             const Camera& camera, double tolerance);

}  // namespace zeroset
