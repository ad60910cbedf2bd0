#include "engine/language/syntax/syntax_marks.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/vocabulary/functions.hpp"
#include "engine/language/vocabulary/parse_notes.hpp"
#include "engine/language/words/syntax_bars.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

namespace zeroset {
namespace {

/// Deepest nesting of brackets; the parser refuses deeper ones.
constexpr std::size_t deepest = 1100;

/// The replacement of a token.
enum class Mark : std::uint8_t { Stays, Or, And, Nothing, Point, Ends, Label };

enum class Place : std::uint8_t { Statement, Call, Group, Braces };

/// A comma; it may be a decimal point if digits stand directly before and after it.
struct Comma {
    std::size_t at;
    bool may_be_point;
    bool behind_connective = false;  ///< an "and" or a bar follows the comma
    bool before_comparison = false;  ///< a comparison starts after it
};

struct Frame {
    Place place = Place::Statement;
    const Token* called = nullptr;  ///< the name before the bracket
    bool is_condition = false;      ///< everything in it is a condition
    std::size_t colons = 0;
    std::size_t choices = 0;      ///< "?" still without their ":"
    std::size_t comparisons = 0;  ///< < > <= >= != and connectives
    std::size_t equals = 0;
    std::size_t part_begin = 0;  ///< comparisons + equals before the last separator
    std::vector<Comma> commas;
    std::vector<Bar> bars;  ///< since the last separator
};

bool is_digits(const Token& token) {
    return token.kind == TokenKind::Number && std::ranges::all_of(token.text, is_digit);
}

class MarkReader {
public:
    MarkReader(std::vector<Token> tokens, const DefinedNames& defined, Notes& notes)
        : tokens_(std::move(tokens)),
          defined_(defined),
          notes_(notes),
          marks_(tokens_.size(), Mark::Stays) {}

    std::vector<Token> read() {
        frames_.push_back({});
        for (std::size_t at = 0; at < tokens_.size(); ++at) {
            read_token(at);
            if (frames_.size() > deepest) return std::move(tokens_);
        }
        return result();
    }

private:
    void read_token(std::size_t at);
    void open(std::size_t at);
    void close(std::size_t at);
    void end_statement(std::size_t at);
    void note_sign(std::size_t at);
    void comma(std::size_t at);
    void colon(std::size_t at);
    [[nodiscard]] bool is_label(std::size_t at) const;
    void ampersand(std::size_t at);
    void end_operand_behind_comma();
    void compare_behind_comma();
    /// Decides on the bars since the last separator.
    void end_part();
    void decide_commas(const Frame& frame);
    [[nodiscard]] bool takes(const Token& name, std::size_t arguments) const;
    [[nodiscard]] bool is_function(const Token& name) const;
    void make_points(const std::vector<Comma>& commas);
    void decide_conditions(const Frame& frame);
    [[nodiscard]] bool wants_condition() const;
    std::vector<Token> result();

    Frame& frame() { return frames_.back(); }

