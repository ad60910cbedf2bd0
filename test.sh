#!/usr/bin/env bash
# Builds everything and runs all tests: ./test.sh [ARGS of ctest], e.g. ./test.sh -R engine/tape
set -euo pipefail
# shellcheck source=scripts/build.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/scripts/build.sh"

install_packages run test
configure_and_build test all
# Large blocks of memory in large pages: a tenth less to wait where windows are drawn.
export GLIBC_TUNABLES=glibc.malloc.hugetlb=1
exec ctest --test-dir "$build" --output-on-failure --no-tests=error -j "$(nproc)" "$@"
