#!/usr/bin/env bash
# All checks that take too long for each change: scripts/nightly.sh [--again] [STEP...]
# Without steps it runs all of them, one after the other. What has passed for this commit is not run
# again, so that a run that was stopped goes on where it was; --again forgets that. The report is
# printed at the end, and stands in build/nightly/report.txt; each step has a log beside it.
set -euo pipefail
# shellcheck source=scripts/build.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/build.sh"
cd -- "$root"

# shellcheck source=scripts/nightly_steps.sh
source scripts/nightly_steps.sh

again=0
[[ ${1-} == --again ]] && { again=1; shift; }
mkdir -p build/nightly
commit=$(git rev-parse HEAD)
git diff --quiet HEAD || commit+=-changed
passed=build/nightly/passed
# What passed for another commit says nothing of this one.
[[ $again == 0 && $(head -n 1 "$passed" 2>/dev/null) == "$commit" ]] || printf '%s\n' "$commit" >"$passed"
install_packages run test lint nightly

report=build/nightly/report.txt
printf 'commit %s\n' "$commit" >"$report"
failures=0
for entry in "${steps[@]}"; do
    read -r step what <<<"$entry"
    (($# == 0)) || [[ " $* " == *" $step "* ]] || continue
    if grep -qx "$step .*" "$passed"; then
        printf '%-11s passed before: %s\n' "$step" "$what" >>"$report"
        continue
    fi
    say "$step: $what"
    start=$SECONDS
    log=build/nightly/$step.log
    # A shell of its own, as bash does not end at an error within a condition.
    # shellcheck disable=SC2016  # that shell expands $1
    if bash -euo pipefail -c 'source scripts/build.sh; source scripts/nightly_steps.sh; "step_$1"' \
        nightly "$step" >"$log" 2>&1 </dev/null; then
        printf '%s %s\n' "$step" "$((SECONDS - start))" >>"$passed"
        printf '%-11s passed in %s s: %s\n' "$step" "$((SECONDS - start))" "$what" >>"$report"
    else
        failures=$((failures + 1))
        printf '%-11s FAILED after %s s, see %s: %s\n' "$step" "$((SECONDS - start))" "$log" "$what" \
            >>"$report"
    fi
done
cat -- "$report"
((failures == 0))