    std::vector<Token> tokens_;
    const DefinedNames& defined_;
    Notes& notes_;
    std::vector<Mark> marks_;
    std::vector<Frame> frames_;
    std::size_t statement_ = 0;  ///< index of the statement's first token
};

void MarkReader::read_token(std::size_t at) {
    const Token& token = tokens_[at];
    if (token.kind == TokenKind::Break || token.kind == TokenKind::End) return end_statement(at);
    if (is_symbol(token, {"(", "[", "{", "(|", "⌊", "⌈"})) return open(at);
    if (is_symbol(token, {")", "]", "}", "|)", "⌋", "⌉"})) return close(at);
    if (is_symbol(token, {","})) return comma(at);
    if (is_symbol(token, {":"})) return colon(at);
    if (is_symbol(token, {"&"})) return ampersand(at);
    const bool parts = is_symbol(token, {"|"}) || is_connective(token);
    if (parts) end_operand_behind_comma();
    if (is_symbol(token, {"|"})) {
        frame().bars.push_back({.at = at, .comparisons = frame().comparisons + frame().equals});
    } else if (is_symbol(token, {"?"})) {
        end_part();
        ++frame().choices;
    } else if (is_symbol(token, {"<", ">", "<=", ">=", "!="}) || is_connective(token)) {
        compare_behind_comma();
        ++frame().comparisons;
    } else if (is_symbol(token, {"=", "==", ":="})) {
        ++frame().equals;
    }
}

bool MarkReader::is_function(const Token& name) const {
    return name.kind == TokenKind::Name &&
           (find_function(name.text) != nullptr || defined_.defines_function(name.text));
}

bool MarkReader::takes(const Token& name, std::size_t arguments) const {
    if (defined_.defines_function(name.text)) return defined_.takes(name.text, arguments);
    const Function* const function = find_function(name.text);
    return function != nullptr && function->takes(arguments);
}

/// Whether a condition is expected here: after "if(" up to the comma, or in { }.
bool MarkReader::wants_condition() const {
    const Frame& frame = frames_.back();
    const bool behind_if = frame.called != nullptr && frame.called->text == "if";
    return frame.is_condition || frame.place == Place::Braces ||
           (behind_if && frame.commas.empty());
}

void MarkReader::open(std::size_t at) {
    Frame inner;
    const Token* const before = at > statement_ ? &tokens_[at - 1] : nullptr;
    if (is_symbol(tokens_[at], {"{"})) {
        inner.place = Place::Braces;
    } else if (before != nullptr && before->kind == TokenKind::Name &&
               is_symbol(tokens_[at], {"(", "["}) && !is_logic_word(before->text)) {
        inner.place = Place::Call;
        inner.called = before;
    } else {
        inner.place = Place::Group;
        inner.is_condition = wants_condition();
    }
    frames_.push_back(std::move(inner));
}

void MarkReader::close(std::size_t) {
    end_part();
    if (frames_.size() == 1) return;
    const Frame inner = std::move(frames_.back());
    frames_.pop_back();
    decide_commas(inner);
    if (inner.place != Place::Group) return;
    frame().comparisons += inner.comparisons;
    frame().equals += inner.equals;
}

void MarkReader::end_statement(std::size_t at) {
    end_part();
    if (frames_.size() == 1) decide_commas(frame());
    note_sign(at);
    frames_.clear();
    frames_.push_back({});
    statement_ = at + 1;
}

/// Notes that a line that starts with a sign may have been meant to continue the one before.
void MarkReader::note_sign(std::size_t at) {
    if (tokens_[at].text != "\n" || at == statement_) return;
    const Token& next = tokens_[at + 1];
    const bool may_go_on =
        is_symbol(next, {"+"}) || (is_symbol(next, {"-"}) && frames_.front().equals == 0);
    if (!may_go_on) return;
    notes_.add(next.offset,
               filled(tr("this line stands alone; to go on with the one above end that with {0}"),
                      {next.text}));
}

void MarkReader::end_part() {
    Frame& here = frame();
    const std::size_t comparisons = here.comparisons + here.equals;
    if (!here.bars.empty()) {
        const BarPlace place{.comparisons = comparisons - here.part_begin,
                             .is_condition = wants_condition()};
        for (const std::size_t bar : bars_that_mean_or(tokens_, here.bars, place, notes_)) {
            marks_[bar] = Mark::Or;
            ++here.comparisons;
            const bool doubled =
                is_symbol(tokens_[bar + 1], {"|"}) && !has_space_before(tokens_, bar + 1);
            if (doubled) marks_[bar + 1] = Mark::Nothing;
        }
        here.bars.clear();
    }
    here.part_begin = here.comparisons + here.equals;
}

void MarkReader::comma(std::size_t at) {
    end_part();
    const bool digits =
        at > statement_ && is_digits(tokens_[at - 1]) && adjacent(tokens_[at - 1], tokens_[at]) &&
        adjacent(tokens_[at], tokens_[at + 1]) && tokens_[at + 1].kind == TokenKind::Number &&
        is_digit(tokens_[at + 1].text[0]) && !tokens_[at + 1].text.contains('.');
    auto& commas = frame().commas;
    const bool behind_other =
        !commas.empty() && commas.back().may_be_point && commas.back().at + 2 == at;
    commas.push_back({.at = at, .may_be_point = digits && !behind_other});
}

/// Whether a name such as eq or e1 stands between the statement's start and the ":".
bool MarkReader::is_label(std::size_t at) const {
    if (at == statement_ || !begins_operand(tokens_[at + 1])) return false;
    const Token& first = tokens_[statement_];
    if (first.kind != TokenKind::Name) return false;
    if (at == statement_ + 1) return !is_built_in(first.text);
    return at == statement_ + 2 && is_digits(tokens_[statement_ + 1]) &&
           adjacent(first, tokens_[statement_ + 1]);
}

/// Decides on a ":". Outside brackets it ends a surface, as in K3DSurf, or follows the name of an
/// equation.
void MarkReader::colon(std::size_t at) {
    end_part();
    Frame& here = frame();
    ++here.colons;
    if (here.choices > 0) {
        --here.choices;
        return;
    }
    if (here.place != Place::Statement) return;
    if (is_label(at)) {
        marks_[at] = Mark::Label;
        notes_.add(tokens_[at].offset,
                   tr("what stands before ':' is taken as a name for what follows"));
        statement_ = at + 1;
        return;
    }
    notes_.add(tokens_[at].offset, tr("':' ends a surface here, as ';' does"));
    marks_[at] = Mark::Ends;
    end_statement(at);
}

void MarkReader::ampersand(std::size_t at) {
    const bool joins = at > statement_ && ends_operand(tokens_[at - 1]) &&
                       (begins_operand(tokens_[at + 1]) || is_symbol(tokens_[at + 1], {"-", "|"}) ||
                        tokens_[at + 1].kind == TokenKind::End);
    const bool behind_bar = at > statement_ && is_symbol(tokens_[at - 1], {"|"});
    marks_[at] = joins || behind_bar ? Mark::And : Mark::Nothing;
    if (marks_[at] == Mark::And) {
        end_part();
        end_operand_behind_comma();
        ++frame().comparisons;
        return;
    }
    const bool at_relation = is_symbol(tokens_[at + 1], {"=", "==", "<", ">", "<=", ">="});
    if (!at_relation)
        notes_.add(tokens_[at].offset, tr("this & means nothing; for a condition type and"));
}

/// Notes a connective after the last comma: what follows it is no comparison that starts at the
/// comma.
void MarkReader::end_operand_behind_comma() {
    if (!frame().commas.empty()) frame().commas.back().behind_connective = true;
}

void MarkReader::compare_behind_comma() {
    if (frame().commas.empty()) return;
    Comma& last = frame().commas.back();
    last.before_comparison = last.before_comparison || !last.behind_connective;
}

/// Treats each comma as followed by a condition, except those that are decimal points.
void MarkReader::decide_conditions(const Frame& frame) {
    std::vector<Comma> points;
    for (const Comma& comma : frame.commas) {
        if (comma.may_be_point && !comma.before_comparison) points.push_back(comma);
    }
    make_points(points);
}

void MarkReader::decide_commas(const Frame& frame) {
    std::vector<Comma> points = frame.commas;
    std::erase_if(points, [](const Comma& comma) { return !comma.may_be_point; });
    if (points.empty()) return;
    const std::size_t commas = frame.commas.size();
    const std::size_t fewer = commas - points.size();
    if (frame.place == Place::Call) {
        if (!is_function(*frame.called)) return;
        if (!takes(*frame.called, commas + 1)) {
            if (takes(*frame.called, fewer + 1)) make_points(points);
            return;
        }
        const bool mixed = std::ranges::any_of(frame.commas, [&](const Comma& comma) {
            return has_space_before(tokens_, comma.at + 1);
        });
        if (!mixed || !takes(*frame.called, fewer + 1)) return;
        const std::string typed = shown_number(tokens_[points.front().at - 1].text);
        notes_.add(
            tokens_[points.front().at].offset,
            filled(tr("the comma behind {0} separates two values; type decimals with a point"),
                   {typed}));
    } else if (frame.place == Place::Group) {
        if (fewer == 0) make_points(points);
    } else if (frame.place == Place::Statement || frame.colons == 0) {
        decide_conditions(frame);
    } else {
        const auto is_list = [&](std::size_t count) {
            return count == frame.colons || count + 1 == frame.colons;
        };
        if (!is_list(commas) && is_list(fewer)) make_points(points);
    }
}

void MarkReader::make_points(const std::vector<Comma>& commas) {
    for (const Comma& comma : commas) {
        marks_[comma.at] = Mark::Point;
        const std::string left = shown_number(tokens_[comma.at - 1].text);
        const std::string right = shown_number(tokens_[comma.at + 1].text);
        const std::string number = left + "." + right;
        const char* const note =
            right.size() == 3
                ? tr("{0} is read as {1}; for a thousand times as much type {2}")
                : tr("{0} is read as {1}; for two values put a space behind the comma");
        notes_.add(tokens_[comma.at].offset,
                   filled(note, {left + "," + right, number, left + right}));
    }
}

/// The tokens, replaced as their marks say.
std::vector<Token> MarkReader::result() {
    std::size_t kept = 0;
    for (std::size_t at = 0; at < tokens_.size(); ++at) {
        Token token = tokens_[at];
        switch (marks_[at]) {
            case Mark::Nothing: continue;
            case Mark::Point: {
                Token& number = tokens_[kept - 1];
                number.length = tokens_[at + 1].end() - number.offset;
                number.text = {number.text.data(), number.length};
                ++at;
                continue;
            }
            case Mark::Or:
                token.kind = TokenKind::Name;
                token.text = "or";
                break;
            case Mark::And:
                token.kind = TokenKind::Name;
                token.text = "and";
                break;
            case Mark::Label: token.text = label_mark; break;
            case Mark::Ends:
                token.kind = TokenKind::Break;
                token.text = ";";
                break;
            case Mark::Stays: break;
        }
        tokens_[kept++] = token;
    }
    tokens_.resize(kept);
    return std::move(tokens_);
}

}  // namespace

std::vector<Token> with_plain_marks(std::vector<Token> tokens, const DefinedNames& defined,
                                    Notes& notes) {
    return MarkReader(std::move(tokens), defined, notes).read();
}

}  // namespace zeroset
