#include "engine/base/translation.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ranges>
#include <string>

namespace zeroset {
namespace {

/// The messages of a language as GNU gettext's msgfmt writes them: pairs of numbers, the length and
/// the place of a text, of all English texts in their order, then of all translations.
class Messages {
public:
    /// `bytes`: a whole file in this machine's byte order; outlives this.
    explicit Messages(std::string_view bytes) : bytes_(bytes) {}

    /// The translation of a text, in its context unless that is nullptr; nullptr: there is none.
    [[nodiscard]] const char* find(const char* context, const char* english) const {
        std::string wanted = context == nullptr ? "" : std::string(context) + '\4';
        wanted += english;
        const auto places = std::views::iota(std::uint32_t{0}, number(count_at));
        const auto english_of = [this](std::uint32_t i) { return text(number(english_at), i); };
        const auto found = std::ranges::lower_bound(places, wanted, {}, english_of);
        if (found == places.end() || english_of(*found) != wanted) return nullptr;
        return text(number(translations_at), *found).data();
    }

private:
    static constexpr std::size_t count_at = 8, english_at = 12, translations_at = 16;

    [[nodiscard]] std::uint32_t number(std::size_t at) const {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes_.data() + at, sizeof value);
        return value;
    }
    /// Text i of a table of pairs; a zero follows it.
    [[nodiscard]] std::string_view text(std::size_t table, std::size_t i) const {
        return bytes_.substr(number(table + 8 * i + 4), number(table + 8 * i));
    }

    std::string_view bytes_;
};

/// nullptr for English, which needs none.
const Messages* messages_of(Language language) {
    if (language == Language::English) return nullptr;
    static const std::array<Messages, 3> catalogs{Messages(message_catalogs()[0]),
                                                  Messages(message_catalogs()[1]),
                                                  Messages(message_catalogs()[2])};
    return &catalogs.at(static_cast<std::size_t>(language) - 1);
}

/// The style that was set for a thread.
struct Chosen {
    TextStyle style;
    const Messages* messages = nullptr;  // none: English
};

Chosen& chosen() {
    thread_local Chosen now;
    return now;
}

const char* found(const char* context, const char* english) {
    const Messages* const messages = chosen().messages;
    if (messages == nullptr || *english == '\0') return english;
    const char* const text = messages->find(context, english);
    return text != nullptr ? text : english;
}

}  // namespace

void set_language(Language language, char decimal_mark) {
    chosen() = {.style = {.language = language, .decimal_mark = decimal_mark},
                .messages = messages_of(language)};
}

TextStyle text_style() { return chosen().style; }
Language language() { return text_style().language; }
char decimal_mark() { return text_style().decimal_mark; }

const char* tr(const char* english) { return found(nullptr, english); }
const char* tr_in(const char* context, const char* english) { return found(context, english); }

std::string filled(std::string_view pattern, std::initializer_list<std::string_view> values) {
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const bool is_place = pattern[i] == '{' && i + 2 < pattern.size() &&
                              pattern[i + 2] == '}' && pattern[i + 1] >= '0' &&
                              pattern[i + 1] <= '9';
        const auto index =
            is_place ? static_cast<std::size_t>(pattern[i + 1] - '0') : values.size();
        if (index < values.size()) {
            text += values.begin()[index];
            i += 2;
        } else {
            text += pattern[i];
        }
    }
    return text;
}

std::string localized(std::string number) {
    if (decimal_mark() != '.') std::ranges::replace(number, '.', decimal_mark());
    return number;
}

}  // namespace zeroset
