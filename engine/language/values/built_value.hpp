#pragma once

#include "engine/expr/expr.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// A value: a node of the graph, which is a number or a truth value, or several values.
struct BuiltValue {
    enum class Kind : std::uint8_t {
        Single,
        Complex,  ///< 2 numbers: the real part and the imaginary one
        Vector,   ///< 2 to 4 numbers: (x, y, z)
        List,     ///< any number of numbers or vectors: [1, 2, 3]
    };

    NodeId id = 0;
    bool condition = false;  ///< true: a truth value
    Kind kind = Kind::Single;
    std::shared_ptr<const std::vector<BuiltValue>> parts{};  ///< nullptr: a single one

    static BuiltValue of_parts(Kind kind, std::vector<BuiltValue> parts);
    static BuiltValue complex(NodeId re, NodeId im) {
        return of_parts(Kind::Complex, {{.id = re}, {.id = im}});
    }
    static BuiltValue vector(std::vector<BuiltValue> numbers) {
        return of_parts(Kind::Vector, std::move(numbers));
    }
    static BuiltValue list(std::vector<BuiltValue> elements) {
        return of_parts(Kind::List, std::move(elements));
    }

    [[nodiscard]] bool is_single() const { return kind == Kind::Single; }
    [[nodiscard]] bool is_complex() const { return kind == Kind::Complex; }
    [[nodiscard]] bool is_vector() const { return kind == Kind::Vector; }
    [[nodiscard]] bool is_list() const { return kind == Kind::List; }
    /// Number of parts; 1 for a single value.
    [[nodiscard]] std::size_t size() const { return parts ? parts->size() : 1; }
    /// The part at `index`; a single value has itself at each.
    [[nodiscard]] const BuiltValue& part(std::size_t index) const {
        return parts ? (*parts)[index] : *this;
    }
    /// The numbers of a vector of 3; nothing of another value.
    [[nodiscard]] std::optional<std::array<NodeId, 3>> point() const;
    /// "a number", "a vector of 3 numbers" or "a list of 5", in the user's language.
    [[nodiscard]] std::string described() const;
};

using BuiltValues = std::vector<BuiltValue>;

}  // namespace zeroset
