#pragma once

#include "engine/mesh/solid.hpp"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

// Facts over boxes, by enclosures, about a solid's function: the greatest of what its nodes make of
// the parts and of its cuts.

namespace zeroset {

/// Where a box lies.
enum class BoxSide : std::uint8_t { Inside, Outside, Unknown };

/// An enclosure of the gradients that a function has in a box.
struct GradientBox {
    glm::dvec3 lo, hi;

    [[nodiscard]] glm::dvec3 middle() const { return 0.5 * (lo + hi); }
};

/// The facts proved of the solid's function in a box.
struct BoxFacts {
    static constexpr std::size_t most_gradients = 3;

    BoxSide side = BoxSide::Unknown;
    /// Whether the function is continuous and `gradients` hold all that it has near its zeros;
    /// always false where its side is known.
    bool graded = false;
    bool kinked = false;  ///< whether it may have a kink near its zeros
    std::uint8_t count = 0;
    std::uint32_t part = 0;  ///< SolidValue::part of the last of `gradients`
    /// The gradients of each part and cut whose zeros may be the function's in the box.
    std::array<GradientBox, most_gradients> gradients{};

    [[nodiscard]] std::span<const GradientBox> all() const { return {gradients.data(), count}; }
    void add(const GradientBox& gradient, std::size_t of_part);
    /// Adds the gradient of a part times `sign`; ungraded where it is not known.
    void take(const GradientBox& gradient, std::size_t of_part, double sign);
};

/// Asks for facts over boxes; one for each thread. In upward rounding.
class FieldOnBoxes {
public:
    explicit FieldOnBoxes(const MeshSolid& solid)
        : solid_(solid), node_ranges_(solid.nodes.size()) {}

    /// `facts` has as many items as `boxes`.
    void evaluate(std::span<const Box> boxes, std::span<BoxFacts> facts);

private:
    struct PartRange {
        double lo, hi;
        bool continuous, kink, nowhere;
    };
    struct Range {
        double lo, hi;
    };
    /// A leaf whose zeros may be the function's in a box.
    struct Touch {
        std::uint32_t box;
        std::uint32_t part;
        double sign;
    };

    void evaluate_some(std::span<const Box> boxes, std::span<BoxFacts> facts);
    void find_ranges(std::span<const Box> boxes);
    [[nodiscard]] const PartRange& range(std::size_t part, std::size_t box) const {
        return ranges_[part * count_ + box];
    }
    void find_side(const Box& box, std::size_t i, BoxFacts& facts);
    void find_touches(std::uint32_t node, std::uint32_t box);
    void take_gradients(std::span<const Box> boxes, std::span<BoxFacts> facts);

    const MeshSolid& solid_;
    std::vector<PartRange> ranges_;
    std::vector<Range> node_ranges_;  ///< of one box
    std::vector<Touch> touches_;
    std::size_t count_ = 0;
};

}  // namespace zeroset
