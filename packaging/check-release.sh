#!/usr/bin/env bash
# What a release must agree on: tag, versions of crate and mirror, changelog, and the address that `cargo binstall` uses.
set -euo pipefail
cd "$(dirname "$0")/.."

faults=0
fault() {
    echo "::error title=release::$*"
    faults=1
}

version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
if [ "${GITHUB_REF_TYPE:-}" = tag ] && [ "$GITHUB_REF_NAME" != "v$version" ]; then
    fault "the tag is $GITHUB_REF_NAME, Cargo.toml says $version"
fi
grep -q "^## $version (20" CHANGELOG.md || fault "CHANGELOG.md has no section '## $version (date)'"
grep -q "mhlint==$version\"" packaging/pre-commit-mirror/pyproject.toml || fault "the template of the mirror pins another version"
if [ -n "${GITHUB_REPOSITORY:-}" ]; then
    address=$GITHUB_SERVER_URL/$GITHUB_REPOSITORY
    grep -qF "repository = \"$address\"" Cargo.toml || fault "repository in Cargo.toml is not $address"
fi
if grep -rlw OWNER README.md docs packaging/pre-commit-mirror; then fault "OWNER still stands in the files above"; fi
exit $faults
