#include "engine/base/language.hpp"

#include "engine/base/enum_names.hpp"
#include "engine/base/text.hpp"

#include <langinfo.h>
#include <locale.h>  // NOLINT(modernize-deprecated-headers): newlocale is of POSIX

#include <clocale>
#include <cstdlib>

namespace zeroset {
namespace {

constexpr auto codes = enum_names<Language>("en", "de", "fr", "es");

std::string variable(const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr ? value : "";
}

/// The variable that says which locale messages are in: the first that is set.
const std::string& messages_locale(const LocaleVariables& variables) {
    if (!variables.lc_all.empty()) return variables.lc_all;
    return variables.lc_messages.empty() ? variables.lang : variables.lc_messages;
}

/// The language of a locale such as "de_AT.UTF-8@euro".
std::optional<Language> language_of(std::string_view locale) {
    return language_named(locale.substr(0, locale.find_first_of("_.@")));
}

bool is_plain(std::string_view locale) {
    return locale.empty() || locale == "C" || locale == "POSIX";
}

/// The mark of the system's locale, if the system has that.
std::optional<char> system_mark() {
    const locale_t numbers = ::newlocale(LC_NUMERIC_MASK, "", nullptr);
    if (numbers == nullptr) return std::nullopt;
    const std::string mark = ::nl_langinfo_l(RADIXCHAR, numbers);
    ::freelocale(numbers);
    if (mark != "." && mark != ",") return std::nullopt;
    return mark.front();
}

}  // namespace

std::string_view name_of(Language language) { return codes.of(language); }
std::optional<Language> language_named(std::string_view code) { return codes.named(code); }

const char* own_name(Language language) {
    switch (language) {
        case Language::English: return "English";
        case Language::German: return "Deutsch";
        case Language::French:
            return "Fran\xC3\xA7"
                   "ais";
        case Language::Spanish: return "Espa\xC3\xB1ol";
    }
    return "";
}

LocaleVariables locale_variables() {
    return {.language = variable("LANGUAGE"),
            .lc_all = variable("LC_ALL"),
            .lc_messages = variable("LC_MESSAGES"),
            .lang = variable("LANG")};
}

Language desktop_language(const LocaleVariables& variables) {
    const std::string& locale = messages_locale(variables);
    if (is_plain(locale)) return Language::English;
    for (const std::string_view wished : split(variables.language, ':')) {
        if (const auto language = language_of(wished)) return *language;
    }
    return language_of(locale).value_or(Language::English);
}

char decimal_mark_of(Language language, const LocaleVariables& variables) {
    const char usual = language == Language::English ? '.' : ',';
    const bool is_desktops = !is_plain(messages_locale(variables)) &&
                             language_of(messages_locale(variables)) == language;
    return is_desktops ? system_mark().value_or(usual) : usual;
}

}  // namespace zeroset
