#pragma once

#include <string>

namespace zeroset {

/// A file in the folder that is not there yet: "NAME.png", else "NAME-2.png" and so on. `ending`
/// with its dot. Empty where all of very many names are taken.
std::string unused_file(const std::string& folder, const std::string& name,
                        const std::string& ending);

}  // namespace zeroset
