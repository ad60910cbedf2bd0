#include "engine/language/dialects/source_text.hpp"

#include <algorithm>

namespace zeroset {

void SourceText::keep(std::string_view part) {
    if (part.empty()) return;
    pieces_.push_back({.begin = words_.size(), .typed = offset_of(part), .is_kept = true});
    words_ += part;
}

void SourceText::put(std::string_view words, std::size_t offset) {
    if (words.empty()) return;
    pieces_.push_back({.begin = words_.size(), .typed = offset, .is_kept = false});
    words_ += words;
}

void SourceText::cut_back(std::size_t size) {
    words_.resize(size);
    while (!pieces_.empty() && pieces_.back().begin >= size)
        pieces_.pop_back();
}

std::size_t SourceText::typed_offset(std::size_t place) const {
    const auto behind = std::ranges::upper_bound(pieces_, place, {}, &Piece::begin);
    if (behind == pieces_.begin()) return place;
    const Piece& piece = *std::prev(behind);
    return std::min(typed_.size(), piece.typed + (piece.is_kept ? place - piece.begin : 0));
}

std::size_t SourceText::place_of(std::size_t offset) const {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const Piece& piece = pieces_[i];
        const std::size_t end = i + 1 < pieces_.size() ? pieces_[i + 1].begin : words_.size();
        const std::size_t length = piece.is_kept ? end - piece.begin : 1;
        if (piece.typed + length > offset)
            return piece.begin + (offset > piece.typed ? offset - piece.typed : 0);
    }
    return words_.size();
}

}  // namespace zeroset
