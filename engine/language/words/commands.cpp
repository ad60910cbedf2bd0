#include "engine/language/words/commands.hpp"

#include "engine/base/text.hpp"
#include "engine/language/words/command_parts.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

constexpr std::string_view line_ends = "\n\v\r";  // \v within a row

using Names = std::span<const std::string_view>;
using Strings = std::vector<std::string>;

enum class CommandKind : std::uint8_t {
    Equation,  ///< an equation and the ranges of x, y and z
    Graph,     ///< a height, or a point, and the ranges of two variables
    Point,     ///< a point, and the ranges of one or two variables
    Zeros,     ///< of MATLAB: a function and an interval
    Sheet,     ///< of MATLAB: a height or three functions, and an interval
    Track,     ///< of MATLAB: three functions of one variable, and an interval
    Listed,    ///< of GeoGebra: three numbers, then variables, each before its ends
};

constexpr std::array commands = std::to_array<std::pair<std::string_view, CommandKind>>(
    {{"ContourPlot3D", CommandKind::Equation},
     {"RegionPlot3D", CommandKind::Equation},
     {"implicitplot3d", CommandKind::Equation},
     {"implicit_plot3d", CommandKind::Equation},
     {"Plot3D", CommandKind::Graph},
     {"plot3d", CommandKind::Graph},
     {"ParametricPlot3D", CommandKind::Point},
     {"parametric_plot3d", CommandKind::Point},
     {"spacecurve", CommandKind::Point},
     {"fimplicit3", CommandKind::Zeros},
     {"fsurf", CommandKind::Sheet},
     {"ezsurf", CommandKind::Sheet},
     {"ezmesh", CommandKind::Sheet},
     {"fplot3", CommandKind::Track},
     {"ezplot3", CommandKind::Track},
     {"Surface", CommandKind::Listed},
     {"Superficie", CommandKind::Listed},
     {"Curve", CommandKind::Listed},
     {"Curva", CommandKind::Listed},
     {"Kurve", CommandKind::Listed},
     {"Courbe", CommandKind::Listed}});

/// First words of lines that draw nothing and stand around plotting commands.
constexpr std::array<std::string_view, 23> idle_words{
    "syms",   "with",  "restart", "clear",    "clc",      "close",   "hold",   "figure",
    "axis",   "var",   "from",    "import",   "show",     "display", "xlabel", "ylabel",
    "zlabel", "title", "view",    "colorbar", "camlight", "shading", "grid"};

/// A statement that a command becomes: `main`, which is a part of the text, with something before
/// it and behind it.
struct Rewritten {
    std::string before;
    std::string_view main;
    std::string behind;
};

using Result = std::optional<Rewritten>;

/// The ranges among arguments; nullopt where another one says more than how the surface looks.
std::optional<std::vector<CommandRange>> ranges_in(Names arguments) {
    constexpr std::array<std::string_view, 6> telling{
        "contour", "contours", "region", "regionfunction", "coords", "scalingfunctions"};
    std::vector<CommandRange> ranges;
    for (const std::string_view argument : arguments) {
        if (const auto range = range_of(argument)) {
            ranges.push_back(*range);
            continue;
        }
        std::string name(argument.substr(0, word_length(argument)));
        for (char& letter : name)
            letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
        const std::string_view behind = trimmed(argument.substr(name.size()));
        const bool is_option =
            !name.empty() && (behind.starts_with("->") || behind.starts_with('='));
        if (!is_option || std::ranges::find(telling, name) != telling.end()) return std::nullopt;
    }
    return ranges;
}

/// Whether ranges are of these variables, in any order.
bool are_of(std::span<const CommandRange> ranges, Names names) {
    return ranges.size() == names.size() && std::ranges::all_of(names, [&](std::string_view name) {
               return std::ranges::find(ranges, name, &CommandRange::name) != ranges.end();
           });
}

