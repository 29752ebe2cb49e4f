#!/usr/bin/env bash
# Instructions of each stage, by callgrind, as a table like that of README.md beside this file:
#   count.sh PROGRAM
set -euo pipefail
program=$1
printf '| stage | m = 2 | m = 10 | m = 40 |\n|---|---|---|---|\n'
for stage in symbolic first-value value frame compiled-value compiled-frame batch-line; do
  printf '| %s |' "$stage"
  for m in 2 10 40; do
    count=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect=counted \
      "$program" "$stage" "$m" 2>&1 | sed -n 's/.*Collected : \([0-9]*\).*/\1/p')
    awk -v n="$count" 'BEGIN { n /= 10000; printf n < 10 ? " %.3f |" : " %.1f |", n }'
  done
  echo
done
