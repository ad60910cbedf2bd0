#define CALLER call_128
#define BYTES 16
#include "tests/support/call_lanes.inc"
