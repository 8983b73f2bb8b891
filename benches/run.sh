#!/usr/bin/env bash
# Measures everything and writes benches/RESULTS.md: times beside rivals in interleaved runs, instructions, build times.
#
#   benches/run.sh            all of it, with the rivals from crates.io
#   RUNS=1 benches/run.sh     one run instead of five
#   RIVALS=0 benches/run.sh   without the rivals other than glam, one of which takes minutes to compile
set -euo pipefail
cd "$(dirname "$0")/.."

runs=${RUNS:-5}
features=()
if [ "${RIVALS:-1}" = 1 ]; then features=(--features rivals); fi
# Criterion would take a relative path as relative to benches/.
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
native="-C target-cpu=native"

bench() { # folder, flags, run, arguments of cargo
    local folder=$1 flags=$2 run=$3
    shift 3
    CARGO_TARGET_DIR=$folder RUSTFLAGS=$flags cargo bench --locked -p nullcone-benches "$@" -- --save-baseline "run-$run" --noplot
}

# Earlier runs do not count.
rm -rf "$target/native/criterion" "$target/default/criterion"
for run in $(seq "$runs"); do
    bench "$target/native" "$native" "$run" "${features[@]}"
    # Most users build without flags: the methods, and the code that chooses its instructions itself.
    bench "$target/default" "" "$run" --bench batch --bench geometry --bench scene
done

instructions=$target/instructions.tsv
benches/instructions.sh > "$instructions"
build_times=$target/build-times.tsv
benches/build-time.sh > "$build_times"

cargo run --release --locked -p nullcone-benches --bin table -- \
    --criterion "$target/native/criterion" --flags "$native" \
    --criterion "$target/default/criterion" --flags "" \
    --instructions "$instructions" --build-times "$build_times" \
    --date "$(date +%F)"
