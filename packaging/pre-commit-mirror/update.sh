#!/usr/bin/env bash
# Pins another version of the wheel, commits and tags it. Run in the mirror repository once the wheel is published:
#     ./update.sh 0.2.0 && git push --follow-tags
set -euo pipefail
cd "$(dirname "$0")"

version=${1:?the version of the published wheel is missing, ./update.sh 0.2.0}
case $version in
*[!0-9a-z.]* | v*) echo "update.sh: \`$version\` is no version of a wheel; 0.2.0 is meant, without v" >&2 && exit 2 ;;
esac

pin() { # file, what stands before the version
    sed -i.old -E "s/($2)[0-9][0-9a-z.]*/\1$version/" "$1" && rm "$1.old"
    grep -qF "$version" "$1" || { echo "update.sh: no version to replace in $1" >&2 && exit 1; }
}
pin pyproject.toml 'mhlint=='
pin README.md 'rev: v'

git add -A
git commit --quiet --allow-empty --message "mhlint $version"
git tag --annotate --message "mhlint $version" "v$version"
