#define CALLER call_512
#define BYTES 64
#include "tests/support/call_lanes.inc"
