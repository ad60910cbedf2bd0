#include "engine/annotate/outer_edges.hpp"

namespace zeroset {
namespace {

/// Whether the eye sees the face of the box across an axis, at the upper or the lower end, from
/// outside.
bool sees_face(const Box& box, const ViewFrame& view, int axis, bool upper) {
    constexpr double level = 1e-9;
    if (view.parallel()) return (upper ? -1.0 : 1.0) * view.forward[axis] > level;
    const double eye = view.eye[axis] / view.stretch[axis];
    return upper ? eye > box.hi[axis] : eye < box.lo[axis];
}

}  // namespace

std::array<std::optional<Segment>, 3> outer_edges(const Box& box, const ImagePlane& plane, int up) {
    /// Edges as low as one another: the one more to the left.
    constexpr double leftwards = 1e-3;
    std::array<std::optional<Segment>, 3> edges;
    for (int axis = 0; axis < 3; ++axis) {
        const int i = (axis + 1) % 3;
        const int j = (axis + 2) % 3;
        double best = 0.0;
        for (const auto& [upper_i, upper_j] :
             {std::pair(false, false), {false, true}, {true, false}, {true, true}}) {
            if (sees_face(box, plane.view(), i, upper_i) ==
                sees_face(box, plane.view(), j, upper_j))
                continue;
            Segment edge{.from = box.lo, .to = box.lo};
            edge.to[axis] = box.hi[axis];
            edge.from[i] = edge.to[i] = upper_i ? box.hi[i] : box.lo[i];
            edge.from[j] = edge.to[j] = upper_j ? box.hi[j] : box.lo[j];
            const auto middle = plane.pixel_of(edge.at(0.5));
            if (!middle) continue;
            const double rank = axis == up ? -middle->x : middle->y - leftwards * middle->x;
            auto& chosen = edges.at(static_cast<std::size_t>(axis));
            if (chosen && rank <= best) continue;
            chosen = edge;
            best = rank;
        }
    }
    return edges;
}

}  // namespace zeroset
