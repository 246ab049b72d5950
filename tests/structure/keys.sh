#!/bin/sh
# The tables of keys in scenes/README.md are what `seiche schema --markdown` prints: keys.sh PROGRAM README [--write].
# Without --write it exits with 1 where they differ.
set -eu
program="$1"
readme="$2"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$program" schema --markdown >"$work/tables"
awk -v tables="$work/tables" '
  /^<!-- keys: end -->/ { inside = 0 }
  !inside { print }
  /^<!-- keys: begin -->/ {
    inside = 1
    print ""
    while ((getline line < tables) > 0) print line
    print ""
  }' "$readme" >"$work/readme"
if [ "${3-}" = --write ]; then
  cp "$work/readme" "$readme"
else
  diff -u "$readme" "$work/readme" || { echo "$readme: the tables of keys are stale; './do keys' writes them anew"; exit 1; }
fi