std::string listed(std::span<const CommandRange> ranges) {
    std::string text;
    for (const CommandRange& range : ranges)
        text += "," + range.text();
    return text;
}

constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

Result equation_of(Names arguments) {
    const auto ranges = ranges_in(arguments.subspan(1));
    if (!ranges || !are_of(*ranges, axes) || in_brackets(arguments[0])) return std::nullopt;
    return Rewritten{.before = "", .main = arguments[0], .behind = listed(*ranges)};
}

/// A point, in brackets or as a name, over ranges.
Result point_of(std::string_view point, std::span<const CommandRange> ranges) {
    if (ranges.empty() || ranges.size() > 2) return std::nullopt;
    const auto inside = in_brackets(point);
    if (!inside) return Rewritten{.before = "", .main = point, .behind = listed(ranges)};
    const auto parts = split_outside(*inside, ',');
    if (parts.size() != 3 || in_brackets(parts[0])) return std::nullopt;
    return Rewritten{.before = "(", .main = *inside, .behind = ")" + listed(ranges)};
}

/// The graph of a height over the ranges of x and y, or of two other names.
Result graph_over(std::string_view height, std::span<const CommandRange> ranges) {
    if (ranges.size() != 2) return std::nullopt;
    if (are_of(ranges, std::span(axes).first(2)))
        return Rewritten{.before = "z=", .main = height, .behind = listed(ranges)};
    std::string before = "(";
    for (const CommandRange& range : ranges)
        before.append(range.name).append(",");
    return Rewritten{.before = std::move(before), .main = height, .behind = ")" + listed(ranges)};
}

Result graph_of(Names arguments) {
    const auto ranges = ranges_in(arguments.subspan(1));
    if (!ranges) return std::nullopt;
    if (!in_brackets(arguments[0])) return graph_over(arguments[0], *ranges);
    const bool is_point = split_outside(*in_brackets(arguments[0]), ',').size() == 3;
    const bool is_sum = split_outside(*in_brackets(arguments[0]), ',').size() == 1;
    if (is_sum) return graph_over(arguments[0], *ranges);
    return is_point ? point_of(arguments[0], *ranges) : std::nullopt;
}

/// The ranges that an interval of MATLAB gives variables; `otherwise`: those without one. Behind
/// the interval stand only words that tell how the surface looks.
std::optional<std::vector<CommandRange>> ranges_of_interval(Names arguments, Names names) {
    std::vector<std::string_view> ends{"-5", "5"};
    if (!arguments.empty() && !std::string_view("'\"").contains(arguments[0].front())) {
        const auto inside = in_brackets(arguments[0]);
        if (!inside) return std::nullopt;
        ends = split_outside(*inside, inside->contains(',') ? ',' : ' ');
    }
    if (ends.size() != 2 && ends.size() != 2 * names.size()) return std::nullopt;
    std::vector<CommandRange> ranges;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::size_t at = ends.size() == 2 ? 0 : 2 * i;
        ranges.push_back({.name = names[i], .lo = ends[at], .hi = ends[at + 1]});
    }
    return ranges;
}

/// Whether the text gives a name to a function: f = @(x, y, z) or f(x, y, z) = ...
bool is_function_in(std::string_view text, std::string_view name) {
    for (std::size_t at = text.find(name); at != std::string_view::npos;
         at = text.find(name, at + 1)) {
        const bool goes_on = at > 0 && word_length(text.substr(at - 1)) > name.size();
        const std::string_view behind = trimmed(text.substr(at + name.size()));
        const bool is_handle =
            behind.starts_with('=') && trimmed(behind.substr(1)).starts_with('@');
        if (!goes_on && (is_handle || behind.starts_with('('))) return true;
    }
    return false;
}

