#pragma once

#include "engine/base/file_stamp.hpp"

#include <memory>
#include <vector>

// The files that formulas have been read from, which other programs may change meanwhile.
// Thread-safe.

namespace zeroset {

/// Says from which files something has been read, as they were then; they are looked at while it
/// lives.
void note_read_files(const std::shared_ptr<const void>& what, std::vector<FileStamp> files);

/// Looks at all these files. True if those of something have changed since it was read and all are
/// as they were at the last call, so that no one is still writing them; of each change once.
bool read_files_have_changed();

}  // namespace zeroset
