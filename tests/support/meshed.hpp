#pragma once

#include "pipeline/mesh_document.hpp"
#include "pipeline/prepare.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>

namespace zeroset::test {

/// The meshes of a text's surfaces in the box [-half, half]^3; `change` may change the document.
inline DocumentMeshes meshed(const std::string& text, double half, const MeshSettings& settings,
                             const std::function<void(Document&)>& change = {}) {
    ReadDocument read = read_document_text(text);
    if (!read.rows) {
        ADD_FAILURE() << text << ": " << read.rows.error().reason;
        return {};
    }
    read.document.clip = Box::cube(half);
    if (change) change(read.document);
    const auto prepared = prepare(read.document, *read.rows, Preparation::Interpreted);
    if (!prepared) {
        ADD_FAILURE() << text << ": " << prepared.error().reason;
        return {};
    }
    auto meshes = mesh_document(
        picture_request(prepared->formula, prepared->colors, read.document, {}, {64, 64}),
        settings);
    if (meshes) return std::move(*meshes);
    ADD_FAILURE() << text << ": " << meshes.error().reason;
    return {};
}

}  // namespace zeroset::test
