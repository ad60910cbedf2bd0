#pragma once

#include "engine/trace/patch/patch_form.hpp"
#include "engine/trace/patch/patch_sight.hpp"
#include "engine/trace/trace_frame.hpp"
#include "engine/view/box.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace zeroset {

/// Forms are those of boxes that are so much wider than the part of the unit square that they stand
/// for: a root at the border of two boxes is inside of both.
inline constexpr double form_growth = 1.0 + 0x1p-5;
/// The share of a grown box that its part is.
inline constexpr double box_share = 1.0 / form_growth;
/// box_share, enlarged by more than rounding may take from it.
inline constexpr double form_inner = (1.0 + 0x1p-20) / form_growth;

/// How a box is divided: `cols` x `rows` parts, sixteen of them, or four.
struct Division {
    std::size_t cols, rows;
};

/// The division into sixteen parts that are about as wide as they are high.
Division division_of(double width, double height);
/// The division into four parts that are about as wide as they are high.
Division quarters_of(double width, double height);

/// Whether a part of the unit square is so narrow that a jump in it is not looked at any closer.
inline bool is_thin(const UvBox& box) { return std::min(box.u_radius, box.v_radius) < 0x1p-40; }

/// A part of the unit square.
struct PatchNode {
    struct Children;

    UvBox box;                          ///< the part that it stands for
    PatchForm form;                     ///< over box.grown(form_growth)
    const PatchModel* model = nullptr;  ///< what the form is of; nullptr: of S itself
    ModelSizes sizes{};                 ///< of the model
    int level = 0;
    std::atomic<Children*> children = nullptr;
    std::atomic<Children*> quarters = nullptr;  ///< another division; without nodes: none is of use

    PatchNode() = default;
    PatchNode(const PatchNode&) = delete;
    PatchNode& operator=(const PatchNode&) = delete;
    ~PatchNode();
};

/// The forms of the parts of a node, a part in each lane.
struct PartForms {
    using Numbers = std::array<std::array<double, PatchForms::at_once>, 3>;

    Numbers c, ku, kv, e;
    std::uint32_t known = 0;  ///< a bit for each part that is known in all coordinates
};

struct PatchNode::Children {
    std::vector<PatchNode> nodes;
    std::vector<PatchModel> models;  ///< of the nodes that have one; else none
    PartForms forms;                 ///< those of the nodes again

    explicit Children(std::size_t count) : nodes(count) {}
};

/// A tree of boxes in (u, v) that bounds a patch for some values of the uniforms, whatever the
/// view. A box is divided when its parts are first asked for. Any thread.
class PatchTree : public PreparedSurface {
public:
    PatchTree(std::shared_ptr<const PatchCode> code, Uniforms uniforms);

    [[nodiscard]] PatchNode& root() const { return root_; }
    [[nodiscard]] const PatchForms& forms() const { return forms_; }
    /// The box that the patch itself is cut to, beside what a view shows (PatchCode::box).
    [[nodiscard]] const std::optional<Box>& box() const { return box_; }
    /// The part of `clip` that is in the patch's own box; empty where lo > hi.
    [[nodiscard]] Box within(const Box& clip) const;
    /// The sixteen parts of a node, in the world about as long as wide; nullptr where the tree has
    /// no room for more.
    PatchNode::Children* parts(PatchNode& node) const;
    /// Four parts of a node, where all of them have good models; else nullptr. They are divided
    /// anew: they have no parts in common with those above.
    PatchNode::Children* quarters(PatchNode& node) const;
    /// Boxes in the world that hold the patch together, those of parts of parts. In upward
    /// rounding.
    [[nodiscard]] std::vector<Box> boxes() const;
    /// Whether the tree has grown so much that it should begin anew.
    [[nodiscard]] bool is_full() const { return nodes_ >= most_nodes; }
    [[nodiscard]] std::size_t size() const { return nodes_; }

private:
    static constexpr std::size_t most_nodes = std::size_t{1} << 18;

    /// Keeps what was made, or returns what another thread made before.
    PatchNode::Children* keep(std::atomic<PatchNode::Children*>& at,
                              std::unique_ptr<PatchNode::Children> made) const;
    std::unique_ptr<PatchNode::Children> parts_by(const PatchNode& node,
                                                  const Division& division) const;
    /// Sixteen parts of one beside a jump, side by side along that variable which tells the sides
    /// of the jump apart; of a thin one along its length.
    std::unique_ptr<PatchNode::Children> jump_parts(const PatchNode& node) const;
    void make_forms(const PatchForms::Boxes& boxes, PatchNode::Children& parts) const;
    /// Sets those forms that models tell; returns whether all are good.
    bool make_models(std::span<const UvBox> boxes, PatchNode::Children& parts) const;

    std::optional<Box> box_;
    PatchForms forms_;
    mutable PatchNode root_;
    mutable std::atomic<std::size_t> nodes_ = 1;
};

/// The tree of a surface with PatchCode, kept from frame to frame while the uniforms stay.
std::shared_ptr<const PatchTree> patch_tree(const Kernel& kernel, const Uniforms& uniforms);

/// The tree that a frame was given (TraceFrame::prepared).
const PatchTree& tree_of(const TraceFrame& frame);

}  // namespace zeroset
