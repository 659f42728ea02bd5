# Sourced: the wheel, built by maturin and installed into a fresh environment that cannot reach an index.

wheels=$work/wheels
rm -rf "$wheels" "$work/fresh"
mkdir -p "$wheels"

if [ -n "${MHLINT_WHEEL:-}" ]; then
    cp "$MHLINT_WHEEL" "$wheels"
else
    run maturin build --release --locked --out "$wheels"
    expect "maturin builds the wheel" ended_with 0
    echo "wheel: built in $took"
fi

python3 -m venv "$work/fresh"
run "$work/fresh/bin/pip" install --no-index --find-links "$wheels" "mhlint==$version"
expect "the wheel installs from nothing but itself" ended_with 0
echo "wheel: $(du -h "$wheels"/*.whl | cut -f1), installed in $took"

mhlint=$work/fresh/bin/mhlint
run "$mhlint" --version
expect "the installed command is this version" says "mhlint $version"
run "$mhlint" fixtures/makehuman2
expect "the installed command checks" ended_with 0
echo "wheel: the example repository checked in $took"
run "$mhlint" explain macro-steps-length
expect "the fixtures are inside the installed command" says "4 values but 5 steps"
