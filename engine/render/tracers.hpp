#pragma once

#include "engine/trace/tracer.hpp"

#include <span>
#include <string_view>

namespace zeroset {

/// All tracers, the usual one first. A new one is a new row.
std::span<const Tracer> tracers();
/// nullptr when there is no such tracer.
const Tracer* find_tracer(std::string_view name);

}  // namespace zeroset
