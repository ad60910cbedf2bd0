#include "engine/language/rows/reading_text.hpp"

#include <algorithm>

namespace zeroset {
namespace {

constexpr std::size_t longest_readings = 200'000;  // bytes, all definitions together

}  // namespace

ReadingText::ReadingText(const GraphValues& values, const FreeNames& names, std::size_t definitions)
    : values_(values),
      names_(names),
      longest_(std::clamp<std::size_t>(longest_readings / std::max<std::size_t>(definitions, 1), 20,
                                       2'000)) {}

std::string ReadingText::of(const BuiltValue& value, std::span<const std::string> names) const {
    if (value.is_single()) return of(value.id, names);
    if (value.is_complex())
        return of(value.part(0).id, names) + " + i*(" + of(value.part(1).id, names) + ")";
    const bool is_list = value.is_list();
    std::string text(is_list ? "[" : "(");
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (i > 0) text += ", ";
        if (text.size() > longest_) return text + "...";
        text += of(value.part(i), names);
    }
    return text + (is_list ? "]" : ")");
}

}  // namespace zeroset
