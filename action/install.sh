#!/usr/bin/env bash
# Downloads the archive of a release for this runner, checks it against the SHA256SUMS of the release and puts `mhlint` on PATH.
#
# MHLINT_VERSION   version to install; empty: the one of this action
# MHLINT_RELEASES  address below which each tag has a folder of archives
# RUNNER_OS, RUNNER_ARCH, RUNNER_TEMP, GITHUB_PATH  as GitHub sets them
set -euo pipefail

fail() { # GitHub shows the line at the top of the run
    echo "::error title=mhlint::$*"
    exit 2
}

# Linux gets the static binary: it runs whatever C library the runner or container has.
archive_suffix() {
    case "$RUNNER_OS-$RUNNER_ARCH" in
    Linux-X64) echo x86_64-unknown-linux-musl.tar.gz ;;
    Linux-ARM64) echo aarch64-unknown-linux-musl.tar.gz ;;
    macOS-X64) echo x86_64-apple-darwin.tar.gz ;;
    macOS-ARM64) echo aarch64-apple-darwin.tar.gz ;;
    Windows-X64) echo x86_64-pc-windows-msvc.zip ;;
    *) fail "no archive is built for $RUNNER_OS on $RUNNER_ARCH; install mhlint with cargo and run it without this action" ;;
    esac
}

# From standard input: of a file whose path has a backslash (RUNNER_TEMP of Windows) sha256sum writes `\` before the sum.
sha256() {
    if command -v sha256sum >/dev/null; then sha256sum; else shasum -a 256; fi <"$1" | cut -d' ' -f1
}

download() { # name
    curl --fail --silent --show-error --location --retry 3 --output "$folder/$1" "$MHLINT_RELEASES/v$version/$1" ||
        fail "cannot download $1 of version $version from $MHLINT_RELEASES"
}

version=${MHLINT_VERSION#v}
if [ -z "$version" ]; then
    version=$(sed -n 's/^version = "\(.*\)"/\1/p' "$(dirname "$0")/../Cargo.toml" | head -n 1)
fi
suffix=$(archive_suffix) || { echo "$suffix" && exit 2; }
archive=mhlint-$version-$suffix
folder=$RUNNER_TEMP/mhlint-$version
mkdir -p "$folder"

download "$archive"
download SHA256SUMS
wanted=$(tr -d '\r' <"$folder/SHA256SUMS" | awk -v name="$archive" '$2 == name || $2 == "*" name { print $1 }')
[ -n "$wanted" ] || fail "SHA256SUMS of version $version does not name $archive"
found=$(sha256 "$folder/$archive")
[ "$found" = "$wanted" ] || fail "$archive is not what the release lists: SHA-256 $found instead of $wanted"

case $archive in
*.zip) unzip -oq "$folder/$archive" -d "$folder" ;;
*) tar -xzf "$folder/$archive" -C "$folder" ;;
esac
binaries=$folder/${archive%.*}
binaries=${binaries%.tar}
echo "$binaries" >>"$GITHUB_PATH"
"$binaries/mhlint" --version
