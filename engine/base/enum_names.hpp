#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace zeroset {

/// The names of an enum's values, as they are typed; the values are 0, 1, 2 and so on.
template <class Enum, std::size_t count>
class EnumNames {
public:
    explicit constexpr EnumNames(const std::array<std::string_view, count>& names) : names_(names) {
        for (std::size_t i = 0; i < count; ++i)
            values_[i] = static_cast<Enum>(i);
    }

    [[nodiscard]] constexpr std::span<const Enum> values() const { return values_; }
    [[nodiscard]] constexpr std::string_view of(Enum value) const {
        return names_[static_cast<std::size_t>(value)];
    }
    /// The value of this name, if there is one.
    [[nodiscard]] constexpr std::optional<Enum> named(std::string_view name) const {
        const auto* const found = std::ranges::find(names_, name);
        if (found == names_.end()) return std::nullopt;
        return values_[static_cast<std::size_t>(found - names_.begin())];
    }

private:
    std::array<std::string_view, count> names_;
    std::array<Enum, count> values_{};
};

/// The names of the values of `Enum`, in their order.
template <class Enum, class... Names>
constexpr EnumNames<Enum, sizeof...(Names)> enum_names(Names... names) {
    return EnumNames<Enum, sizeof...(Names)>({std::string_view(names)...});
}

}  // namespace zeroset
