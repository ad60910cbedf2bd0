#pragma once

#include "pipeline/mesh_document.hpp"

#include <string>

// The texts that `mesh` prints about what it made.

namespace zeroset {

/// Some lines on the file and each of its surfaces.
std::string mesh_text(const std::string& output, const DocumentMeshes& meshes);

/// A line for each surface of which something is not proved or not as asked for.
std::string mesh_warnings(const DocumentMeshes& meshes, double budget_s);

/// All of it as JSON.
std::string mesh_stats(const DocumentMeshes& meshes, double elapsed_ms);

}  // namespace zeroset
