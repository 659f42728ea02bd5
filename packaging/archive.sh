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

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/$name/man" "$folder/$name/completions" "$out"
cp "$binary" README.md LICENSE-MIT LICENSE-APACHE CHANGELOG.md "$folder/$name"
"$binary" man >"$folder/$name/man/mhlint.1"
for command in check eval explain rules schema; do "$binary" man "$command" >"$folder/$name/man/mhlint-$command.1"; done
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
