#!/usr/bin/env bash
# Builds one wheel of a release: packaging/wheel.sh TARGET FOLDER
# For Linux with an old C library (zig links against it), so that the wheel installs on every current distribution.
set -euo pipefail
cd "$(dirname "$0")/.."

target=${1:?TARGET is missing, x86_64-unknown-linux-gnu say}
out=${2:?FOLDER for the wheel is missing}
options=()
case $target in
*-linux-gnu) options=(--zig --compatibility manylinux2014) ;;
*-linux-musl) options=(--compatibility musllinux_1_2) ;;
esac
maturin build --release --locked --target "$target" --out "$out" ${options[@]+"${options[@]}"}
