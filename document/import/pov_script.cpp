#include "document/import/pov_script.hpp"

#include "engine/base/translation.hpp"

#include <algorithm>
#include <array>

namespace zeroset {
namespace {

constexpr std::size_t most_steps = 200'000;
constexpr std::size_t most_repeated = 10'000'000;  // tokens
constexpr int deepest_directive = 100;
constexpr std::array<std::string_view, 7> openers{"if",  "ifdef",  "ifndef", "while",
                                                  "for", "switch", "macro"};
constexpr std::size_t most_included = 100;
/// Lines of an included file are counted from a multiple of this on.
constexpr std::size_t lines_of_file = std::size_t{1} << 32U;
/// Files of POV-Ray's own whose functions, constants and colours are known.
constexpr std::array<std::string_view, 5> known_files{"functions.inc", "colors.inc", "math.inc",
                                                      "consts.inc", "transforms.inc"};

}  // namespace

PovScript::PovScript(std::string_view text) : tokens_(script_tokens(text, true)) {}

void PovScript::note(std::size_t line, std::string_view entry, std::string reason) const {
    if (on_note) on_note(line, entry, std::move(reason));
}

const ScriptToken& PovScript::peek() {
    while (directive_depth_ < deepest_directive) {
        const bool macro_ends = !frames_.empty() && tokens_.at_end();
        const bool macro_begins = !macro_ends && at_macro();
        if (!macro_ends && !macro_begins && !tokens_.at_sign("#")) break;
        if (++steps_ > most_steps) {
            stop_long();
            break;
        }
        ++directive_depth_;
        if (macro_ends)
            leave_macro();
        else if (macro_begins)
            call_macro();
        else
            directive();
        --directive_depth_;
    }
    return tokens_.peek();
}

void PovScript::stop_long() {
    note(tokens_.line(), "#", tr("the script runs too long; the rest is left out"));
    stop();
}

bool PovScript::repeat(std::size_t tokens) {
    repeated_ += tokens;
    if (repeated_ > most_repeated) stop_long();
    return repeated_ <= most_repeated;
}

void PovScript::go_back(const Block& block) {
    if (!repeat(tokens_.position() - block.begin)) return;
    tokens_.go_to(block.begin);
    if (block.kind == Block::Kind::While) {
        begin_while(block.begin);
    } else {
        blocks_.push_back(block);
    }
}

void PovScript::stop() {
    while (!frames_.empty())
        leave_macro();
    while (!tokens_.at_end())
        tokens_.next();
    blocks_.clear();
}

const ScriptToken& PovScript::next() {
    peek();
    return tokens_.next();
}

void PovScript::skip_line(std::size_t line) {
    while (!tokens_.at_end() && tokens_.line() == line && !tokens_.at_sign("#"))
        tokens_.next();
}

void PovScript::directive() {
    const std::size_t line = tokens_.line();
    const std::size_t begin = tokens_.position();
    tokens_.next();
    const std::string word(tokens_.next().text);
    if (word == "declare" || word == "local") return declare(word == "local");
    if (word == "if") return begin_if(condition());
    if (word == "ifdef" || word == "ifndef") {
        tokens_.take_sign("(");
        const std::string_view name = tokens_.next().text;
        const bool known = value_of(name).has_value() || macros_.contains(name);
        tokens_.take_sign(")");
        return begin_if(known == (word == "ifdef"));
    }
    if (word == "else" || word == "elseif") {
        skip_to({});
        if (!blocks_.empty()) blocks_.pop_back();
        return;
    }
    if (word == "while") return begin_while(tokens_.position());
    if (word == "for") return begin_for();
    if (word == "switch") return begin_switch();
    if (word == "break") {
        leave_loop();
        return;
    }
    if (word == "case" || word == "range") {
        tokens_.skip_block("(", ")");
        return;
    }
    if (word == "end") return end_block();
    if (word == "macro") return define_macro();
    if (word == "include") return include(begin);
    if (word == "default") return tokens_.skip_block("{", "}");
    if (word == "undef") {
        values_.erase(std::string(tokens_.next().text));
        return;
    }
    skip_line(line);
}

void PovScript::include(std::size_t begin) {
    const ScriptToken file = tokens_.peek();
    if (file.kind != ScriptKind::Text) return;
    tokens_.next();
    if (is_one_of(known_files, file.text)) return;
    auto text = on_include && included_.size() < most_included ? on_include(file.text)
                                                               : std::optional<std::string>();
    if (text) included_bytes_ += text->size();
    if (!text || included_bytes_ > largest_script) {
        note(file.line, "#include " + std::string(file.text.substr(0, 60)),
             tr("it is not read; files beside the scene, and in folders below, are"));
        return;
    }
    included_.push_back(
        {.name = std::string(file.text), .text = std::move(*text), .line = file.line});
    std::vector<ScriptToken> tokens = script_tokens(included_.back().text, true);
    tokens.pop_back();  // the End
    for (ScriptToken& token : tokens)
        token.line += included_.size() * lines_of_file;
    tokens_.replace_from(begin, tokens);
}

PovScript::FileLine PovScript::file_line(std::size_t line) const {
    const std::size_t number = line / lines_of_file;
    if (number == 0 || number > included_.size()) return {.line = line};
    const Included& file = included_[number - 1];
    const FileLine outer = file_line(file.line);
    return {.line = line % lines_of_file,
            .file = file.name,
            .included_at = outer.file.empty() ? outer.line : outer.included_at};
}

void PovScript::declare(bool local) {
    const std::size_t line = tokens_.line();
    const bool is_element = at_array();
    const std::string name = is_element ? element_name() : std::string(tokens_.next().text);
    if (!tokens_.take_sign("=")) {
        skip_line(line);
        return;
    }
    if (!is_element) arrays_.erase(name);
    if (declare_array(name, local)) {
        tokens_.take_sign(";");
        return;
    }
    if (on_declare && on_declare(name)) {
        values_.erase(name);
        tokens_.take_sign(";");
        return;
    }
    const Place begin = place();
    const auto read = value();
    if (read && local) {
        set_local(name, *read);
    } else if (read) {
        values_.insert_or_assign(name, *read);
    } else {
        values_.erase(name);
        go_to(begin);
        note(line, "#declare " + name, tr("its value is not known; it is left out"));
        skip_line(line);
    }
    tokens_.take_sign(";");
}

std::string PovScript::skip_to(std::initializer_list<std::string_view> words) {
    std::size_t depth = 0;
    while (!tokens_.at_end()) {
        if (!tokens_.take_sign("#")) {
            tokens_.next();
            continue;
        }
        const std::string word(tokens_.next().text);
        if (depth == 0 && std::ranges::find(words, word) != words.end()) return word;
        if (is_one_of(openers, word)) ++depth;
        if (word == "end" && depth-- == 0) return word;
    }
    return "end";
}

/// Passes over the rest of the innermost loop or #switch, and of each #if in it.
void PovScript::leave_loop() {
    const std::size_t outer = frames_.empty() ? 0 : frames_.back().blocks;
    while (blocks_.size() > outer) {
        skip_to({});
        const Block::Kind left = blocks_.back().kind;
        blocks_.pop_back();
        if (left != Block::Kind::If) return;
    }
}

void PovScript::begin_if(bool holds) {
    while (!holds) {
        const std::string word = skip_to({"else", "elseif"});
        if (word == "end") return;
        holds = word == "else" || condition();
    }
    blocks_.push_back({.kind = Block::Kind::If});
}

void PovScript::begin_while(std::size_t begin) {
    if (condition())
        blocks_.push_back({.kind = Block::Kind::While, .begin = begin});
    else
        skip_to({});
}

void PovScript::begin_for() {
    const std::size_t line = tokens_.line();
    tokens_.take_sign("(");
    const std::string name(tokens_.next().text);
    std::array<double, 3> numbers{0.0, 0.0, 1.0};
    for (std::size_t i = 0; i < numbers.size() && tokens_.take_sign(","); ++i) {
        const auto read = value();
        if (!read) note(line, "#for", tr("its value is not known; it is left out"));
        numbers[i] = read ? (*read)[0] : 0.0;
    }
    tokens_.take_sign(")");
    values_.insert_or_assign(name, PovValue{numbers[0]});
    const bool runs =
        numbers[2] > 0.0 ? numbers[0] <= numbers[1] : numbers[2] < 0.0 && numbers[0] >= numbers[1];
    if (!runs) {
        skip_to({});
        return;
    }
    blocks_.push_back({.kind = Block::Kind::For,
                       .begin = tokens_.position(),
                       .variable = name,
                       .last = numbers[1],
                       .step = numbers[2]});
}

void PovScript::begin_switch() {
    tokens_.take_sign("(");
    const auto chosen = value();
    tokens_.take_sign(")");
    const double number = chosen ? (*chosen)[0] : 0.0;
    while (true) {
        const std::string word = skip_to({"case", "range", "else"});
        if (word == "end") return;
        if (word == "else") break;
        tokens_.take_sign("(");
        const auto low = value();
        const auto high = tokens_.take_sign(",") ? value() : low;
        tokens_.take_sign(")");
        if (low && high && (*low)[0] <= number && number <= (*high)[0]) break;
    }
    blocks_.push_back({.kind = Block::Kind::Switch});
}

void PovScript::end_block() {
    if (blocks_.size() <= (frames_.empty() ? 0 : frames_.back().blocks)) return;
    const Block block = blocks_.back();
    blocks_.pop_back();
    if (block.kind == Block::Kind::While) {
        go_back(block);
    } else if (block.kind == Block::Kind::For) {
        PovValue& variable = values_[block.variable];
        const double now = (variable.empty() ? block.last : variable[0]) + block.step;
        variable = {now};
        // A step that is lost in rounding would never end; steps_ ends it, too.
        if (block.step > 0.0 ? now > block.last + 1e-9 : now < block.last - 1e-9) return;
        go_back(block);
    }
}

bool PovScript::condition() {
    const std::size_t line = tokens_.line();
    const Place begin = place();
    tokens_.take_sign("(");
    const auto read = compared();
    if (!read) {
        note(line, "#if", tr("its condition is not known; it counts as false"));
        go_to(begin);
        tokens_.skip_block("(", ")");
        return false;
    }
    tokens_.take_sign(")");
    return (*read)[0] != 0.0;
}

}  // namespace zeroset
