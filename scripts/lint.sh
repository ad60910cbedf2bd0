#!/usr/bin/env bash
# Checks how the code is written: clang-format, shellcheck, pyflakes, clang-tidy over
# those sources of the program that the last commits changed, and whether the tests and headers that
# these changed include what they use. (clang-tidy over all takes a quarter of an hour: scripts/tidy.sh,
# and scripts/tidy.sh tests.) Prints what they find; exits 1 if they find anything. packages.txt lists
# them under [lint].
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

# Prints the files of such patterns that the last 20 commits changed, all where fewer are known.
changed() {
    if git rev-parse --quiet --verify HEAD~20 >/dev/null; then
        git diff --name-only --diff-filter=d HEAD~20 -- "$@"
    else
        git ls-files -- "$@"
    fi
}
# Prints the tests that changed, and the headers that did so without the source of their name, which
# begins with them. Headers that end in -inl are included after others on purpose; those of jit/llvm
# are read with its sources, which alone know where LLVM's headers are.
changed_without_tidy() {
    changed 'tests/*.cpp'
    changed '*.hpp' ':!*-inl.hpp' ':!jit/llvm' | while IFS= read -r header; do
        [[ -n $(changed "${header%.hpp}.cpp") ]] || printf '%s\n' "$header"
    done
}

# In a shallow clone the commits to compare with are fetched; without them all files are read.
if [[ $(git rev-parse --is-shallow-repository) == true ]]; then
    git fetch --quiet --deepen=20 || true
fi
result=0
git ls-files -z '*.cpp' '*.hpp' | xargs -0 clang-format-19 --dry-run --Werror || result=1
git grep -lzE '^(#!.*[/ ](ba)?sh$|# shellcheck shell=)' | xargs -0 shellcheck || result=1
git ls-files -z '*.py' | xargs -0 pyflakes3 || result=1
mapfile -t sources < <(changed '*.cpp' ':!tests')
((${#sources[@]} == 0)) || scripts/tidy.sh "${sources[@]}" || result=1
mapfile -t alone < <(changed_without_tidy)
((${#alone[@]} == 0)) || scripts/tidy.sh --alone "${alone[@]}" || result=1
exit "$result"
