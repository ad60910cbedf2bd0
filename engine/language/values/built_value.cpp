#include "engine/language/values/built_value.hpp"

#include "engine/base/translation.hpp"

#include <utility>

namespace zeroset {

BuiltValue BuiltValue::of_parts(Kind kind, std::vector<BuiltValue> parts) {
    return {.kind = kind,
            .parts = std::make_shared<const std::vector<BuiltValue>>(std::move(parts))};
}

std::optional<std::array<NodeId, 3>> BuiltValue::point() const {
    if (!is_vector() || size() != 3) return std::nullopt;
    return std::array{part(0).id, part(1).id, part(2).id};
}

std::string BuiltValue::described() const {
    if (is_complex()) return tr("a complex number");
    const std::string count = std::to_string(size());
    if (is_vector()) return filled(tr("a vector of {0} numbers"), {count});
    return is_list() ? filled(tr("a list of {0}"), {count}) : tr("a number");
}

}  // namespace zeroset
