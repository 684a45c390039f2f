# Sourced by the scripts beside it: runs a step, and says what it is and how long it took.
cd "$(dirname "${BASH_SOURCE[0]}")/.."

step() {
    local title=$1
    shift
    echo "==> $title"
    local start=$SECONDS
    "$@"
    echo "    ($title: $((SECONDS - start)) s)"
}
