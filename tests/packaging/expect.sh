# Sourced: what the other scripts expect, and a count of it for the last line.

passed=0
failed=0

expect() { # what is shown, then a command that is true
    local what=$1 said
    shift
    if said=$("$@" 2>&1); then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $what"
        printf '    %s\n' "$*" "$said"
    fi
}

# A command's output and exit code are kept in $output and $code; its time in $took.
run() {
    local start
    start=$(date +%s%N)
    code=0
    output=$("$@" 2>&1) || code=$?
    took=$(awk -v ns=$(($(date +%s%N) - start)) 'BEGIN { printf "%.2f s", ns / 1e9 }')
}

ended_with() { # code
    [ "$code" = "$1" ] || { echo "exit code $code in place of $1:" && echo "$output" && return 1; }
}

says() { # words
    case $output in
    *"$1"*) ;;
    *) echo "no '$1' in:" && echo "$output" && return 1 ;;
    esac
}

does_not_say() { # words
    if says "$1" >/dev/null; then echo "'$1' in:" && echo "$output" && return 1; fi
}

verdict() {
    echo "packaging: $passed passed, $failed failed"
    [ "$failed" = 0 ]
}
