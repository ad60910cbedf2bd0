#pragma once

#include "engine/language/values/built_value.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace zeroset {

class RowScope;

/// A name with a value of its own: a function's argument, a sum's index, a variable of a row, or a
/// value in a function's body.
struct LocalName {
    std::string_view name;
    BuiltValue value;
    const LocalName* outer;
};

/// Where an expression stands: what its names mean, and where its errors are shown.
struct Context {
    std::size_t statement = 0;         ///< the one that decides which definition of a name is meant
    const LocalName* scope = nullptr;  ///< the innermost local name
    RowScope* row = nullptr;           ///< of the row that is read, if it has variables
    std::optional<std::size_t> library_offset{};  ///< of the call of a function of library.def or
                                                  ///< shapes.def, within whose body it stands
    bool reads_function = false;  ///< arguments are parameters that stand for any number

    [[nodiscard]] Context with(const LocalName* innermost) const {
        Context inner = *this;
        inner.scope = innermost;
        return inner;
    }
    /// Where an error at an offset of the syntax is shown: the bodies of library functions are not
    /// in the text.
    [[nodiscard]] std::size_t at(std::size_t offset) const {
        return library_offset.value_or(offset);
    }
};

}  // namespace zeroset
