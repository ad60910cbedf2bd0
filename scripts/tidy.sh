#!/usr/bin/env bash
# Runs clang-tidy on all cores over the sources that the last build compiled:
# scripts/tidy.sh [PATH-PREFIX...], e.g. scripts/tidy.sh jit engine/trace, or scripts/tidy.sh tests.
# Without a prefix it reads all but tests/; headers are read with the sources that include them.
# Prints findings and a last line; exits 1 if there are findings.
set -euo pipefail
# shellcheck source=scripts/build.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/build.sh"

command -v clang-tidy-22 >/dev/null ||
    die "clang-tidy-22 is missing; please run: apt-get install clang-tidy-22"
[[ -f $build/compile_commands.json ]] || die "there is no build yet; ./test.sh makes one"

# The commands of the build, with one for each source.
export commands=$build/tidy
mkdir -p -- "$commands"
(cd -- "$root" && python3 scripts/compile_commands.py) >"$commands/all.json"

# Prints the compiled sources that begin with a prefix, one a line, without generated ones.
sources() {
    awk -F'"' -v root="$root/" -v wanted="$*" '
        BEGIN { count = split(wanted, prefixes, " ") }
        $2 != "file" || index($4, root) != 1 { next }
        { file = substr($4, length(root) + 1) }
        file ~ /^build\// { next }
        !count && file !~ /^tests\// { print file }
        { for (i = 1; i <= count; i++) if (index(file, prefixes[i]) == 1) { print file; break } }
    ' "$commands/all.json" | sort -u
}

# Prints what clang-tidy finds in a file, nothing if all is well. An error that is not one of the
# code, such as an unknown option, is told on stderr only.
tidy() {
    local findings log
    log=$commands/${1//\//%}.log
    findings=$(clang-tidy-22 -p "$commands" --quiet "$1" 2>"$log") && return
    printf '%s\n' "${findings:-$(<"$log")}"
    return 1
}
export -f tidy

cd -- "$root"
mapfile -t files < <(sources "$@")
((${#files[@]})) || die "no source that was compiled begins with $*"

# One command for each source, though some are compiled for several programs, without options that
# only g++ knows, and without precompiled headers: each source must include what it uses.
awk -F'"' '
    /^[][]/ { next }
    /^\{/ { entry = ""; next }
    /^\}/ && file in seen { next }
    /^\}/ { seen[file]; printf "%s{\n%s}", count++ ? ",\n" : "[\n", entry; next }
    $2 == "file" { file = $4 }
    { sub(/ -mmemset-strategy=[^ ]*/, ""); sub(/ -include [^ ]*\/cmake_pch.hxx/, "") }
    { entry = entry $0 "\n" }
    END { print "\n]" }
' "$commands/all.json" >"$commands/compile_commands.json"

# shellcheck disable=SC2016  # the shell that xargs starts expands $1
if printf '%s\n' "${files[@]}" | xargs -d '\n' -n 1 -P "$(nproc)" bash -c 'tidy "$1"' tidy; then
    say "clang-tidy finds nothing; files read: ${#files[@]}"
else
    die "clang-tidy has findings, see above; files read: ${#files[@]}"
fi
