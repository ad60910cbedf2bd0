#!/usr/bin/env bash
# Builds Zeroset when needed and starts it: ./run.sh [ARGS of zeroset]
# Without a display and without ARGS it renders the gallery's first surface to ./zeroset.png.
set -euo pipefail
# shellcheck source=scripts/build.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/scripts/build.sh"

install_packages run
configure_and_build release zeroset
zeroset=$build/zeroset

if (($#)) || [[ -n ${DISPLAY:-}${WAYLAND_DISPLAY:-} ]]; then
    exec "$zeroset" "$@"
fi

names=$("$zeroset" gallery --names)
"$zeroset" render "@${names%%$'\n'*}" -o zeroset.png
printf 'no display here; the picture is %s\n' "$(realpath zeroset.png)"
