#!/bin/sh
# Says which test files the CMakeLists.txt above them doesn't name: those aren't built. `built.sh ROOT`.
set -eu
cd "$1/tests"
found=$(mktemp)
trap 'rm -f "$found"' EXIT
find . -name '*_test.cpp' | while read -r file; do
  folder=$(dirname "$file")
  while [ ! -e "$folder/CMakeLists.txt" ]; do folder=$(dirname "$folder"); done
  grep -qF "${file#"$folder"/}" "$folder/CMakeLists.txt" || echo "$folder/CMakeLists.txt doesn't name ${file#"$folder"/}"
done >"$found"
cat "$found"
[ ! -s "$found" ]
