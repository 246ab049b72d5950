#!/bin/sh
# Checks which way includes run: arrows.sh SOURCES FLOORS. Says each that runs upwards (floors.txt), each cycle of units,
# each folder of more than 20 units, each file that gets VTK's headers through a header of another room, and each of apps
# that includes more of render than the headers that stand in no room of it; exits with 1 when there is one.
set -u
cd "$1"
floors="$2"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

find solver render apps -name '*.[hc]pp' | sort |
  xargs awk 'sub(/^#include "/, "") && sub(/".*/, "") { print FILENAME, $0 }' >"$work/includes"
sed 's/\.[hc]pp / /; s/\.[hc]pp$//' "$work/includes" | awk '$1 != $2' | sort -u >"$work/arrows"

awk '
  function floor_of(unit,   place) {
    if (unit in floor) return floor[unit]
    place = unit
    if (sub(/\/[^\/]*$/, "", place) && place in floor) return floor[place]
    print unit " stands in no room of floors.txt"; bad = 1
    return 0
  }
  NR == FNR { if ($0 !~ /^#/ && NF) floor[$1] = ++floors; next }
  floor_of($1) < floor_of($2) { print $1 " includes " $2 ", which stands above it"; bad = 1 }
  END { exit bad }
' "$floors" "$work/arrows"
upwards=$?

# tsort names the units of a cycle on stderr.
tsort "$work/arrows" >/dev/null 2>"$work/cycles" || sed 's/^/cycle: /' "$work/cycles"

find solver render apps -name '*.[hc]pp' | sed 's/\.[hc]pp$//' | sort -u | sed 's,/[^/]*$,,' | sort | uniq -c |
  awk '$1 > 20 { print $2 " holds " $1 " units, more than 20" }' | tee "$work/crowded"

find solver render apps -name '*.hpp' | sort | xargs grep -l '^#include <vtk' >"$work/vtk_headers"
awk '
  function room(file) { sub(/\/[^\/]*$/, "", file); return file }
  NR == FNR { vtk[$1]; next }
  $2 in vtk && room($1) != room($2) { print $1 " includes VTK by way of " $2 ", a header of another room" }
' "$work/vtk_headers" "$work/includes" | tee "$work/vtk"

awk '$1 ~ /^apps\// && $2 ~ /^render\/.*\// { print $1 " includes " $2 ", which is no header of render itself" }' \
  "$work/includes" | tee "$work/inner"

[ "$upwards" -eq 0 ] && [ ! -s "$work/cycles" ] && [ ! -s "$work/crowded" ] && [ ! -s "$work/vtk" ] &&
  [ ! -s "$work/inner" ]
