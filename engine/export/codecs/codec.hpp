#pragma once

#include <string>

namespace zeroset {

/// Why an encoder cannot be used ("this Zeroset was built without FFmpeg"); empty where it can.
/// `name`: FFmpeg's.
std::string missing_encoder(const char* name);

}  // namespace zeroset
