#!/usr/bin/env bash
# docs/draw_pictures.sh: draws the editor's pictures in README.md and docs/first-table.md anew, with the release build. Look at them after.
# docs/draw_pictures.sh --check: whether what they show has changed since they were drawn, by the sums in docs/pictures.sha256.
set -euo pipefail
cd "$(dirname "$(realpath "$0")")/.."
sums=docs/pictures.sha256
# What they show, but for panels, most of whose changes they do not show; and the pictures.
shown=(scenes/tables/first_table.yaml docs/editor.yaml docs/first-table/steps.yaml editor/theme/colors.cpp editor/theme/theme.cpp
    editor/render/shaders.h docs/editor.png docs/first-table/*.png)

if [[ ${1:-} == --check ]]; then
    if ! sha256sum --check --strict --quiet "$sums" 2>&1; then
        echo "Pictures in README.md and docs are older than what they show: run docs/draw_pictures.sh and look at them." >&2
        exit 1
    fi
    # A picture that no line of the sums names was not drawn by this script.
    for file in "${shown[@]}"; do
        grep -qF "  $file" "$sums" || { echo "$sums does not name $file" >&2 && exit 1; }
    done
    exit
fi

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
sha256sum "${shown[@]}" > "$sums"
