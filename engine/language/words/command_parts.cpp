#include "engine/language/words/command_parts.hpp"

#include "engine/base/text.hpp"

#include <cctype>

namespace zeroset {
namespace {

bool is_blank(char sign) { return std::isspace(static_cast<unsigned char>(sign)) != 0; }
bool is_of_word(char sign) {
    return std::isalnum(static_cast<unsigned char>(sign)) != 0 || sign == '_';
}

/// How deep brackets are open behind a sign; in quotes they stay as they are.
class Depth {
public:
    void take(char sign) {
        if (quote_ != '\0') {
            if (sign == quote_) quote_ = '\0';
        } else if (sign == '"' || sign == '\'') {
            quote_ = sign;
        } else if (std::string_view("([{").contains(sign)) {
            ++depth_;
        } else if (std::string_view(")]}").contains(sign)) {
            --depth_;
        }
    }
    [[nodiscard]] bool is_outside() const { return depth_ == 0 && quote_ == '\0'; }

private:
    int depth_ = 0;
    char quote_ = '\0';
};

}  // namespace

std::size_t word_length(std::string_view text) {
    if (text.empty() || std::isdigit(static_cast<unsigned char>(text.front())) != 0) return 0;
    std::size_t length = 0;
    while (length < text.size() && is_of_word(text[length]))
        ++length;
    return length;
}

bool is_word(std::string_view text) { return !text.empty() && word_length(text) == text.size(); }

std::optional<std::size_t> closing_bracket(std::string_view text) {
    Depth depth;
    for (std::size_t i = 0; i < text.size(); ++i) {
        depth.take(text[i]);
        if (depth.is_outside()) return i;
    }
    return std::nullopt;
}

std::vector<std::string_view> split_outside(std::string_view text, char mark) {
    std::vector<std::string_view> parts;
    Depth depth;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_mark = text[i] == mark || (mark == ' ' && is_blank(text[i]));
        if (is_mark && depth.is_outside()) {
            parts.push_back(trimmed(text.substr(begin, i - begin)));
            begin = i + 1;
        }
        depth.take(text[i]);
    }
    parts.push_back(trimmed(text.substr(begin)));
    if (mark == ' ') std::erase_if(parts, [](std::string_view part) { return part.empty(); });
    return parts;
}

std::optional<std::string_view> in_brackets(std::string_view text) {
    text = trimmed(text);
    const bool opens = !text.empty() && std::string_view("([{").contains(text.front());
    if (!opens || closing_bracket(text) != text.size() - 1) return std::nullopt;
    return text.substr(1, text.size() - 2);
}

std::string CommandRange::text() const {
    return std::string(lo).append("<").append(name).append("<").append(hi);
}

std::optional<CommandRange> range_of(std::string_view argument) {
    if (const auto inside = in_brackets(argument)) {
        const auto parts = split_outside(*inside, ',');
        if (parts.size() != 3 || !is_word(parts[0])) return std::nullopt;
        return CommandRange{.name = parts[0], .lo = parts[1], .hi = parts[2]};
    }
    const std::size_t length = word_length(argument);
    const std::string_view behind = trimmed(argument.substr(length));
    const std::size_t dots = behind.find("..");
    if (length == 0 || !behind.starts_with('=') || dots == std::string_view::npos)
        return std::nullopt;
    return CommandRange{.name = argument.substr(0, length),
                        .lo = trimmed(behind.substr(1, dots - 1)),
                        .hi = trimmed(behind.substr(dots + 2))};
}

std::optional<CommandHandle> handle_of(std::string_view argument) {
    const std::string_view list = argument.starts_with('@') ? trimmed(argument.substr(1)) : "";
    const auto closer = list.starts_with('(') ? closing_bracket(list) : std::nullopt;
    if (!closer) return std::nullopt;
    return CommandHandle{.names = split_outside(list.substr(1, *closer - 1), ','),
                         .body = trimmed(list.substr(*closer + 1))};
}

}  // namespace zeroset
