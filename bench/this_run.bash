# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash disable=SC2034
# What measurements are stamped with. Sourced by scripts that stand in the project's folder.

# name_this_run PATH…: sets `commit` (with a + where one of the paths differs from it), `machine`,
# and `machine_name`, which may stand in the name of a file.
name_this_run() {
  commit=$(git rev-parse --short HEAD)
  git diff --quiet HEAD -- "$@" || commit+=+ # not quite that commit
  machine=$(awk -F ': ' '/^model name/ { print $2; exit }' /proc/cpuinfo)
  machine="${machine:-$(uname -m)} ($(nproc) cores)"
  machine_name=$(tr '[:upper:]' '[:lower:]' <<<"$machine" | tr -cs 'a-z0-9\n' - | sed 's/-$//')
}

# median COLUMN FILE
median() { cut -d' ' -f"$1" "$2" | sort -g | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }
