#include "pipeline/code_choice.hpp"

#include "engine/image/framebuffer.hpp"
#include "engine/render/render.hpp"

#include <algorithm>
#include <chrono>

namespace zeroset {
namespace {

// LLVM takes 15 ms for the simplest formula and 1 to 2 ms for each further node. The interpreter,
// on two cores, evaluates the form of a node in about 0.3 ns and its value in 0.1 ns.
constexpr double most_interpreted_ms = 10.0;
constexpr double ns_of_value = 0.2;
constexpr double ns_of_form = 0.6;
/// The tracer's own work per evaluation, in nodes that take as long.
constexpr double nodes_beside = 10.0;
/// The trial picture's sides are the full picture's, divided by this.
constexpr int reduction = 8;
/// A trial picture that takes longer than this is cut off, and the full picture counts as slow.
constexpr std::chrono::milliseconds longest_trial{100};

/// Estimated time of the picture by parts, in ms per node of the formula, above which hasty code of
/// the whole pays. Such estimates are too low: where much is left out, few lanes are at work.
constexpr double whole_code_ms = 0.065;

/// In pictures of more pixels, LLVM's longer work on quicker code pays.
constexpr double most_pixels_of_hasty_code = 512.0 * 512.0;

}  // namespace

std::optional<CodeUse> code_for_one(const RenderRequest& picture, const Formula& formula,
                                    const std::atomic<bool>* cancel) {
    if (is_made_of_parts(formula)) return CodeUse::OnePicture;
    Framebuffer small(std::max(1, picture.width / reduction),
                      std::max(1, picture.height / reduction));
    const TimeLimit limit{.cancel = cancel,
                          .until = std::chrono::steady_clock::now() + longest_trial};
    const Counters counters = render_frame(picture.scene, picture.camera, picture.settings, small,
                                           RenderWatch{.limit = limit, .on_tile = {}});
    const double pixels = static_cast<double>(picture.width) * picture.height;
    const double scale = pixels / static_cast<double>(small.color.size());
    const auto surfaces = static_cast<double>(formula.drawn.size());
    // Estimates the full picture's time by the interpreters. `steps`: of all surfaces together.
    const auto interpreted_ms = [&](double steps) {
        return 1e-6 * scale * (nodes_beside + steps / surfaces) *
               (ns_of_value * static_cast<double>(counters.value) +
                ns_of_form * static_cast<double>(counters.form));
    };
    const auto nodes = static_cast<double>(formula.nodes());
    if (!counters.is_cut() && interpreted_ms(nodes) <= most_interpreted_ms * surfaces)
        return std::nullopt;
    if (has_many_choices(formula)) {
        const auto compiled = static_cast<double>(nodes_of_shapes(formula.drawn));
        const bool is_long =
            counters.is_cut() || interpreted_ms(steps_left(formula)) > whole_code_ms * compiled;
        return is_long ? CodeUse::LongPicture : CodeUse::OnePicture;
    }
    return pixels > most_pixels_of_hasty_code ? CodeUse::Pictures : CodeUse::OnePicture;
}

}  // namespace zeroset
