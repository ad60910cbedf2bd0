#pragma once

#include "engine/trace/patch/patch_sight.hpp"
#include "engine/trace/patch/patch_tree.hpp"
#include "engine/trace/time_limit.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace zeroset {

/// A ray in the axes of a view, and what is wanted on it.
struct PatchQuest {
    SightAxes axes;
    SightRay ray;
    double from, to;   ///< depths s between which the first hit is wanted
    double tolerance;  ///< the width of a bracket that is narrow enough
    double pixel;     ///< parts larger than this are kept in the tree: other rays will ask for them
    const Box& clip;  ///< hits are wanted in this box
    bool any = false;  ///< a hit will do that is not the first
};

/// The first hit of a ray, as far as it is known.
struct PatchHit {
    double s = std::numeric_limits<double>::infinity();  ///< +inf: there is none
    double s_radius = 0.0;
    bool is_proved = false;  ///< a place of the patch is there, and none before `unsettled`
    glm::dvec3 normal{0.0};  ///< dS/du x dS/dv, of whatever size
    /// Before this depth nothing was left that could be neither rejected nor drawn.
    double unsettled = std::numeric_limits<double>::infinity();

    [[nodiscard]] bool is_hit() const { return s < std::numeric_limits<double>::infinity(); }
};

/// Whether a place is surely in the unit square or in a box, surely beside it, or neither is known.
enum class InSquare : std::uint8_t { Inside, Outside, Unknown };
InSquare in_square(const UvBox& box);

/// The (u, v) that p and q of a node's form stand for, and how far they may be from them.
UvBox place_in(const UvBox& box, double p, double q, double radius);

/// Whether a place that is known but for an error is in a box.
InSquare in_box(const Box& box, const glm::dvec3& at, const glm::dvec3& error);
/// Whether the zero that a test has found in the box of a form is in the box that the patch is cut
/// to; `point` is S at a place of the former.
InSquare in_own_box(const PatchTree& tree, const PatchForm& form, const ZeroTest& test,
                    const BoxPlace& at, const PatchPoint& point);
/// Whether a place is inside of both, by what is known of each.
InSquare both(InSquare a, InSquare b);

/// Searches single rays, box by box from front to back. A thread's keep their memory from one to
/// the next: one at a time searches.
class PatchSearch {
public:
    PatchSearch(const PatchTree& tree, const TimeLimit& limit, Counters& counters)
        : tree_(tree), limit_(limit), counters_(counters), open_(kept_items()) {}

    /// Searches the part of the patch below a node, for what is nearer than `known`, if that is a
    /// hit. When stopped it says so by `unsettled`.
    PatchHit search(const PatchQuest& quest, PatchNode& node, const PatchHit& known = {});

private:
    struct Item {
        UvBox box;
        PatchForm form;
        PatchSight sight;  ///< of the form; without slopes
        PatchNode* node;   ///< in the tree; nullptr: not in it
        double near;       ///< no place of it is before this depth
    };
    enum class Outcome : std::uint8_t { Done, Open };

    static std::vector<Item>& kept_items() {
        thread_local std::vector<Item> kept;
        return kept;
    }

    void push(const PatchQuest& quest, const UvBox& box, const PatchForm& whole, PatchNode* node);
    void push_parts(const PatchQuest& quest, PatchNode::Children& parts);
    Outcome certify(const PatchQuest& quest, const Item& item, const PatchSight& sight,
                    const LinearZeros& zeros);
    /// S, or the model of S, at a place of an item, with the derivatives by p and q.
    PatchPoint evaluate(const Item& item, double p, double q);
    void take(const PatchQuest& quest, const ZeroTest& test, InSquare where,
              const PatchPoint& point);
    void give_up(const PatchQuest& quest, const Item& item);
    void divide(const PatchQuest& quest, const Item& item, const PatchSight& sight,
                const LinearZeros& zeros);

    const PatchTree& tree_;
    const TimeLimit& limit_;
    Counters& counters_;
    std::vector<Item>& open_;
    PatchHit best_;
};

}  // namespace zeroset
