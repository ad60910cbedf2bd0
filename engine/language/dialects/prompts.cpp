#include "engine/language/dialects/prompts.hpp"

#include "engine/base/text.hpp"
#include "engine/language/dialects/parts.hpp"

#include <initializer_list>

namespace zeroset {
namespace {

constexpr std::size_t longest_prompt = 12;  // bytes

/// The length of Maple's `with(plots):` or `restart:`, behind which more may stand.
std::size_t maple_length(std::string_view text) {
    if (text.starts_with("restart:")) return 8;
    const bool loads = text.starts_with("with") && text.substr(0, longest_prompt * 3).contains(':');
    if (!loads) return 0;
    const std::size_t colon = text.find(':');
    const auto inside = in_brackets(text.substr(4, colon - 4));
    return inside && is_word(*inside) ? colon + 1 : 0;
}

}  // namespace

/// Whether the text is one of a program with this prompt: it begins so.
bool Prompts::has(std::string_view prompt) const {
    return trimmed(typed_).starts_with(prompt == "....:" ? std::string_view("sage:") : prompt);
}

std::size_t Prompts::behind(std::size_t at) const {
    const std::string_view rest = typed_.substr(at);
    std::size_t length = 0;
    for (const std::string_view prompt : {"sage:", ">>>", ">>", "> ", "....:"}) {
        if (length == 0 && rest.starts_with(prompt) && has(prompt)) length = prompt.size();
    }
    const std::string_view near = rest.substr(0, longest_prompt);
    if (rest.starts_with("In[") && near.contains("]:=")) length = rest.find("]:=") + 3;
    if (rest.starts_with("(%i") && near.contains(')')) length = rest.find(')') + 1;
    while (const std::size_t further = maple_length(rest.substr(length))) {
        length += further;
        length += blank_length(rest.substr(length));
    }
    return length == 0 ? at : at + length + blank_length(rest.substr(length));
}

bool Prompts::is_output(std::size_t at) const {
    if (!typed_.starts_with("sage:")) return false;
    const std::size_t line = typed_.substr(0, at).find_last_of(line_ends);
    const std::string_view row = typed_.substr(line == std::string_view::npos ? 0 : line + 1);
    const std::string_view before =
        trimmed(typed_.substr(0, line == std::string_view::npos ? 0 : line));
    const bool has_prompt = row.starts_with("sage:") || row.starts_with("....:");
    return !has_prompt && !before.ends_with("\n;");
}

}  // namespace zeroset
