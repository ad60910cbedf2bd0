#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace zeroset {

/// The languages of the program's own texts. Formulas are the same in all of them.
enum class Language : std::uint8_t { English, German, French, Spanish };

inline constexpr std::array<Language, 4> all_languages{Language::English, Language::German,
                                                       Language::French, Language::Spanish};

/// The code of ISO 639-1: en, de, fr or es.
std::string_view name_of(Language language);
std::optional<Language> language_named(std::string_view code);
/// The language's name in itself, such as "Deutsch".
const char* own_name(Language language);

/// The environment's variables that say what a desktop speaks; empty where they are not set.
struct LocaleVariables {
    std::string language = {};  ///< LANGUAGE: codes with ':' between them, the most wished first
    std::string lc_all = {};
    std::string lc_messages = {};
    std::string lang = {};
};

/// The variables of this process.
LocaleVariables locale_variables();

/// The first language that is wished and that there is, as gettext finds it; English if none is.
Language desktop_language(const LocaleVariables& variables);

/// The decimal mark of numbers in fields, '.' or ',': the desktop's where it speaks `language`
/// (Spanish is written with a point in Mexico and with a comma in Spain), else the language's.
char decimal_mark_of(Language language, const LocaleVariables& variables);

}  // namespace zeroset
