#include "document/import/cannot_open.hpp"

#include "engine/base/translation.hpp"

namespace zeroset {

std::unexpected<std::string> cannot_open(const std::filesystem::path& path,
                                         const std::string& reason) {
    return std::unexpected(filled(tr("cannot open {0}: {1}"), {"'" + path.string() + "'", reason}));
}

}  // namespace zeroset
