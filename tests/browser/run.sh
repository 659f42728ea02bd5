#!/usr/bin/env bash
# The HTML report in a real browser, HTML and JUnit read by independent validators.
#
#   tests/browser/run.sh [FOLDER]     screenshots go to FOLDER (target/browser/shots)
#
# With MHLINT_DAMAGED=FOLDER it reads the reports of the damaged copies as well that `cargo test --release damage:: -- --ignored` wrote
# there under the same variable: all nine of each must tell the same findings.
#
# Prepares what it needs below target/browser: Chromium by apt where it is missing and we are root, drivers and
# validators from npm and PyPI. Skips with a line where that is not possible.
set -euo pipefail
cd "$(dirname "$0")/../.."

skip() {
    echo "skipped: the HTML report in a browser ($1)"
    exit 0
}

if ! command -v chromium >/dev/null; then
    [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null || skip "there is no chromium"
    apt-get update -qq
    DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends chromium >/dev/null
fi
command -v npm >/dev/null || skip "there is no npm"
command -v python3 >/dev/null || skip "there is no python3"

work=target/browser
shots=${1:-$work/shots}
mkdir -p "$work" "$shots"
cp tests/browser/package.json "$work/"
[ -d "$work/node_modules/axe-core" ] || (cd "$work" && npm install --no-audit --no-fund --silent)
[ -x "$work/venv/bin/python" ] || python3 -m venv "$work/venv"
"$work/venv/bin/python" -c 'import html5lib, jsonschema, junitparser' 2>/dev/null ||
    "$work/venv/bin/python" -m pip install --quiet html5lib==1.1 jsonschema==4.23.0 junitparser==5.0.3

# MHLINT names a binary that is built already.
[ -n "${MHLINT:-}" ] || cargo build --quiet
mhlint=$(realpath "${MHLINT:-target/debug/mhlint}")
python3 tests/browser/damage.py fixtures/makehuman2 "$work/damaged" "$work/hostile"
reports=(clean damaged hostile)
report() { # NAME FOLDER PATH: exit code 1 means findings, and that is what is wanted
    local name=$1 folder=$2 path=$3 code=0
    (cd "$folder" && "$mhlint" "$path" \
        --report "html=$OLDPWD/$work/$name.html" --report "junit=$OLDPWD/$work/$name.xml") || code=$?
    [ "$code" -le 1 ] || exit "$code"
}
report clean fixtures makehuman2
report damaged "$work/damaged" .
report hostile "$work/hostile" .
if [ -d "${MHLINT_CORPORA:-}/makehuman2" ]; then
    report corpus "$MHLINT_CORPORA/makehuman2" data
    reports+=(corpus)
else
    echo "skipped: the report of the corpus (MHLINT_CORPORA is not set)"
fi

for name in "${reports[@]}"; do
    "$work/venv/bin/python" tests/browser/validate.py "$work/$name.html" "$work/$name.xml"
    "$work/node_modules/.bin/html-validate" --config tests/browser/htmlvalidate.json "$work/$name.html"
done
NODE_PATH="$work/node_modules" node tests/browser/report.cjs "$work" "$shots" "${reports[@]}"

if [ -n "${MHLINT_DAMAGED:-}" ] && [ -d "$MHLINT_DAMAGED" ]; then
    "$work/venv/bin/python" tests/browser/copies.py tests/schemas/sarif-2.1.0.json "$MHLINT_DAMAGED"
    pages=("$MHLINT_DAMAGED"/*/report.html)
    "$work/node_modules/.bin/html-validate" --config tests/browser/htmlvalidate.json "${pages[@]}"
    NODE_PATH="$work/node_modules" node tests/browser/console.cjs "${pages[@]}"
else
    echo "skipped: the reports of the damaged copies (MHLINT_DAMAGED is not set)"
fi
