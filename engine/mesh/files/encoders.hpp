#pragma once

#include "engine/mesh/files/mesh_file.hpp"

// The writers behind mesh_formats(). In round-to-nearest.

namespace zeroset {

using EncodedMesh = std::expected<std::vector<std::byte>, std::string>;

/// Binary, little endian, millimetres: triangles with normals, no colours, all objects in one.
EncodedMesh encode_stl(const MeshFile& file);
/// Binary, little endian, millimetres: normals, colours, `quality` is the vertex's error.
EncodedMesh encode_ply(const MeshFile& file);
/// Text, millimetres: an `o` for each object, a normal for each corner of a triangle.
EncodedMesh encode_obj(const MeshFile& file);
/// A package of XML, millimetres: an object for each surface, colours by the materials extension.
EncodedMesh encode_3mf(const MeshFile& file);
/// glTF 2.0 in one binary file: metres, y up; a mesh for each object. Vertices of edges are there
/// once for each triangle, so that the edges look sharp.
EncodedMesh encode_glb(const MeshFile& file);

}  // namespace zeroset
