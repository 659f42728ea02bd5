# Sourced: a throw-away repository with the example data, the hook taken from a mirror that pins the wheel, and commits.

hook=$work/hook
mirror=$hook/mirror
repository=$hook/repository
rm -rf "$hook"
mkdir -p "$mirror" "$repository" "$hook/no-compiler"

# Nothing of this machine's configuration of git and pip, and no index: what is not in the folder of wheels is not there.
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null
export GIT_AUTHOR_NAME=Artist GIT_AUTHOR_EMAIL=artist@example.org GIT_COMMITTER_NAME=Artist GIT_COMMITTER_EMAIL=artist@example.org
export PRE_COMMIT_HOME=$hook/cache PRE_COMMIT_COLOR=never
# pip builds the mirror, which holds nothing, with setuptools.
cp "$venv"/wheels/setuptools-*.whl "$wheels"
export PIP_NO_INDEX=1 PIP_FIND_LINKS=$wheels VIRTUALENV_NO_PERIODIC_UPDATE=1

# No compiler: each of these would leave a trace and fail. pip asks `rustc --version` for its own statistics, that does not count.
for compiler in cargo rustc cc gcc clang; do
    printf '#!/bin/sh\n[ "$*" = --version ] || echo "$0 $*" >>"%s/called"\nexit 1\n' "$hook" >"$hook/no-compiler/$compiler"
    chmod +x "$hook/no-compiler/$compiler"
done
PATH_BEFORE=$PATH
export PATH=$hook/no-compiler:$PATH

cp -r packaging/pre-commit-mirror/. "$mirror"
git -C "$mirror" init --quiet --initial-branch main
run "$mirror/update.sh" "$version"
expect "the mirror is made by its own script" ended_with 0
run git -C "$mirror" tag --list
expect "the mirror has the tag of the version" says "v$version"

cp -r fixtures/makehuman2/. "$repository"
cd "$repository"
git init --quiet --initial-branch main
hook_with() { # further lines of the hook
    printf 'repos:\n  - repo: %s\n    rev: v%s\n    hooks:\n      - id: mhlint\n' "$mirror" "$version" >.pre-commit-config.yaml
    printf '%s' "$1" >>.pre-commit-config.yaml
    git add .pre-commit-config.yaml
}
hook_with ''
git add -A
run pre-commit install --install-hooks
expect "pre-commit installs the hook" ended_with 0
expect "no compiler was called" [ ! -e "$hook/called" ]
echo "hook: installed in $took, without a compiler"

# The first commit has no HEAD to compare with; one step of a macro is gone.
damage() { sed -i 's/"steps": \[0.0, 0.25, 0.5, 1.0\]/"steps": [0.0, 0.25, 0.5, 0.75, 1.0]/' data/target/figure/macro.json; }
damage
git add data
run git commit --message "Damaged example data"
expect "a damaged first commit is rejected" ended_with 1
expect "the rejection of the first commit names the fault" says 'error[macro-steps-length]'
echo "hook: a damaged first commit rejected in $took"
cp "$project/fixtures/makehuman2/data/target/figure/macro.json" data/target/figure
git add data
run git commit --message "Example data"
expect "sound data are committed" ended_with 0
echo "hook: a sound first commit in $took"

# A damaged commit.
before=$(git rev-parse HEAD)
damage
expect "the example is damaged" test -n "$(git status --short)"
run git commit --all --message "A step less"
echo "hook: a damaged commit rejected in $took; what the artist sees:"
echo "$output" | sed 's/^/    /'
expect "the damaged commit is rejected" ended_with 1
expect "nothing was committed" [ "$(git rev-parse HEAD)" = "$before" ]
for words in 'data/target/figure/macro.json' 'error[macro-steps-length]' 'component `age` has 4 values but 5 steps' \
    'MakeHuman 2: crashes with `IndexError`' 'help: add a value for every step' 'Failed: 1 new error'; do
    expect "the rejection names fault, consequence and help" says "$words"
done
git restore --staged --worktree .

# A sound change.
sed -i 's/^337 .002 /337 .003 /' data/target/figure/head/head-oval.target
run git commit --all --message "A rounder head"
expect "a sound change passes" ended_with 0
expect "the sound change was committed" test -n "$(git log --format=%h --grep 'A rounder head')"
echo "hook: a sound change in $took"
sound=$(git rev-parse HEAD)

