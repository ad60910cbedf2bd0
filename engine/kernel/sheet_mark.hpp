#pragma once

namespace zeroset {

/// Kept in Kernel::memory of a surface that has no inside, whatever the sign of f is beside it: a
/// part of a plane. Sections do not fill it.
struct SheetMark {};

}  // namespace zeroset