Result zeros_of(Names arguments, std::string_view text) {
    const auto ranges = ranges_of_interval(arguments.subspan(1), axes);
    if (!ranges) return std::nullopt;
    const auto handle = handle_of(arguments[0]);
    if (handle && !std::ranges::equal(handle->names, axes)) return std::nullopt;
    Rewritten result{.before = "", .main = handle ? handle->body : arguments[0], .behind = ""};
    if (is_word(result.main) && is_function_in(text, result.main)) result.behind = "(x,y,z)";
    const bool has_interval = arguments.size() > 1 && in_brackets(arguments[1]).has_value();
    if (has_interval) result.behind += listed(*ranges);
    return result;
}

/// A point of three functions without a name over their variables.
Result point_of_handles(Names arguments, std::size_t variables) {
    std::vector<CommandHandle> handles;
    for (std::size_t i = 0; i < 3 && i < arguments.size(); ++i) {
        const auto handle = handle_of(arguments[i]);
        if (handle) handles.push_back(*handle);
    }
    if (handles.size() != 3 || handles[0].names.size() != variables) return std::nullopt;
    if (handles[0].names != handles[1].names || handles[0].names != handles[2].names)
        return std::nullopt;
    const auto ranges = ranges_of_interval(arguments.subspan(3), handles[0].names);
    if (!ranges) return std::nullopt;
    std::string behind;
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}})
        behind.append(",").append(handles[i].body);
    return Rewritten{
        .before = "(", .main = handles[0].body, .behind = behind + ")" + listed(*ranges)};
}

Result sheet_of(Names arguments) {
    if (auto point = point_of_handles(arguments, 2)) return point;
    const auto handle = handle_of(arguments[0]);
    const Names names = handle ? Names(handle->names) : std::span(axes).first(2);
    const auto ranges = ranges_of_interval(arguments.subspan(1), names);
    if (!ranges || names.size() != 2 || is_word(arguments[0])) return std::nullopt;
    return graph_over(handle ? handle->body : arguments[0], *ranges);
}

Result listed_point_of(Names arguments) {
    if (arguments.size() != 6 && arguments.size() != 9) return std::nullopt;
    std::vector<CommandRange> ranges;
    for (std::size_t i = 3; i < arguments.size(); i += 3) {
        if (!is_word(arguments[i])) return std::nullopt;
        ranges.push_back({.name = arguments[i], .lo = arguments[i + 1], .hi = arguments[i + 2]});
    }
    const char* const end = arguments[2].data() + arguments[2].size();
    return Rewritten{
        .before = "(", .main = {arguments[0].data(), end}, .behind = ")" + listed(ranges)};
}

Result rewritten(CommandKind kind, Names arguments, std::string_view text) {
    const bool has_gap = std::ranges::any_of(arguments, &std::string_view::empty);
    if (has_gap) return std::nullopt;
    switch (kind) {
        case CommandKind::Equation: return equation_of(arguments);
        case CommandKind::Graph: return graph_of(arguments);
        case CommandKind::Point: {
            const auto ranges = ranges_in(arguments.subspan(1));
            return ranges ? point_of(arguments[0], *ranges) : std::nullopt;
        }
        case CommandKind::Zeros: return zeros_of(arguments, text);
        case CommandKind::Sheet: return sheet_of(arguments);
        case CommandKind::Track: return point_of_handles(arguments, 1);
        case CommandKind::Listed: return listed_point_of(arguments);
    }
    return std::nullopt;
}

/// Rewrites the commands of a text in place.
class CommandText {
public:
    explicit CommandText(std::string_view text) : text_(text), result_(text) {}

