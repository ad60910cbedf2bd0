#pragma once

#include "engine/special/pieces.hpp"

namespace zeroset {

/// The piece of f over [from, from + width].
Piece make_piece(const Analytic& f, double from, double width);

/// A part of a piece in which a derivative may turn, and bounds of it there; outside of such parts
/// it is monotone.
struct PieceTurn {
    double from, to;
    ValueBounds bounds;
};
/// Adds the turns of a derivative in a piece behind those that end where it begins.
void add_turns(const Piece& piece, int order, std::vector<PieceTurn>& turns);

}  // namespace zeroset
