# Sourced: the shell parts of action.yml, on a release made here and served from a folder.

action=$work/action
releases=$action/releases
rm -rf "$action"
mkdir -p "$releases/v$version" "$action/data"

run packaging/archive.sh x86_64-unknown-linux-musl "$releases/v$version" "$mhlint"
expect "an archive is packed" ended_with 0
archive=mhlint-$version-x86_64-unknown-linux-musl.tar.gz
sums=$releases/v$version/SHA256SUMS
(cd "$releases/v$version" && sha256sum -- *.tar.gz >SHA256SUMS)
run tar -tzf "$releases/v$version/$archive"
for file in mhlint man/mhlint.1 man/mhlint-check.1 man/mhlint-eval-mesh.1 completions/_mhlint completions/mhlint.bash LICENSE-MIT; do
    expect "the archive holds $file" says "mhlint-$version-x86_64-unknown-linux-musl/$file"
done

install() { # system, architecture, version
    rm -rf "$action/temp" "$action/path" && mkdir "$action/temp"
    run env RUNNER_OS="$1" RUNNER_ARCH="$2" RUNNER_TEMP="$action/temp" GITHUB_PATH="$action/path" \
        MHLINT_VERSION="$3" MHLINT_RELEASES="file://$releases" bash action/install.sh
}
for wanted in '' "$version" "v$version"; do
    install Linux X64 "$wanted"
    expect "version '$wanted' is installed" ended_with 0
    expect "and is on PATH" test -x "$(cat "$action/path")/mhlint"
done
while read -r system architecture name; do
    install "$system" "$architecture" 9.9.9
    expect "$system $architecture wants $name" says "cannot download mhlint-9.9.9-$name"
    expect "a missing archive ends the step" ended_with 2
done <<'END'
Linux X64 x86_64-unknown-linux-musl.tar.gz
Linux ARM64 aarch64-unknown-linux-musl.tar.gz
macOS X64 x86_64-apple-darwin.tar.gz
macOS ARM64 aarch64-apple-darwin.tar.gz
Windows X64 x86_64-pc-windows-msvc.zip
END
install Linux RISCV64 ''
expect "a runner without an archive is named" says "no archive is built for Linux on RISCV64"
expect "and the step ends" ended_with 2
cp "$sums" "$action/sums"
sed -i 's/^......../00000000/' "$sums"
install Linux X64 ''
expect "another archive than the release lists is rejected" says "is not what the release lists"
expect "and not installed" [ ! -e "$action/path" ]
echo "0 something-else" >"$sums"
install Linux X64 ''
expect "an archive that the release does not list is rejected" says "does not name $archive"
cp "$action/sums" "$sums"

# Windows has an archive of its own, and backslashes in the path of its temporary folder.
windows=mhlint-$version-x86_64-pc-windows-msvc
(cd "$action/temp" && tar -xzf "$releases/v$version/$archive" && mv "${archive%.tar.gz}" "$windows" &&
    python3 -m zipfile -c "$releases/v$version/$windows.zip" "$windows" && cd "$releases/v$version" && sha256sum "$windows.zip" >>"$sums")
temp=$action/D:\\a\\_temp
mkdir "$temp"
run env RUNNER_OS=Windows RUNNER_ARCH=X64 RUNNER_TEMP="$temp" GITHUB_PATH="$action/path" \
    MHLINT_VERSION="$version" MHLINT_RELEASES="file://$releases" bash action/install.sh
expect "a temporary folder with backslashes is no obstacle" ended_with 0

# The run: a stand-in shows the arguments, then the real command checks.
check() { # folder of the command, paths, arguments
    rm -rf "$action/temp" "$action/out" "$action/summary" && mkdir "$action/temp"
    touch "$action/summary" "$action/out"
    run env PATH="$1:$PATH" RUNNER_TEMP="$action/temp" GITHUB_OUTPUT="$action/out" GITHUB_STEP_SUMMARY="$action/summary" \
        GITHUB_ACTIONS=true CI=true MHLINT_PATHS="$2" MHLINT_ARGS="$3" bash "$project/action/run.sh"
}
mkdir "$action/stand-in"
printf '#!/bin/sh\nprintf "<%%s>" "$@"\nexit 3\n' >"$action/stand-in/mhlint"
chmod +x "$action/stand-in/mhlint"
check "$action/stand-in" 'src assets' '--skip *.md --fail-on warning'
expect "paths and arguments arrive apart, and no glob is expanded" \
    says '<check><src><assets><--skip><*.md><--fail-on><warning><--report><github>'
check "$action/stand-in" $'src\nassets\n' $'--skip *.md\n--fail-on warning\n'
expect "so do those on several lines" says '<check><src><assets><--skip><*.md><--fail-on><warning><--report><github>'
expect "the exit code is an output, and the step goes on" grep -qx 'exit-code=3' "$action/out"
expect "no SARIF is promised where none was written" [ "$(grep -c sarif "$action/out")" = 0 ]

check "$(dirname "$mhlint")" fixtures/makehuman2 ''
expect "sound data give exit code 0" grep -qx 'exit-code=0' "$action/out"
cp -r fixtures/makehuman2/. "$action/data"
sed -i 's/"steps": \[0.0, 0.25, 0.5, 1.0\]/"steps": [0.0, 0.25, 0.5, 0.75, 1.0]/' "$action/data/data/target/figure/macro.json"
check "$(dirname "$mhlint")" target/packaging/action/data ''
expect "damaged data give exit code 1" grep -qx 'exit-code=1' "$action/out"
expect "the fault is annotated" says '::error '
expect "the annotation names the file" says 'file=target/packaging/action/data/data/target/figure/macro.json'
expect "the log has the readable report" says 'help: add a value for every step'
expect "nothing in the report can speak to the runner" says '::stop-commands::'
expect "the summary names the rule" grep -q macro-steps-length "$action/summary"
expect "SARIF holds the rule" grep -q '"macro-steps-length"' "$action/temp/mhlint.sarif"
expect "SARIF is an output" grep -qx "sarif=$action/temp/mhlint.sarif" "$action/out"
