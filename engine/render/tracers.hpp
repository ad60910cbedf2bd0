#pragma once

#include "engine/trace/tracer.hpp"

#include <span>
#include <string_view>

namespace zeroset {

/// All tracers, the usual one first. Any thread, but not while tracers are added.
std::span<const Tracer> tracers();
/// nullptr when there is no such tracer.
const Tracer* find_tracer(std::string_view name);
/// The tracer that draws unless another is asked for.
const Tracer& usual_tracer();

/// Adds tracers behind those that are there. By a program's main function, before anyone asks for
/// a tracer: what the functions above have returned is lost.
void add_tracers(std::span<const Tracer> more);

}  // namespace zeroset
