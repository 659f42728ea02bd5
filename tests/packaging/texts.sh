# Sourced: workflows, action, hooks and versions by their schemas and by each other.

version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)

expect "workflows fit the schema of GitHub" check-jsonschema --quiet --builtin-schema vendor.github-workflows .github/workflows/*.yml
expect "action.yml fits the schema of GitHub" check-jsonschema --quiet --builtin-schema vendor.github-actions action.yml
expect "workflows and action have no known weakness" \
    zizmor --offline --quiet --no-progress --min-severity low .github/workflows action.yml
for hooks in .pre-commit-hooks.yaml packaging/pre-commit-mirror/.pre-commit-hooks.yaml; do
    expect "pre-commit reads $hooks" pre-commit validate-manifest "$hooks"
done

# Examples of the documents: a block of YAML that is a whole file says in its first line which.
blocks=$work/blocks
rm -rf "$blocks" && mkdir -p "$blocks"
awk -v folder="$blocks" '
    /^```yaml/ { getline; name = $2; gsub("/", "_", name); file = folder "/" ++count "-" name; open = $1 == "#" && name != "" }
    /^```$/ { open = 0 }
    open { print > file }' README.md docs/*.md packaging/pre-commit-mirror/README.md
for block in "$blocks"/*; do
    case $block in
    *workflows*) expect "$block fits" check-jsonschema --quiet --builtin-schema vendor.github-workflows "$block" ;;
    *gitlab-ci*) expect "$block fits" check-jsonschema --quiet --builtin-schema vendor.gitlab-ci "$block" ;;
    *pre-commit-config*) expect "pre-commit reads $block" pre-commit validate-config "$block" ;;
    *) expect "$block is of a known kind" false ;;
    esac
done
expect "the hooks of the documents start on the same files" [ "$(cat .pre-commit-hooks.yaml "$blocks"/* | grep -oF "files: '(?i)" | wc -l)" = \
    "$(cat .pre-commit-hooks.yaml "$blocks"/* | grep -cF "$(grep -m 1 -o 'files: .*' .pre-commit-hooks.yaml)")" ]

# The placeholder of the account stops a release until it is replaced as packaging/README.md says.
copy=$work/release
rm -rf "$copy" && mkdir "$copy"
cp -r Cargo.toml README.md CHANGELOG.md docs packaging "$copy"
run env -u GITHUB_REPOSITORY "$copy/packaging/check-release.sh"
expect "a release with the placeholder is stopped" says "OWNER still stands"
grep -rlw OWNER "$copy/docs" "$copy/packaging/pre-commit-mirror" | xargs sed -i 's/\bOWNER\b/somebody/g'
run env -u GITHUB_REPOSITORY "$copy/packaging/check-release.sh"
expect "the placeholder is found nowhere once it is replaced" does_not_say "OWNER still stands"

expect "the mirror pins this version" grep -qF "\"mhlint==$version\"" packaging/pre-commit-mirror/pyproject.toml
for line in $(grep -hoE '[A-Za-z-]+/mhlint@v[^ ]*|key: mhlint-[0-9.]*|mhlint==[0-9.]*|mhlint --tag v[0-9.]*' README.md docs/*.md packaging/README.md | tr -d ' '); do
    expect "$line in the documents is this version" grep -qF "$version" <<<"$line"
done
expect "the mirror's README names this version" grep -qF "rev: v$version" packaging/pre-commit-mirror/README.md
expect "shellcheck has nothing to say" \
    shellcheck -x --severity=warning action/*.sh packaging/*.sh packaging/pre-commit-mirror/*.sh tests/browser/run.sh tests/packaging/run.sh .ci/run