    std::optional<std::string> rewrite() {
        for (std::size_t line = 0; line < text_.size();) {
            const std::size_t end = std::min(text_.find_first_of(line_ends, line), text_.size());
            const std::size_t behind = command_at(line, end);
            if (behind == line) idle_lines_.emplace_back(line, end);
            line =
                behind == line ? end + 1 : behind + (text_.substr(behind).starts_with(';') ? 1 : 0);
        }
        if (!rewrites_) return std::nullopt;
        for (const auto& [begin, end] : idle_lines_)
            blank_idle(begin, end);
        return result_;
    }

private:
    /// Rewrites the command in a line, and returns the offset behind it; `line`: there is none.
    std::size_t command_at(std::size_t line, std::size_t end) {
        std::size_t at = behind_blanks(line);
        if (text_.substr(at, end - at).starts_with("sage:")) at = behind_blanks(at + 5);
        std::size_t word = word_length(text_.substr(at));
        const std::size_t equals = behind_blanks(at + word);
        if (word > 0 && equals < end && text_[equals] == '=') {
            at = behind_blanks(equals + 1);
            word = word_length(text_.substr(at));
        }
        const auto* const known = std::ranges::find(
            commands, text_.substr(at, word), &std::pair<std::string_view, CommandKind>::first);
        const std::size_t opener = behind_blanks(at + word);
        const bool calls = known != commands.end() && opener < text_.size() &&
                           (text_[opener] == '(' || text_[opener] == '[');
        const auto closer = calls ? closing_bracket(text_.substr(opener)) : std::nullopt;
        if (!closer) return line;
        std::size_t behind = behind_blanks(opener + *closer + 1);
        const bool is_maple = text_.substr(behind).starts_with(':');
        if (is_maple) behind = behind_blanks(behind + 1);
        const bool ends =
            behind == text_.size() || text_[behind] == ';' || line_ends.contains(text_[behind]);
        const auto arguments = split_outside(text_.substr(opener + 1, *closer - 1), ',');
        const auto statement = ends ? rewritten(known->second, arguments, text_) : std::nullopt;
        if (!statement || !put(*statement, line, behind)) return line;
        return behind;
    }

    std::size_t behind_blanks(std::size_t at) const {
        while (at < text_.size() && (text_[at] == ' ' || text_[at] == '\t'))
            ++at;
        return at;
    }

    /// Puts a statement in place of text_[begin..end), its main part where it was if there is room;
    /// false: it is longer than that.
    bool put(const Rewritten& statement, std::size_t begin, std::size_t end) {
        std::string words = statement.before + std::string(statement.main) + statement.behind;
        if (words.size() > end - begin) return false;
        std::ranges::replace_if(words, [](char sign) { return line_ends.contains(sign); }, ' ');
        const auto main = static_cast<std::size_t>(statement.main.data() - text_.data());
        const std::size_t wished = main - std::min(main - begin, statement.before.size());
        const std::size_t at = std::min(wished, end - words.size());
        blank(begin, end);
        result_.replace(at, words.size(), words);
        rewrites_ = true;
        return true;
    }

    void blank(std::size_t begin, std::size_t end) {
        std::fill(result_.begin() + static_cast<std::ptrdiff_t>(begin),
                  result_.begin() + static_cast<std::ptrdiff_t>(end), ' ');
    }

    /// Blanks a line that draws nothing: with(plots): and x, y = var('x, y').
    void blank_idle(std::size_t begin, std::size_t end) {
        const std::string_view line = trimmed(text_.substr(begin, end - begin));
        const std::string_view word = line.substr(0, word_length(line));
        const std::string_view behind = trimmed(line.substr(word.size()));
        const bool is_idle =
            std::ranges::find(idle_words, word) != idle_words.end() && !behind.starts_with('=');
        const std::size_t equals = line.find('=');
        const bool names_variables = equals != std::string_view::npos &&
                                     trimmed(line.substr(equals + 1)).starts_with("var(");
        if (is_idle || names_variables) blank(begin, end);
    }

    std::string_view text_;
    std::string result_;
    std::vector<std::pair<std::size_t, std::size_t>> idle_lines_;  ///< lines without a command
    bool rewrites_ = false;
};

}  // namespace

std::optional<std::string> without_commands(std::string_view text) {
    return CommandText(text).rewrite();
}

}  // namespace zeroset
