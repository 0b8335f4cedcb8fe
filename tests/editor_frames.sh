#!/usr/bin/env bash
# tests/editor_frames.sh [EDITOR]: frames a second of the editor's window in software rendering, 1280x720: playing, dragging in the first
# table, dragging in a table of 2000 nodes. Each from the difference of a short and a long run, so that starting does not count.
# Needs xvfb-run and a machine that does nothing else; takes a minute.
set -euo pipefail

root=$(cd "$(dirname "$(realpath "$0")")/.." && pwd)
editor=${1:-$root/build/release/bin/pinfield-editor}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export LIBGL_ALWAYS_SOFTWARE=1 XDG_STATE_HOME=$scratch/state
frames_of_a_drag=18  # editor/script_hand.cpp: to its place, down, twelve steps, rest, up, and one more

# 2000 shapes on a grid, and one with free space around it to be dragged.
awk 'BEGIN {
    print "pinfield: 1\ntable: {size: [0.52, 1.06]}\nscene:"
    print "  - domain: {children: [box: {size: [0.5, 1.04], at: [0.26, 0.53]}]}"
    print "  - circle: {id: mine, radius: 12mm, at: [0.3, 0.8]}"
    for (i = 0; n < 2000; ++i) {
        x = 14 + i % 44 * 11.3; y = 14 + int(i / 44) * 21
        if ((x - 300)^2 + (y - 800)^2 < 45^2) continue
        ++n
        if (i % 3 == 0) printf "  - circle: {radius: 2mm, at: [%gmm, %gmm]}\n", x, y
        if (i % 3 == 1) printf "  - box: {size: [4mm, 3mm], at: [%gmm, %gmm]}\n", x, y
        if (i % 3 == 2) printf "  - capsule: {length: 4mm, radius: 1mm, at: [%gmm, %gmm]}\n", x, y
    }
}' >"$scratch/large.yaml"
cp "$root/scenes/tables/first_table.yaml" "$scratch/first_table.yaml"
for drags in 10 40; do
    {
        echo "- {action: play.pause}"
        for ((i = 0; i < drags; i += 2)); do
            echo "- {drag: {from: [0.300, 0.800], to: [0.310, 0.810]}}"
            echo "- {drag: {from: [0.310, 0.810], to: [0.300, 0.800]}}"
        done
    } >"$scratch/$drags.yaml"
done

seconds() {
    local TIMEFORMAT=%R
    { time xvfb-run --auto-servernum --server-args="-screen 0 1400x900x24" "$editor" "$@" --size 1280x720 >/dev/null 2>&1; } 2>&1
}
report() { awk -v what="$1" -v frames="$2" -v a="$3" -v b="$4" 'BEGIN {printf "%-32s %6.1f frames/s\n", what, frames / (b - a)}'; }

report "playing" 400 "$(seconds "$scratch/first_table.yaml" --frames 100)" "$(seconds "$scratch/first_table.yaml" --frames 500)"
for table in first_table large; do
    report "dragging, $table" $((30 * frames_of_a_drag)) "$(seconds "$scratch/$table.yaml" --script "$scratch/10.yaml")" \
        "$(seconds "$scratch/$table.yaml" --script "$scratch/40.yaml")"
done
