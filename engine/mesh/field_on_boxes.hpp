#pragma once

#include "engine/mesh/solid.hpp"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

// What enclosures tell of a solid's function, the greatest of its parts and cuts, over boxes.

namespace zeroset {

/// Where a box lies.
enum class Side : std::uint8_t { Inside, Outside, Unknown };

/// An enclosure of the gradients that a function has in a box.
struct GradientBox {
    glm::dvec3 lo, hi;

    [[nodiscard]] glm::dvec3 middle() const { return 0.5 * (lo + hi); }
};

/// What is proved of the solid's function in a box.
struct BoxFacts {
    static constexpr std::size_t most_gradients = 3;

    Side side = Side::Unknown;
    /// Whether the function is continuous and `gradients` hold all that it has; always false where
    /// they were not asked for.
    bool graded = false;
    bool kinked = false;  ///< whether it may have a kink
    std::uint8_t count = 0;
    /// Of each part and cut that may be the greatest somewhere in the box.
    std::array<GradientBox, most_gradients> gradients{};

    [[nodiscard]] std::span<const GradientBox> all() const { return {gradients.data(), count}; }
    void add(const GradientBox& gradient);
};

/// Asks for facts over boxes; one for each thread. In upward rounding.
class FieldOnBoxes {
public:
    enum class Gradients : std::uint8_t { WhereUnknown, Always };

    explicit FieldOnBoxes(const MeshSolid& solid) : solid_(solid) {}

    /// `facts` has as many items as `boxes`.
    void evaluate(std::span<const Box> boxes, Gradients wanted, std::span<BoxFacts> facts);

private:
    struct PartRange {
        double lo, hi;
        bool continuous, kink, nowhere;
    };

    void evaluate_some(std::span<const Box> boxes, Gradients wanted, std::span<BoxFacts> facts);
    void find_ranges(std::span<const Box> boxes);
    void find_gradients(std::span<const Box> boxes, std::span<BoxFacts> facts);
    [[nodiscard]] BoxFacts facts_of(const Box& box, std::size_t i) const;
    [[nodiscard]] double greatest_low(const Box& box, std::size_t i) const;

    const MeshSolid& solid_;
    std::vector<PartRange> ranges_;  ///< of part p and box i at p * boxes + i
    std::size_t count_ = 0;
};

}  // namespace zeroset
