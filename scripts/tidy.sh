#!/usr/bin/env bash
# Runs clang-tidy on all cores:
#   scripts/tidy.sh [PATH-PREFIX...]   over sources that begin so, e.g. jit engine/trace, or tests;
#                                      without a prefix over all but tests/
#   scripts/tidy.sh --alone FILE...    only reads files, headers and tests, too: finds what does not
#                                      include all that it uses, as the build reads several in one go
# Headers are read with the sources that include them. Prints findings and a last line; exits 1 if
# there are findings.
set -euo pipefail
# shellcheck source=scripts/build.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/build.sh"

command -v clang-tidy-22 >/dev/null ||
    die "clang-tidy-22 is missing; please run: apt-get install clang-tidy-22"

cd -- "$root"
# The commands that compile each source alone; one for each, though some are compiled for several
# programs, and with options that clang knows.
export commands=$root/build/tidy
quietly "$commands/configure.log" cmake --preset test -B "$commands" -D CMAKE_UNITY_BUILD=OFF ||
    die "cmake failed; its output is above"
awk -F'"' '
    /^[][]/ { next }
    /^\{/ { entry = ""; next }
    /^\}/ { if (!(file in seen)) printf "%s{\n%s}", count++ ? ",\n" : "[\n", entry; seen[file]; next }
    $2 == "file" { file = $4 }
    { sub(/ -mmemset-strategy=[^ ]*/, ""); sub(/ --param=[^ ]*/, ""); sub(/-Wshadow=local/, "-Wshadow") }
    { entry = entry $0 "\n" }
    END { print "\n]" }
' "$commands/compile_commands.json" >"$commands/once.json"
mv -- "$commands/once.json" "$commands/compile_commands.json"

# Prints the compiled sources that begin with a prefix, one a line, without generated ones.
sources() {
    awk -F'"' -v root="$root/" -v wanted="$*" '
        BEGIN { count = split(wanted, prefixes, " ") }
        $2 != "file" || index($4, root) != 1 { next }
        { file = substr($4, length(root) + 1) }
        file ~ /^build\// { next }
        !count && file !~ /^tests\// { print file }
        { for (i = 1; i <= count; i++) if (index(file, prefixes[i]) == 1) { print file; break } }
    ' "$commands/compile_commands.json"
}

# Prints what clang-tidy finds in a file, nothing if all is well. An error that is not one of the
# code, such as an unknown option, is told on stderr only.
tidy() {
    local findings log
    log=$commands/${1//\//%}.log
    findings=$(clang-tidy-22 -p "$commands" --quiet "${@:2}" "$1" 2>"$log") && return
    printf '%s\n' "${findings:-$(<"$log")}"
    return 1
}
export -f tidy

checks=()
if [[ ${1-} == --alone ]]; then
    # One of the quickest checks, as there must be one; errors of the compiler are always told.
    checks=('--config={Checks: "-*,misc-static-assert"}')
    files=("${@:2}")
else
    mapfile -t files < <(sources "$@")
    ((${#files[@]})) || die "no source that is compiled begins with $*"
fi

# shellcheck disable=SC2016  # the shell that xargs starts expands $@; the file is its last argument
if printf '%s\n' "${files[@]}" | xargs -d '\n' -n 1 -P "$(nproc)" \
    bash -c 'tidy "${@: -1}" "${@:1:$# - 1}"' tidy "${checks[@]}"; then
    say "clang-tidy finds nothing; files read: ${#files[@]}"
else
    die "clang-tidy has findings, see above; files read: ${#files[@]}"
fi
