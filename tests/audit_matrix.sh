#!/usr/bin/env bash
# tests/audit_matrix.sh [TABLE] [PINFIELD] [DIVISOR]: the promise, audited: no ball leaves the table or passes through or into a solid, at any
# speed, elastic or not, with still flippers or beating ones. Prints a table; exit 1 when anything went wrong. DIVISOR: so many
# times fewer balls, for a quicker look; in full it takes a quarter of an hour or more.
set -euo pipefail

root=$(cd "$(dirname "$(realpath "$0")")/.." && pwd)
table=${1:-$root/scenes/tables/first_table.yaml}
pinfield=${2:-$root/build/release/bin/pinfield}
divisor=${3:-1}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# Both flippers beat together: 60 ms up, 90 ms down, for as long as the longest run.
{
    echo tick,input,value
    for ((tick = 0; tick < 10000; tick += 150)); do
        printf '%d,left,1\n%d,right,1\n%d,left,0\n%d,right,0\n' "$tick" "$tick" $((tick + 60)) $((tick + 60))
    done
} >"$scratch/beating.csv"

number() { sed -nE "s/.*\"$2\": *([-+0-9.e]+|null).*/\1/p" <<<"$1"; }

failed=0
printf '%6s %6s %5s %-9s %-8s %8s %10s %12s %12s %8s %12s  %s\n' \
    m/s balls s bounce flippers escaped crossings worst_depth penetration quarant. steps/s verdict
for run in "1000 100 1" "100 300 2" "10 1000 10" "1 1000 10"; do
    read -r speed balls seconds <<<"$run"
    balls=$((balls / divisor))
    for bounce in material elastic; do
        for flippers in still beating; do
            arguments=(simulate "$table" --balls "$balls" --speed "$speed" --seconds "$seconds" --seed 1 --audit --json)
            [[ $bounce == elastic ]] && arguments+=(--restitution 1)
            [[ $flippers == beating ]] && arguments+=(--inputs "$scratch/beating.csv")
            if ! summary=$("$pinfield" "${arguments[@]}"); then
                echo "pinfield ${arguments[*]} failed"
                failed=1
                continue
            fi
            escaped=$(number "$summary" escaped)
            crossings=$(number "$summary" crossings)
            depth=$(number "$summary" worst_depth)
            penetration=$(number "$summary" max_penetration)
            quarantined=$(number "$summary" quarantine)
            steps=$(number "$summary" ball_steps_per_second)
            verdict=fine
            awk -v e="$escaped" -v c="$crossings" -v d="$depth" -v p="$penetration" -v q="${quarantined:-0}" 'BEGIN {
                exit !(e == "0" && c == "0" && q == "0" && d != "null" && d < 1e-6 && p != "null" && p < 1e-6) }' || {
                verdict=WRONG
                failed=1
            }
            printf '%6s %6s %5s %-9s %-8s %8s %10s %12s %12s %8s %12.0f  %s\n' "$speed" "$balls" "$seconds" "$bounce" "$flippers" \
                "$escaped" "$crossings" "$depth" "$penetration" "${quarantined:-0}" "$steps" "$verdict"
        done
    done
done
exit "$failed"
