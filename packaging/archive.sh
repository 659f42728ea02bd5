#!/usr/bin/env bash
# Packs one archive of a release: packaging/archive.sh TARGET FOLDER [BINARY]
# A folder mhlint-VERSION-TARGET with the binary, licences, man pages and completions; .zip for Windows, .tar.gz for the rest.
set -euo pipefail
cd "$(dirname "$0")/.."

target=${1:?TARGET is missing, x86_64-unknown-linux-musl say}
out=${2:?FOLDER for the archive is missing}
binary=${3:-target/$target/release/mhlint}
[ -f "$binary" ] || binary=$binary.exe
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
name=mhlint-$version-$target

pages() { # binary, name of the page, words of the command
    local binary=$1 page=$2 command
    shift 2
    "$binary" man "$@" >"$folder/$name/man/$page.1"
    # A page names those of its commands, with the dashes of roff.
    for command in $(sed -n 's/^mhlint.*\\-\([a-z]*\)(1)$/\1/p' "$folder/$name/man/$page.1"); do
        if [ "$command" != help ]; then pages "$binary" "$page-$command" "$@" "$command"; fi
    done
}

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/$name/man" "$folder/$name/completions" "$out"
cp "$binary" README.md LICENSE-MIT LICENSE-APACHE CHANGELOG.md "$folder/$name"
pages "$binary" mhlint
"$binary" completions bash >"$folder/$name/completions/mhlint.bash"
"$binary" completions zsh >"$folder/$name/completions/_mhlint"
"$binary" completions fish >"$folder/$name/completions/mhlint.fish"
"$binary" completions powershell >"$folder/$name/completions/_mhlint.ps1"

out=$(cd "$out" && pwd)
case $target in
*windows*) (cd "$folder" && 7z a -bso0 "$out/$name.zip" "$name") ;;
*) tar -czf "$out/$name.tar.gz" -C "$folder" "$name" ;;
esac
echo "$name"
