#define CALLER call_256
#define BYTES 32
#include "tests/support/call_lanes.inc"
