#!/usr/bin/env bash
# Instructions for one operation of the main kernels, counted by callgrind: lines of kernel, contender and count.
#
# Each kernel runs N and 2N times. The difference divided by N and by the inputs of one round is the count of one
# operation; everything around it cancels.
set -euo pipefail
cd "$(dirname "$0")/.."

if ! command -v valgrind >/dev/null; then
    apt-get update -qq && apt-get install -y -qq valgrind
fi
target=${CARGO_TARGET_DIR:-target}/instructions
# A level of instructions that valgrind supports completely.
export CARGO_TARGET_DIR=$target RUSTFLAGS="-C target-cpu=x86-64-v3"
cargo build --release --locked -q -p nullcone-benches --bin kernels
program=$target/release/kernels

count() { # kernel, contender, rounds
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" "$1" "$2" "$3" 2>&1 >/dev/null |
        sed -n 's/^.*Collected : \([0-9]*\).*$/\1/p'
}

"$program" --list | while IFS=$'\t' read -r kernel contender inputs; do
    once=$(count "$kernel" "$contender" 20)
    twice=$(count "$kernel" "$contender" 40)
    awk -v k="$kernel" -v c="$contender" -v d="$((twice - once))" -v n="$((20 * inputs))" \
        'BEGIN { printf "%s\t%s\t%.1f\n", k, c, d / n }'
done
