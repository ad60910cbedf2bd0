#include "engine/export/films/frame_names.hpp"

#include <algorithm>

namespace zeroset {

std::optional<FrameNames> FrameNames::from(const std::filesystem::path& pattern) {
    const std::string text = pattern.string();
    const std::size_t name = text.size() - pattern.filename().string().size();
    const std::size_t last = text.find_last_of('#');
    if (last == std::string::npos || last < name) return std::nullopt;
    const std::size_t other = text.find_last_not_of('#', last);
    const std::size_t first = other == std::string::npos ? 0 : other + 1;
    FrameNames names;
    names.before_ = text.substr(0, first);
    names.after_ = text.substr(last + 1);
    names.digits_ = last + 1 - first;
    return names;
}

std::filesystem::path FrameNames::path(int number) const {
    const std::string digits = std::to_string(number);
    const std::size_t zeros = digits_ - std::min(digits_, digits.size());
    return before_ + std::string(zeros, '0') + digits + after_;
}

}  // namespace zeroset
