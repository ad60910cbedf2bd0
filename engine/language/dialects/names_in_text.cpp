#include "engine/language/dialects/names_in_text.hpp"

#include "engine/base/text.hpp"
#include "engine/language/dialects/parts.hpp"

#include <initializer_list>

namespace zeroset {
namespace {

using Words = std::string_view;

constexpr int most_looked_at = 20;           // places of a name, of which one may define it
constexpr std::size_t longest_head = 1'000;  // bytes

/// Whether a name gets a function's head in a text behind `at`: f = @(, f = lambda, f := (x) ->,
/// f(x) =, f[x_] :=.
bool gets_function(Words behind) {
    behind = trimmed(behind);
    for (const Words sign : {":=", "=", "<-"}) {
        if (!behind.starts_with(sign)) continue;
        const Words body = trimmed(behind.substr(sign.size()));
        const Words row = body.substr(0, body.find_first_of("\n;"));
        return row.starts_with("function") || row.starts_with("proc") ||
               unnamed_function(row).has_value();
    }
    if (!behind.starts_with('(') && !behind.starts_with('[')) return false;
    const auto closer = closing_bracket(behind.substr(0, longest_head));
    if (!closer) return false;
    const Words rest = trimmed(behind.substr(*closer + 1));
    return rest.starts_with(":=") || (rest.starts_with('=') && !rest.starts_with("=="));
}

}  // namespace

bool is_function_in(std::string_view typed, std::string_view name) {
    int looked_at = 0;
    for (std::size_t at = typed.find(name); at != Words::npos && looked_at < most_looked_at;
         at = typed.find(name, at + 1)) {
        const bool is_whole = word_length(typed.substr(at)) == name.size() &&
                              (at == 0 || word_length(typed.substr(at - 1)) <= 1);
        if (!is_whole) continue;
        ++looked_at;
        const std::string_view before = trimmed(typed.substr(0, at));
        const bool is_declared = before.ends_with("def") || before.ends_with("function") ||
                                 before.ends_with("fn") || before.ends_with("float");
        if (is_declared || gets_function(typed.substr(at + name.size()))) return true;
    }
    return false;
}

std::string_view list_in(std::string_view typed, std::string_view name) {
    for (std::size_t at = typed.find(name); at != Words::npos; at = typed.find(name, at + 1)) {
        const std::string_view behind = trimmed(typed.substr(at + name.size()));
        if (at > 0 && word_length(typed.substr(at - 1)) > name.size()) continue;
        const std::string_view value =
            behind.starts_with('=') ? trimmed(behind.substr(1)) : Words();
        const auto closer = value.starts_with('[') ? closing_bracket(value) : std::nullopt;
        if (closer) return value.substr(0, *closer + 1);
    }
    return {};
}

}  // namespace zeroset
