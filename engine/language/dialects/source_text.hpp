#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// A text put together of parts of a typed one and of words between them, which knows where in the
/// typed text each of its bytes comes from. The typed text must outlive it.
class SourceText {
public:
    explicit SourceText(std::string_view typed) : typed_(typed) {}

    /// Adds a part of the typed text, of which it is a view.
    void keep(std::string_view part);
    /// Adds words in place of what is typed at `offset`.
    void put(std::string_view words, std::size_t offset);

    /// Takes back what was added since the words had this size.
    void cut_back(std::size_t size);

    [[nodiscard]] std::string_view typed() const { return typed_; }
    [[nodiscard]] const std::string& words() const { return words_; }
    /// Whether a text is a view of the typed one.
    [[nodiscard]] bool is_part(std::string_view part) const {
        return !std::less<>()(part.data(), typed_.data()) &&
               !std::less<>()(typed_.data() + typed_.size(), part.data() + part.size());
    }
    /// The offset of a view of the typed text.
    [[nodiscard]] std::size_t offset_of(std::string_view part) const {
        return static_cast<std::size_t>(part.data() - typed_.data());
    }
    /// Whether the words are other ones than the typed text.
    [[nodiscard]] bool is_changed() const { return words_ != typed_; }
    /// Where the byte at `place` of the words was typed, or what it stands for.
    [[nodiscard]] std::size_t typed_offset(std::size_t place) const;
    /// The first place of the words that comes from the typed text at `offset` or behind it.
    [[nodiscard]] std::size_t place_of(std::size_t offset) const;

private:
    /// From `begin` on the words come from `typed` on, or all stand for it.
    struct Piece {
        std::size_t begin, typed;
        bool is_kept;
    };

    std::string_view typed_;
    std::string words_;
    std::vector<Piece> pieces_;
};

}  // namespace zeroset
