#!/usr/bin/env bash
# clang-tidy over what the last commit and the working tree changed: their units, and for a changed header one unit that includes it.
# A unit costs half a minute (its matchers walk all of Eigen), so at most LIMIT units; `cmake --preset tidy` runs it over everything.
set -euo pipefail
cd "$(dirname "$(realpath "$0")")/.."
limit=${1:-24}

if ! git rev-parse --quiet --verify HEAD~1 >/dev/null; then
    echo "No earlier commit to compare with: clang-tidy is left out."
    exit
fi
readarray -t changed < <({ git diff --name-only --diff-filter=d HEAD~1 && git ls-files --others --exclude-standard; } | sort -u | grep -E '\.(cpp|h)$' || true)
((${#changed[@]})) || exit 0

# Without precompiled headers: clang-tidy would read them from a build of its own.
cmake --preset tidy -B build/lint -DPINFIELD_TIDY=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON --log-level=WARNING >/dev/null
readarray -t units < <(
    for file in "${changed[@]}"; do
        case $file in
            *.cpp) echo "$file" ;;
            *) if [[ -f ${file%.h}.cpp ]]; then echo "${file%.h}.cpp"; else grep -rlF --include='*.cpp' "#include \"$file\"" engine editor tests examples | head -1 || true; fi ;;
        esac
    done | sort -u | while read -r unit; do if grep -qF "/$unit\"" build/lint/compile_commands.json; then echo "$unit"; fi; done)
((${#units[@]})) || exit 0
((${#units[@]} <= limit)) || echo "clang-tidy: the first $limit of ${#units[@]} changed units"
printf '%s\n' "${units[@]:0:limit}" |
    xargs -P "$(nproc)" -n 1 clang-tidy-14 -p build/lint --quiet --warnings-as-errors='*'
