#include "app/code_choice.hpp"

#include "engine/image/framebuffer.hpp"
#include "engine/trace/render.hpp"

#include <algorithm>
#include <chrono>

namespace zeroset {
namespace {

// LLVM takes 15 ms for the simplest formula, and 1 to 2 ms for a node more, of which the
// interpreter evaluates forms in some 0.3 ns and values in 0.1 ns.
constexpr double most_interpreted_ms = 10.0;
constexpr double ns_of_value = 0.2;
constexpr double ns_of_form = 0.6;

/// So many pixels of the picture, along a side, are one of the small picture.
constexpr int reduction = 8;
/// A small picture that takes longer is one of many that do.
constexpr std::chrono::milliseconds longest_trial{40};

}  // namespace

bool machine_code_pays(const RenderRequest& picture, std::span<const Expr> drawn,
                       const std::atomic<bool>* cancel) {
    Framebuffer small(std::max(1, picture.width / reduction),
                      std::max(1, picture.height / reduction));
    const TimeLimit limit{cancel, std::chrono::steady_clock::now() + longest_trial};
    const Counters counters = render_frame(picture.scene, picture.camera, picture.settings, small,
                                           RenderWatch{.limit = limit, .on_tile = {}});
    if (counters.is_cut()) return true;
    double nodes = 0;
    for (const Expr& surface : drawn)
        nodes += static_cast<double>(surface.nodes().size());
    const double scale = static_cast<double>(picture.width) * picture.height /
                         (static_cast<double>(small.width) * small.height);
    const auto surfaces = static_cast<double>(drawn.size());
    const double ns = scale * nodes / surfaces *
                      (ns_of_value * static_cast<double>(counters.value) +
                       ns_of_form * static_cast<double>(counters.form));
    return ns > 1e6 * most_interpreted_ms * surfaces;
}

}  // namespace zeroset
