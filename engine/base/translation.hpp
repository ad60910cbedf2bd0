#pragma once

#include "engine/base/language.hpp"

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace zeroset {

/// The texts of the program in the user's language, from the catalogs in resources/languages, which
/// the program holds. The English text is the key; where there is no other it is the result.
///
/// Each thread has a language of its own, English at first: only the window sets another, and hands
/// it to the threads that work for it. scripts/messages.py finds the texts by the names of these
/// functions.

/// Lets this thread take this language, and `decimal_mark` in fields for numbers, from now on.
void set_language(Language language, char decimal_mark = '.');
Language language();
char decimal_mark();

/// A thread's language, to be handed to another thread.
struct TextStyle {
    Language language = Language::English;
    char decimal_mark = '.';
};
TextStyle text_style();
inline void set_language(const TextStyle& style) {
    set_language(style.language, style.decimal_mark);
}

/// Lets a thread write texts in a style until the end of a scope.
class WithTextStyle {
public:
    explicit WithTextStyle(TextStyle style) : before_(text_style()) { set_language(style); }
    ~WithTextStyle() { set_language(before_); }
    WithTextStyle(const WithTextStyle&) = delete;
    WithTextStyle& operator=(const WithTextStyle&) = delete;

private:
    TextStyle before_;
};

/// The work, for another thread to be done in the style of this one.
template <class Work>
auto in_this_style(Work work) {
    return [style = text_style(), work = std::move(work)] {
        const WithTextStyle with(style);
        return work();
    };
}

/// The text in the user's language. The result lives as long as the program.
const char* tr(const char* english);
/// The text of a place that `context` names for translators: short texts that other languages say
/// differently from place to place.
const char* tr_in(const char* context, const char* english);

/// Marks a text of a table for translators: tr() or tr_in() of it comes where it is shown.
constexpr const char* marked(const char* english) { return english; }
constexpr const char* marked_in(const char* /*context*/, const char* english) { return english; }

/// The pattern with the values in the places of {0}, {1} and so on; translations may order them
/// otherwise. Other braces stay.
std::string filled(std::string_view pattern, std::initializer_list<std::string_view> values);

/// The number, written with '.', as the user's language writes it in fields.
std::string localized(std::string number);

/// The catalogs in the format of GNU gettext (.mo), in the order of the languages after English.
std::span<const std::string_view> message_catalogs();

}  // namespace zeroset
