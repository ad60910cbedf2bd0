#include "engine/language/vocabulary/parse_notes.hpp"

#include <algorithm>
#include <utility>

namespace zeroset {
namespace {

constexpr std::size_t most_notes = 100'000;       // in one text
constexpr std::size_t most_notes_of_reading = 8;  // in one reading, without repetitions

}  // namespace

void Notes::add(std::size_t offset, std::string text) {
    if (notes_.size() < most_notes) notes_.push_back({.offset = offset, .text = std::move(text)});
}

void Notes::add(const Notes& others) {
    for (const Note& note : others.notes_)
        add(note.offset, note.text);
}

void Notes::move_offsets(const std::function<std::size_t(std::size_t)>& place) {
    for (Note& note : notes_)
        note.offset = place(note.offset);
}

void Notes::hand_over(std::vector<Reading>& readings) {
    if (readings.empty()) return;
    std::ranges::stable_sort(notes_, {}, &Note::offset);
    for (Note& note : notes_) {
        const auto next = std::ranges::upper_bound(readings, note.offset, {}, &Reading::offset);
        Reading& reading = next == readings.begin() ? *next : *std::prev(next);
        const bool known = std::ranges::find(reading.notes, note.text) != reading.notes.end();
        if (known || reading.notes.size() == most_notes_of_reading) continue;
        reading.notes.push_back(std::move(note.text));
    }
    notes_.clear();
}

}  // namespace zeroset