# What has nothing to do with assets does not start the hook; pre-commit does not count deletions as changes, `always_run` does.
echo 'Notes' >notes.md
git add notes.md
run git commit --message "Notes"
expect "notes do not start the hook" says "Skipped"
git rm --quiet data/target/figure/head/head-oval.target
run git commit --message "A target less"
expect "a deletion alone does not start the hook" says "Skipped"
git reset --quiet --hard HEAD~1
hook_with '        always_run: true
'
git rm --quiet data/target/figure/head/head-oval.target
run git commit --message "A target less, and always_run"
expect "with always_run a deletion that matters is rejected" ended_with 1
echo "hook: a deletion alone is skipped, with always_run rejected in $took"
expect "the rejection names the target that is gone" says "head-oval"
git reset --quiet --hard HEAD

# Narrowed to what is staged: an old fault elsewhere does not stand in the way, one of the commit does.
oval=data/target/figure/head/head-oval.target
hook_with ''
damage
run git commit --all --no-verify --message "An old fault"
sed -i 's/^337 .003 /337 .004 /' $oval
run git commit --all --message "Sound, beside an old fault"
expect "an old fault elsewhere does not stand in the way" ended_with 0
echo "hook: a sound commit beside an old fault in $took"
echo '337 nothing 0 0' >>$oval
run git commit --all --message "Unsound, beside an old fault"
expect "a fault of the commit is rejected" ended_with 1
expect "the rejection names the changed file" says "$oval"
expect "the rejection does not name the old fault" does_not_say "macro-steps-length"
echo "hook: an unsound commit beside an old fault rejected in $took"
sed -i 's/^338 .002 /338 .003 /' data/target/figure/head/head-side-in.target
run git commit --message "Sound, beside a fault that stays behind" -- data/target/figure/head/head-side-in.target
expect "what is not in the commit is put aside" ended_with 0
git checkout --quiet -- $oval

# With nothing staged everything is reported: what CI asks for.
run pre-commit run --all-files
expect "with nothing staged an old fault is rejected" ended_with 1
expect "with nothing staged the old fault is named" says 'error[macro-steps-length]'
expect "with nothing staged the hook says what it reports" says 'nothing is staged; reporting all findings'
echo "hook: all files in $took"
run pre-commit run --from-ref HEAD~1 --to-ref HEAD
expect "between two commits everything is reported" says 'error[macro-steps-length]'
echo 'More notes' >>notes.md
git add notes.md
run pre-commit run --all-files
expect "with something staged all files are narrowed, too" ended_with 0
run git commit --message "More notes"

# The lines of the documents that change what is reported.
hook_with '        entry: mhlint check
'
sed -i 's/^337 .004 /337 .005 /' $oval
run git commit --all --message "With another entry"
expect "with an entry of one's own the whole report decides" ended_with 1
expect "with an entry of one's own the old fault is named" says 'error[macro-steps-length]'
hook_with '        args: [data/, --since, HEAD~1]
'
echo '337 nothing 0 0' >>data/target/figure/head/head-side-in.target
run git commit --all --no-verify --message "Damaged on this branch"
sed -i 's/^337 .005 /337 .006 /' $oval
run git commit --all --message "Sound, on a damaged branch"
expect "--since in args takes the place of --staged" ended_with 1
expect "with --since in args an earlier commit of the branch counts" says head-side-in.target
expect "with --since in args the old fault does not count" does_not_say "macro-steps-length"

# The hooks that need an installed mhlint: `mhlint-system`, and the one of the README, word by word.
mkdir "$hook/hooks" && cp "$project/.pre-commit-hooks.yaml" "$hook/hooks"
git -C "$hook/hooks" init --quiet --initial-branch main
git -C "$hook/hooks" add .pre-commit-hooks.yaml
git -C "$hook/hooks" commit --quiet --message Hooks
export PATH=$(dirname "$mhlint"):$PATH
git reset --quiet --hard "$sound"
for name in mhlint-system README; do
    if [ $name = README ]; then
        cp "$blocks"/1-.pre-commit-config.yaml .pre-commit-config.yaml
    else
        printf 'repos:\n  - repo: %s\n    rev: %s\n    hooks:\n      - id: %s\n' \
            "$hook/hooks" "$(git -C "$hook/hooks" rev-parse HEAD)" $name >.pre-commit-config.yaml
    fi
    git add .pre-commit-config.yaml
    run git commit --message "Hook $name"
    expect "sound data pass $name" ended_with 0
    damage
    run git commit --all --message "A step less"
    expect "damaged data do not pass $name" says 'error[macro-steps-length]'
    git reset --quiet --hard HEAD
done

cd "$project"
export PATH=$PATH_BEFORE
unset PIP_NO_INDEX PIP_FIND_LINKS
