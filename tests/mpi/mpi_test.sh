#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A sweep drawn by several processes under MPI: the same files as by one.
# usage: tests/mpi/mpi_test.sh OROGRAPH SOURCE_DIR
set -euo pipefail
program=$1 root=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# Open MPI wants to be told that it may run as root, that there are more processes than cores, and
# that none is elsewhere.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_plm=isolated OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_btl_vader_single_copy_mechanism=none

failures=0
fail() {
  echo "FAILED: $1"
  failures=$((failures + 1))
}

# sweep RANKS OUT_DIR OPTION…: exit code in $code, what was said in $scratch/said.
sweep() {
  local ranks=$1 out=$2
  shift 2
  code=0
  timeout 100 mpirun -n "$ranks" "$program" sweep "$root/data_samples/islands.tif" "$out" --quiet \
    --no-seconds --page a6 "$@" >"$scratch/said" 2>&1 </dev/null || code=$?
}
# As often as it is said: once, however many processes there are.
expect_once() {
  [[ $(grep -c "orograph: error: .*$1" "$scratch/said") -eq 1 ]] ||
    fail "not said once: $1: $(cat "$scratch/said")"
}

views=(--azimuth 0:360:30 --elevation 10,40)
"$program" sweep "$root/data_samples/islands.tif" "$scratch/alone" --quiet --no-seconds --page a6 \
  "${views[@]}" -j 1
[[ $(find "$scratch/alone" -name '*.svg' | wc -l) -eq 24 ]] || fail "not 24 drawings"

for ranks in 2 4; do
  sweep "$ranks" "$scratch/ranks-$ranks" "${views[@]}"
  [[ $code -eq 0 ]] || fail "$ranks ranks: exit code $code: $(cat "$scratch/said")"
  diff -r "$scratch/alone" "$scratch/ranks-$ranks" || fail "$ranks ranks: other files"
done
sweep 2 "$scratch/threads" "${views[@]}" -j 3
diff -r "$scratch/alone" "$scratch/threads" || fail "2 ranks of 3 threads: other files"

# A process that is killed ends all; what was finished stays. It is killed once some views are drawn:
# a process that is killed while it starts makes mpirun itself wait for ever, once in a hundred times.
drawn=2
timeout 100 mpirun -n 3 "$program" sweep "$root/data_samples/islands.tif" "$scratch/killed" \
  --quiet --no-seconds --page a6 "${views[@]}" >"$scratch/said" 2>&1 </dev/null &
timeout_id=$!
while kill -0 "$timeout_id" 2>/dev/null &&
  [[ $(find "$scratch/killed" -name '*.svg' 2>/dev/null | wc -l) -lt $drawn ]]; do
  sleep 0.01
done
victim=$(pgrep -P "$(pgrep -P "$timeout_id")" -n orograph) && kill -9 "$victim" ||
  fail "nothing to kill after $drawn drawings"
code=0
wait "$timeout_id" || code=$?
[[ $code -ne 0 && $code -ne 124 ]] || fail "a process killed: exit code $code"
sweep 2 "$scratch/killed" "${views[@]}" --resume
[[ $code -eq 0 ]] || fail "resumed: exit code $code: $(cat "$scratch/said")"
diff -r "$scratch/alone" "$scratch/killed" || fail "resumed: other files"

# One line, whichever processes fail.
sweep 3 "$scratch/alone" "${views[@]}"
[[ $code -ne 0 ]] || fail "a sweep over a sweep passes"
expect_once "holds this sweep already"
sweep 3 "$scratch/none" --azimuth 0:10:0
expect_once "its step is zero"
touch "$scratch/file"
sweep 3 "$scratch/file" "${views[@]}"
expect_once "is no folder"
sweep 2 "$scratch/failing" --eye 509000,103000 --fov 40 --look-azimuth 0 --pitch 0,90
[[ $code -ne 0 ]] || fail "a failed view passes"
expect_once "views failed"

[[ $failures -eq 0 ]]
