#include "tests/fuzz/mutator.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

namespace zeroset::test {
namespace {

constexpr std::size_t longest_text = 110'000;  // longer ones take too long for a fuzzer
constexpr std::size_t longest_kept = 4'000;
constexpr std::size_t most_kept = 500;

enum class Kind { Letter, Digit, Beyond, Other };

Kind kind_of(char c) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80) return Kind::Beyond;
    if (std::isalpha(byte) != 0) return Kind::Letter;
    return std::isdigit(byte) != 0 || c == '.' ? Kind::Digit : Kind::Other;
}

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// A random place between two of `size` pieces, or at an end.
std::ptrdiff_t place(RandomNumbers& random, std::size_t size) {
    return static_cast<std::ptrdiff_t>(random.below(size + 1));
}

/// Two random places in order, mostly near each other.
std::pair<std::ptrdiff_t, std::ptrdiff_t> stretch(RandomNumbers& random, std::size_t size) {
    const std::ptrdiff_t begin = place(random, size);
    const std::size_t most = random.one_in(4) ? size : 6;
    const std::ptrdiff_t end = begin + place(random, most);
    return {begin, std::min(end, static_cast<std::ptrdiff_t>(size))};
}

std::string joined(const std::vector<std::string>& pieces) {
    std::string text;
    for (const std::string& piece : pieces) {
        if (text.size() + piece.size() > longest_text) break;
        text += piece;
    }
    return text;
}

using Pieces = std::vector<std::string>;

void insert(Pieces& pieces, RandomNumbers& random, const Pieces& what) {
    pieces.insert(pieces.begin() + place(random, pieces.size()), what.begin(), what.end());
}

void remove_some(Pieces& pieces, RandomNumbers& random) {
    const auto [begin, end] = stretch(random, pieces.size());
    pieces.erase(pieces.begin() + begin, pieces.begin() + end);
}

/// Swaps two neighbouring pieces or longer stretches.
void swap_some(Pieces& pieces, RandomNumbers& random) {
    const auto [begin, end] = stretch(random, pieces.size());
    if (begin == end) return;
    std::rotate(pieces.begin() + begin, pieces.begin() + (begin + end) / 2, pieces.begin() + end);
}

void put_in_brackets(Pieces& pieces, RandomNumbers& random) {
    static constexpr std::pair<const char*, const char*> brackets[] = {
        {"(", ")"}, {"[", "]"}, {"{", "}"}, {"|", "|"}, {"\\left(", "\\right)"}, {"sqrt(", ")"}};
    const auto& [opener, closer] = brackets[random.below(std::size(brackets))];
    const auto [begin, end] = stretch(random, pieces.size());
    pieces.insert(pieces.begin() + end, closer);
    pieces.insert(pieces.begin() + begin, opener);
}

/// Repeats a stretch many times: deep nesting, long sums, many statements.
void repeat_some(Pieces& pieces, RandomNumbers& random) {
    const auto [begin, end] = stretch(random, pieces.size());
    const Pieces once(pieces.begin() + begin, pieces.begin() + end);
    const std::size_t times = random.one_in(8) ? 1 + random.below(3000) : 1 + random.below(5);
    Pieces many;
    for (std::size_t i = 0; i < times && many.size() < longest_text; ++i)
        many.insert(many.end(), once.begin(), once.end());
    pieces.insert(pieces.begin() + begin, many.begin(), many.end());
}

void change_byte(Pieces& pieces, RandomNumbers& random) {
    std::string& piece = pieces[random.below(pieces.size())];
    if (piece.empty()) return;
    piece[random.below(piece.size())] = static_cast<char>(random.bits() & 0xFFU);
}

/// The text without the escapes of libFuzzer's dictionaries: \\ and \" and \xNN.
std::string unescaped(std::string_view text) {
    std::string word;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\' && text.substr(i + 1).starts_with('x') && i + 3 < text.size()) {
            word += static_cast<char>(std::stoi(std::string(text.substr(i + 2, 2)), nullptr, 16));
            i += 3;
            continue;
        }
        if (text[i] == '\\' && i + 1 < text.size()) ++i;
        word += text[i];
    }
    return word;
}

}  // namespace

std::vector<std::string> pieces_of(std::string_view text) {
    std::vector<std::string> pieces;
    Kind last = Kind::Other;
    for (const char c : text) {
        const Kind kind = kind_of(c);
        const bool joins = (kind != Kind::Other && kind != Kind::Beyond && kind == last) ||
                           (kind == Kind::Beyond && is_continuation(c) && last == Kind::Beyond);
        if (pieces.empty() || !joins) pieces.emplace_back();
        pieces.back() += c;
        last = kind;
    }
    return pieces;
}

std::vector<std::string> read_dictionary(std::string_view file) {
    std::vector<std::string> words;
    while (!file.empty()) {
        const std::string_view line = file.substr(0, file.find('\n'));
        file.remove_prefix(std::min(line.size() + 1, file.size()));
        const std::size_t first = line.find('"');
        const std::size_t last = line.rfind('"');
        if (line.starts_with('#') || first == last) continue;
        words.push_back(unescaped(line.substr(first + 1, last - first - 1)));
    }
    return words;
}

Mutator::Mutator(std::vector<std::string> texts, std::vector<std::string> words)
    : texts_(std::move(texts)), given_(texts_.size()), words_(std::move(words)) {}

std::string Mutator::next(RandomNumbers& random) const {
    Pieces pieces = some_pieces(random);
    for (std::size_t left = 1 + random.below(6); left > 0; --left)
        mutate(pieces, random);
    return joined(pieces);
}

void Mutator::keep(std::string text, RandomNumbers& random) {
    if (text.size() > longest_kept) return;
    if (texts_.size() < given_ + most_kept) {
        texts_.push_back(std::move(text));
    } else {
        texts_[given_ + random.below(most_kept)] = std::move(text);
    }
}

std::vector<std::string> Mutator::some_pieces(RandomNumbers& random) const {
    return pieces_of(texts_[random.below(texts_.size())]);
}

void Mutator::mutate(Pieces& pieces, RandomNumbers& random) const {
    if (pieces.empty()) pieces = some_pieces(random);
    if (pieces.empty()) return;
    const std::string& word = words_[random.below(words_.size())];
    switch (random.below(10)) {
        case 0: return insert(pieces, random, {word});
        case 1: pieces[random.below(pieces.size())] = word; return;
        case 2: return remove_some(pieces, random);
        case 3: return swap_some(pieces, random);
        case 4: return put_in_brackets(pieces, random);
        case 5: return repeat_some(pieces, random);
        case 6:
            return random.one_in(4) ? change_byte(pieces, random) : insert(pieces, random, {word});
        default: {
            const Pieces other = some_pieces(random);
            const auto [begin, end] = stretch(random, other.size());
            return insert(pieces, random, {other.begin() + begin, other.begin() + end});
        }
    }
}

}  // namespace zeroset::test
