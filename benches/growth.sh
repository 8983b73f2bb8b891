#!/usr/bin/env bash
# Instructions (callgrind) and peak memory of the compiler for functions of growing size: lines of kind, size, millions
# of instructions, MiB and operations of the compiled function.
set -euo pipefail
cd "$(dirname "$0")/.."

if ! command -v valgrind >/dev/null; then
    apt-get update -qq && apt-get install -y -qq valgrind
fi
cargo build --release --locked -q -p ga-compiler --example growth
program=${CARGO_TARGET_DIR:-target}/release/examples/growth

for kind in length sharing nesting operands array chain; do
    for size in ${SIZES:-1 2 4 8 16 32 64 128 256 512}; do
        plain=$("$program" "$kind" "$size")
        instructions=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" "$kind" "$size" 2>&1 >/dev/null |
            sed -n 's/^.*Collected : \([0-9]*\).*$/\1/p')
        awk -v k="$kind" -v s="$size" -v i="$instructions" '
            /^operations/ { operations = $2 }
            /^VmHWM/ { memory = $2 }
            END { printf "| %s | %d | %.0f | %.1f | %d |\n", k, s, i / 1e6, memory / 1024, operations }' <<<"$plain"
    done
done
