#!/usr/bin/env bash
# Checks how the code is written: clang-format, shellcheck, pyflakes; clang-tidy over the sources of
# the program that were changed last, up to 12; and whether as many tests and headers include what they
# use. (The nightly script reads all, for which scripts/tidy.sh takes a quarter of an hour.) Prints
# what they find; exits 1 if they find anything. packages.txt lists them under [lint].
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

most=12  # of each kind

# Prints the files of such patterns that the last 20 commits changed, those of the newest first.
changed() {
    local file
    git log -20 --format= --name-only -- "$@" | awk '!seen[$0]++' | while IFS= read -r file; do
        [[ ! -e $file ]] || printf '%s\n' "$file"
    done
}
# Prints the tests and headers that changed, without headers whose source of the same name did: that
# begins with them. Headers that end in -inl are included after others on purpose; those of jit/llvm
# are read with its sources, which alone know where LLVM's headers are.
changed_without_tidy() {
    local file sources
    sources=$(changed '*.cpp')
    changed 'tests/*.cpp' '*.hpp' ':!*-inl.hpp' ':!jit/llvm' | while IFS= read -r file; do
        [[ $file == *.hpp ]] && grep -qxF "${file%.hpp}.cpp" <<<"$sources" || printf '%s\n' "$file"
    done
}

# In a shallow clone the commits to compare with are fetched; without them all files count as new.
if [[ $(git rev-parse --is-shallow-repository) == true ]]; then
    git fetch --quiet --deepen=20 || true
fi
result=0
git ls-files -z '*.cpp' '*.hpp' |
    xargs -0 -n 200 -P "$(nproc)" clang-format-19 --dry-run --Werror || result=1
git grep -lzE '^(#!.*[/ ](ba)?sh$|# shellcheck shell=)' | xargs -0 shellcheck || result=1
git ls-files -z '*.py' | xargs -0 pyflakes3 || result=1
mapfile -t sources < <(changed '*.cpp' ':!tests')
((${#sources[@]} == 0)) || scripts/tidy.sh "${sources[@]:0:most}" || result=1
mapfile -t alone < <(changed_without_tidy)
((${#alone[@]} == 0)) || scripts/tidy.sh --alone "${alone[@]:0:most}" || result=1
exit "$result"
