#!/usr/bin/env bash
# What cargo does not test: workflows, the action's scripts, the wheel, and the hook in a real git repository with pre-commit.
#
# The tools come from PyPI into target/packaging/venv. Without Python or PyPI the script says what it leaves out and ends well.
# Builds the wheel with the release profile in target/, or takes it from MHLINT_WHEEL.
set -euo pipefail
cd "$(dirname "$0")/../.."

project=$PWD
work=$project/target/packaging
venv=$work/venv
here=$project/tests/packaging
mkdir -p "$work"

# shellcheck source=tests/packaging/expect.sh
source "$here/expect.sh"

prepare() { # everything that is not on this machine, so that nothing after it needs the network
    if [ -f "$venv/ready" ] && cmp -s "$venv/ready" "$here/requirements.txt"; then return; fi
    rm -rf "$venv"
    python3 -m venv "$venv" &&
        "$venv/bin/pip" install --quiet --retries 1 -r "$here/requirements.txt" &&
        "$venv/bin/pip" download --quiet --no-deps --dest "$venv/wheels" setuptools &&
        cp "$here/requirements.txt" "$venv/ready"
}

for script in "$here"/*.sh "$project"/{action,packaging,packaging/pre-commit-mirror}/*.sh; do bash -n "$script"; done
if ! prepare >"$work/prepare.log" 2>&1; then
    tail -n 3 "$work/prepare.log"
    echo "left out, for want of Python's venv or of PyPI: workflows against their schemas, the wheel, the hook with pre-commit, the action"
    exit 0
fi
export PATH=$venv/bin:$PATH

# shellcheck source=tests/packaging/texts.sh
source "$here/texts.sh"
# shellcheck source=tests/packaging/wheel.sh
source "$here/wheel.sh"
# shellcheck source=tests/packaging/action.sh
source "$here/action.sh"
# shellcheck source=tests/packaging/hook.sh
source "$here/hook.sh"
verdict
