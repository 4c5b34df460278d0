# For the driver's test scripts, which source it: one line a check, and a count of those that failed.
failures=0

ok() { printf 'ok      %s\n' "$1"; }
# failed WHAT [LINE...]
failed() {
    printf 'FAILED  %s\n' "$1"
    shift
    ((!$#)) || printf '        %s\n' "$@"
    failures=$((failures + 1))
}
