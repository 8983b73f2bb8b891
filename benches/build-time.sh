#!/usr/bin/env bash
# Build times in fresh crates outside the workspace, default profiles and features: lines of what, limit and figure.
#
# Each figure is the least of three builds; the builds of the contenders alternate.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset RUSTFLAGS CARGO_TARGET_DIR

crate() { # name, dependency
    mkdir -p "$work/$1/src"
    printf '[package]\nname = "%s"\nversion = "0.0.0"\nedition = "2024"\n[dependencies]\n%s\n[workspace]\n' "$1" "$2" > "$work/$1/Cargo.toml"
    cp "$root/Cargo.lock" "$work/$1/Cargo.lock"
    : > "$work/$1/src/lib.rs"
}

seconds() { # command
    local start end
    start=$(date +%s.%N)
    "$@" >/dev/null 2>&1
    end=$(date +%s.%N)
    awk -v a="$start" -v b="$end" 'BEGIN { print b - a }'
}

least() { sort -n | head -n 1; }

runtime="ga-runtime = { path = \"$root/ga-runtime\" }"
# With its default features, as a crate has it that asks for no others.
glam="glam = \"$(sed -n 's/^glam = { version = "\([^"]*\)".*/\1/p' Cargo.toml)\""
crate only_runtime "$runtime"
crate only_glam "$glam"
for name in only_runtime only_glam; do
    cargo fetch -q --manifest-path "$work/$name/Cargo.toml"
done

# A build from nothing, and a build of the crate alone when its dependencies have been built.
for _ in 1 2 3; do
    for name in only_runtime only_glam; do
        manifest=$work/$name/Cargo.toml
        rm -rf "$work/$name/target"
        seconds cargo build --offline --manifest-path "$manifest" >> "$work/$name.all"
        package=ga-runtime
        if [ "$name" = only_glam ]; then package=glam; fi
        cargo clean -q --offline --manifest-path "$manifest" -p "$package"
        seconds cargo build --offline --manifest-path "$manifest" >> "$work/$name.unit"
    done
done
all_ours=$(least < "$work/only_runtime.all")
all_glam=$(least < "$work/only_glam.all")
unit_ours=$(least < "$work/only_runtime.unit")
unit_glam=$(least < "$work/only_glam.unit")

# One more expression of sandwich size: the slope over fifty.
expressions() { # number
    local place
    for place in $(seq "$1"); do
        echo "ga_runtime::ga! { ga_runtime::cga3; pub fn f$place(m: Motor, x: Line) -> Line { m * x * rev(m) } }"
    done > "$work/only_runtime/src/lib.rs"
}
for _ in 1 2 3; do
    for number in 1 51; do
        expressions "$number"
        seconds cargo build --offline --manifest-path "$work/only_runtime/Cargo.toml" >> "$work/expressions.$number"
    done
done
one=$(least < "$work/expressions.1")
many=$(least < "$work/expressions.51")

# Every declared product of cga3, at f32 and f64.
crate instances "$runtime"
cargo run --release --locked -q -p nullcone-benches --bin instances > "$work/instances.rs"
cargo build --offline --manifest-path "$work/instances/Cargo.toml" >/dev/null 2>&1
cp "$work/instances.rs" "$work/instances/src/lib.rs"
instances=$(seconds cargo build --offline --manifest-path "$work/instances/Cargo.toml")
touch "$work/instances/src/lib.rs"
instances_release=$(seconds cargo build --release --offline --manifest-path "$work/instances/Cargo.toml")

line() { printf '%s\t%s\t%.3f\n' "$1" "$2" "$3"; }
ratio() { awk -v a="$1" -v b="$2" 'BEGIN { print a / b }'; }
line "ga-runtime alone, ratio to glam alone" "0.9" "$(ratio "$unit_ours" "$unit_glam")"
line "ga-runtime with all it needs, ratio to a crate with glam" "2.0" "$(ratio "$all_ours" "$all_glam")"
line "one more ga! expression, seconds" "0.1" "$(awk -v a="$one" -v b="$many" 'BEGIN { print (b - a) / 50 }')"
line "ga-runtime alone, seconds" "reported" "$unit_ours"
line "glam alone, seconds" "reported" "$unit_glam"
line "a crate that calls every declared product of cga3 at f32 and f64, seconds" "reported" "$instances"
line "the same optimised, with ga-runtime and all it needs, seconds" "reported" "$instances_release"
