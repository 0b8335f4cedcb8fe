#!/usr/bin/env bash
# docs/draw_pictures.sh: draws the editor's pictures in README.md and docs/first-table.md anew, with the release build. Look at them after.
set -euo pipefail
cd "$(dirname "$(realpath "$0")")/.."
editor=$PWD/build/release/bin/pinfield-editor
docs=$PWD/docs
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
export LIBGL_ALWAYS_SOFTWARE=1
draw() { (cd "$place" && xvfb-run --auto-servernum --server-args="-screen 0 1600x1000x24" "$editor" "$@"); }

cp scenes/tables/first_table.yaml "$place"
draw first_table.yaml --script "$docs/editor.yaml" --size 1440x900
mv "$place/editor.png" "$docs"
draw --script "$docs/first-table/steps.yaml" --size 1280x800
mv "$place"/*.png "$docs/first-table"
