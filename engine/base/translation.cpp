#include "engine/base/translation.hpp"

#include <boost/locale/gnu_gettext.hpp>
#include <boost/locale/message.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <locale>
#include <vector>

namespace zeroset {
namespace {

using Messages = boost::locale::message_format<char>;

/// Holds the messages of a language, to the end of the program.
class Catalog {
public:
    Catalog(std::string_view code, std::string_view bytes) {
        boost::locale::gnu_gettext::messages_info info;
        info.language = std::string(code);
        info.encoding = "UTF-8";
        info.locale_category = "LC_MESSAGES";
        info.domains.emplace_back("zeroset");
        info.paths = {""};
        info.callback = [bytes](const std::string&, const std::string&) {
            return std::vector<char>(bytes.begin(), bytes.end());
        };
        messages_ = boost::locale::gnu_gettext::create_messages_facet<char>(info);
        holder_ = std::locale(std::locale::classic(), messages_);
    }

    [[nodiscard]] const Messages& messages() const { return *messages_; }

private:
    const Messages* messages_ = nullptr;
    std::locale holder_;  // owns them
};

/// nullptr for English, which needs none.
const Messages* messages_of(Language language) {
    if (language == Language::English) return nullptr;
    static const std::array<Catalog, 3> catalogs{
        {{name_of(Language::German), message_catalogs()[0]},
         {name_of(Language::French), message_catalogs()[1]},
         {name_of(Language::Spanish), message_catalogs()[2]}}};
    return &catalogs.at(static_cast<std::size_t>(language) - 1).messages();
}

/// The language that was set, as all threads read it.
struct Chosen {
    std::atomic<Language> language = Language::English;
    std::atomic<const Messages*> messages = nullptr;  // none: English
    std::atomic<char> decimal_mark = '.';
};

Chosen& chosen() {
    static Chosen now;
    return now;
}

const char* found(const char* context, const char* english) {
    const Messages* const messages = chosen().messages.load(std::memory_order_acquire);
    if (messages == nullptr || *english == '\0') return english;
    const char* const text = messages->get(0, context, english);
    return text != nullptr ? text : english;
}

}  // namespace

void set_language(Language language, char decimal_mark) {
    Chosen& now = chosen();
    now.messages.store(messages_of(language), std::memory_order_release);
    now.language = language;
    now.decimal_mark = decimal_mark;
}

Language language() { return chosen().language; }
char decimal_mark() { return chosen().decimal_mark; }

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
