#!/usr/bin/env bash
# Checks how the code is written, after a build: clang-format, shellcheck, pyflakes, and clang-tidy
# over the program (over the tests it takes as long again: scripts/tidy.sh tests). Prints what they
# find; exits 1 if they find anything. packages.txt lists them under [lint].
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

result=0
git ls-files -z '*.cpp' '*.hpp' | xargs -0 clang-format-19 --dry-run --Werror || result=1
git grep -lzE '^(#!.*[/ ](ba)?sh$|# shellcheck shell=)' | xargs -0 shellcheck || result=1
git ls-files -z '*.py' | xargs -0 pyflakes3 || result=1
scripts/tidy.sh || result=1
exit "$result"
