#!/usr/bin/env bash
# Checks, shows the findings in the log and as annotations, writes SARIF and the summary, and sets the exit code as an output:
# the verdict is a later step of action.yml, so that SARIF is uploaded before it.
#
# MHLINT_PATHS, MHLINT_ARGS  separated by spaces or line ends
# MHLINT_BASE  commit that a pull request is to be merged into; empty elsewhere: only what is new since then is reported
# RUNNER_TEMP, GITHUB_OUTPUT, GITHUB_STEP_SUMMARY  as GitHub sets them
set -euo pipefail

# Spaces and line ends separate, but nothing is expanded: `--skip macro-*` reaches mhlint as it is.
read -r -d '' -a paths <<<"${MHLINT_PATHS:-.}" || true # no delimiter comes: all is read
read -r -d '' -a args <<<"${MHLINT_ARGS:-}" || true
since=()
if [ -n "${MHLINT_BASE:-}" ] && [[ ! " ${args[*]-} " =~ \ --(since|staged|against|write-baseline) ]]; then
    if git cat-file -e "$MHLINT_BASE^{commit}" 2>/dev/null; then
        since=(--since "$MHLINT_BASE")
    else
        echo "::notice::mhlint: the base of the pull request was not fetched (fetch-depth: 0); reporting all findings"
    fi
fi
human=$RUNNER_TEMP/mhlint.txt
sarif=$RUNNER_TEMP/mhlint.sarif
rm -f "$human" "$sarif"

code=0
mhlint check "${paths[@]}" ${since[@]+"${since[@]}"} ${args[@]+"${args[@]}"} \
    --report github --report "human=$human" --report "sarif=$sarif" || code=$?

if [ -f "$human" ]; then
    echo "::group::mhlint"
    # Names of assets come from strangers: none of them may speak to the runner.
    stop=mhlint-$RANDOM$RANDOM
    echo "::stop-commands::$stop"
    cat "$human"
    echo "::$stop::"
    echo "::endgroup::"
fi
echo "exit-code=$code" >>"$GITHUB_OUTPUT"
if [ -f "$sarif" ]; then echo "sarif=$sarif" >>"$GITHUB_OUTPUT"; fi
