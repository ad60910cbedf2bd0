#include "engine/language/words/commands.hpp"

#include "engine/base/text.hpp"
#include "engine/language/words/command_parts.hpp"
#include "engine/language/words/command_rules.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

constexpr std::string_view line_ends = "\n\v\r";  // \v within a row

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
        constexpr std::size_t longest = 20'000;  // bytes of a command's arguments
        constexpr int most_commands = 200;
        const bool calls = looked_at_ < most_commands && known != commands.end() &&
                           opener < text_.size() && (text_[opener] == '(' || text_[opener] == '[');
        const auto closer = calls ? closing_bracket(text_.substr(opener, longest)) : std::nullopt;
        if (calls) ++looked_at_;
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

    [[nodiscard]] std::size_t behind_blanks(std::size_t at) const {
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
    int looked_at_ = 0;                                            ///< commands
    bool rewrites_ = false;
};

}  // namespace

std::optional<std::string> without_commands(std::string_view text) {
    return CommandText(text).rewrite();
}

}  // namespace zeroset
