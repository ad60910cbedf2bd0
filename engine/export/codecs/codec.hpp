#pragma once

#include <string>

namespace zeroset {

/// Why an encoder cannot be used ("this Zeroset was built without FFmpeg"); empty where it can.
/// `name`: FFmpeg's. Loads FFmpeg's libraries, so it is asked only where something is written by
/// them, or told of what can be written.
std::string missing_encoder(const char* name);

}  // namespace zeroset
