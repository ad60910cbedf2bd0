#pragma once

#include "engine/measure/probe.hpp"
#include "pipeline/mesh_document.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace zeroset {

// Texts about results: those that `mesh` prints about what it made, and `render --probe` about a
// pixel.

/// Some lines on the file and each of its surfaces.
std::string mesh_text(const std::string& output, const DocumentMeshes& meshes);

/// A line for each surface of which something is not proved or not as asked for.
std::string mesh_warnings(const DocumentMeshes& meshes, double budget_s);

/// All of it as JSON.
std::string mesh_stats(const DocumentMeshes& meshes, double elapsed_ms);

/// The line of JSON that `render --probe` prints for a pixel. `surface`: number of the hit surface
/// in the text, from 1; `reading`: how that surface was read.
std::string json_line(int col, int row, const std::optional<PointFacts>& facts, std::size_t surface,
                      const std::string& reading);

}  // namespace zeroset
