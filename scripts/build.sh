# shellcheck shell=bash
# Functions that run.sh, test.sh and .ci/run share: packages and the build. Sourced under
# set -euo pipefail. Everything goes to stderr, so that stdout belongs to the program.

root=$(realpath -- "$(dirname -- "${BASH_SOURCE[0]}")/..")
build=$root/build/release  # of both: the tests use the libraries that the program is made of

say() { printf 'zeroset: %s\n' "$*" >&2; }

die() {
    say "$*"
    exit 1
}

# Prints the packages in the named sections of packages.txt.
packages_of() {
    awk -v wanted=" $* " '
        { sub(/#.*/, ""); sub(/^[ \t]+/, ""); sub(/[ \t\r]+$/, "") }
        /^\[.*\]$/ { inside = index(wanted, " " substr($0, 2, length($0) - 2) " "); next }
        inside && $0 != ""' "$root/packages.txt"
}

# Prints the packages of the named sections that are neither installed nor provided by an installed
# package. Packages of a foreign architecture do not count.
missing_packages() {
    # shellcheck disable=SC2016  # the fields are dpkg-query's, not the shell's
    dpkg-query -W -f='${db:Status-Status}|${Architecture}|${Package}|${Provides}\n' |
        awk -F'|' -v native="$(dpkg --print-architecture)" '
            FNR == NR {
                if ($1 !~ /^(installed|triggers-)/ || ($2 != native && $2 != "all")) next
                there[$3]
                gsub(/\([^)]*\)|[ \t]/, "", $4)
                count = split($4, provided, ",")
                for (i = 1; i <= count; i++) there[provided[i]]
                next
            }
            !($0 in there)' - <(packages_of "$@")
}

# Runs a command without input; its output goes to a log, which is shown only if the command fails.
quietly() {
    local log=$1
    shift
    mkdir -p -- "$(dirname -- "$log")"
    "$@" >"$log" 2>&1 </dev/null && return
    cat -- "$log" >&2
    return 1
}

# Installs the missing packages of the named sections; asks nothing, removes nothing.
install_packages() {
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "not a Debian system: building with what is installed (packages.txt lists what is needed)"
        return
    fi
    local missing as_root=()
    mapfile -t missing < <(missing_packages "$@")
    ((${#missing[@]})) || return 0
    if ((EUID != 0)); then
        command -v sudo >/dev/null ||
            die "as root, please run: apt-get install --no-install-recommends ${missing[*]}"
        as_root=(sudo)
    fi
    say "installing ${missing[*]}"
    local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300)
    # A failing package source is no error yet: the install below fails if it was needed.
    quietly "$root/build/apt-update.log" "${apt[@]}" update || true
    quietly "$root/build/apt-install.log" \
        "${apt[@]}" install -y --no-install-recommends --no-remove "${missing[@]}" ||
        die "could not install ${missing[*]}"
}

# Configures the build directory for a preset, release or test, if it is new, was copied from
# elsewhere, had other presets or lacks the tests that the preset asks for.
configure() {
    local preset=$1 cache=$build/CMakeCache.txt fresh=()
    # --fresh discards the cache of another source directory, which cmake would refuse.
    grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache" || fresh=(--fresh)
    if ((${#fresh[@]} == 0)) && [[ -f $build/build.ninja ]] &&
        cmp -s "$root/CMakePresets.json" "$build/configured_presets.json" &&
        { [[ $preset == release ]] || grep -qsxF "ZEROSET_TESTS:BOOL=ON" "$cache"; }; then
        return
    fi
    say "configuring"
    (cd -- "$root" && quietly "$build/configure.log" cmake "${fresh[@]}" --preset "$preset") ||
        die "cmake failed; its output is above and in $build/configure.log"
    cp -- "$root/CMakePresets.json" "$build/configured_presets.json"
}

# Reports every half minute the progress of a build whose output goes to a log, and the time left if
# the steps to come take as long as those before.
tell_progress() {
    local log=$1 step built total left start=$SECONDS
    # sleep does not inherit this script's output, so that a reader of that does not wait for sleep.
    while sleep 30 >/dev/null 2>&1; do
        step=$(grep -o '^\[[0-9]*/[0-9]*\]' "$log" | tail -n 1 || true)
        [[ $step =~ ^.([0-9]+)/([0-9]+) ]] || continue
        built=${BASH_REMATCH[1]} total=${BASH_REMATCH[2]}
        ((built > 0)) || continue
        left=$(((SECONDS - start) * (total - built) / built))
        if ((left < 60)); then
            say "built $built of $total steps, less than a minute left"
        else
            say "built $built of $total steps, about $(((left + 30) / 60)) min left"
        fi
    done
}

# Runs ninja with its output in a log; if it fails, shows what failed, without the progress lines.
build_telling_progress() {
    local log=$1 teller result=0
    shift
    : >"$log"
    tell_progress "$log" &
    teller=$!
    NINJA_STATUS='[%f/%t] ' "$@" >"$log" 2>&1 </dev/null || result=$?
    kill "$teller" 2>/dev/null || true
    wait "$teller" 2>/dev/null || true
    ((result == 0)) || sed -n '/^\[[0-9]*\/[0-9]*\]/d; /^\(FAILED\|ninja\): /,$p' "$log" >&2
    return "$result"
}

# Builds a target of a preset on all cores; silent if there is nothing to do.
configure_and_build() {
    local preset=$1 target=$2
    configure "$preset"
    local ninja=(ninja -C "$build")
    # The first call updates build.ninja. The dry run names it by an absolute path, which is not a
    # target of ninja: else the dry run would stop at its update, which never counts as done there.
    quietly "$build/build.log" "${ninja[@]}" --quiet build.ninja ||
        die "cmake failed; its output is above and in $build/build.log"
    [[ $("${ninja[@]}" -f "$build/build.ninja" -n "$target") == *"no work to do"* ]] && return
    say "building; the time left is told every half minute"
    build_telling_progress "$build/build.log" "${ninja[@]}" "$target" ||
        die "the build failed; its output is above and in $build/build.log"
}
