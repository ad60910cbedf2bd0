#pragma once

#include "document/film_plan.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/settings.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace zeroset {

/// Frames that share what is proved empty: so many in a row; 0: none do; nothing: as many as
/// measurement says.
using FrameRangeChoice = std::optional<int>;

inline constexpr int longest_frame_range = 100'000;

/// The work of frame ranges in a film.
struct FrameRangeWork {
    int frames = 0;            ///< frames that were drawn with them
    int searches = 0;          ///< searches for empty space
    std::uint64_t ranges = 0;  ///< evaluations of f over boxes that these took
    double search_ms = 0.0;
    int length = 0;  ///< frames that shared the last search; 0: the last frame was drawn without
};

/// Finds, once for several frames in a row, where none of them has a surface [Florez08, ch. 6]:
/// by enclosures of f over boxes in space and over all values that w and the parameters have in
/// these frames. The camera does not matter.
class FrameRanges {
public:
    /// Values of w and the parameters at a moment of the film.
    using ValuesAt = std::function<std::vector<double>(double moment)>;

    /// `height`: of the pictures, in pixels.
    FrameRanges(const FilmPlan& plan, FrameRangeChoice choice, const TraceSettings& settings,
                int height, ValuesAt values_at);

    /// Tells the scene of a frame, or of a moment of it, where it is empty.
    void add_to(Scene& scene, int frame);
    /// How many evaluations of f the frame took.
    void learn(std::uint64_t evaluations);

    [[nodiscard]] const FrameRangeWork& work() const { return work_; }

private:
    /// Chooses, or goes on choosing, the length for a frame.
    void choose(int frame);
    void search(const Scene& scene, int frame);
    [[nodiscard]] Uniforms hull(int first, int last) const;

    FilmPlan plan_;
    FrameRangeChoice choice_;
    ValuesAt values_at_;
    int levels_;
    int threads_;
    std::vector<int> lengths_;   ///< those that are tried one after the other
    std::vector<double> costs_;  ///< of a frame by those that were, in evaluations
    int length_ = 0;             ///< the present one
    int drawn_ = 0;              ///< frames since the first trial
    std::optional<int> frame_;   ///< the last one that was prepared
    /// The frames, from first to last, of which is known where they are empty.
    int first_ = 0, last_ = -1;
    std::vector<std::shared_ptr<const OpenSpace>> spaces_;  ///< of each surface
    double cost_ = 0.0;  ///< of search and looking up, for each of the frames
    FrameRangeWork work_;
};

}  // namespace zeroset
