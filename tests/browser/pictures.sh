#!/usr/bin/env bash
# Takes the pictures of HTML reports in docs/pictures, with the text that they show beside them.
#
#   tests/browser/pictures.sh
#
# tests/all/pictures.rs writes the pages and compares their text with that of the pictures. Needs Chromium, npm, and network
# the first time.
set -euo pipefail
cd "$(dirname "$0")/../.."

work=target/browser
pages=$PWD/$work/pages
mkdir -p "$work"
cp tests/browser/package.json "$work/"
[ -d "$work/node_modules/playwright-core" ] || (cd "$work" && npm install --no-audit --no-fund --silent)
rm -rf "$pages"
PAGES=$pages cargo test --quiet --test all pictures::pictures_of_pages
NODE_PATH=$work/node_modules node tests/browser/pictures.cjs "$pages" "$pages"/*.html
# Text and picture go together: a new text beside an old picture would call it fresh.
mv "$pages"/*.png "$pages"/*.txt docs/pictures/
ls -l docs/pictures/*.png
