#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The pages for readers tell the truth: their `orograph` commands work as they stand, their links
# lead somewhere, the files that they name are there, and every figure drawn is shown.
# usage: readme_test.sh OROGRAPH
set -euo pipefail
program=$(realpath "$1")
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0
fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# Commands in ```sh blocks of a page, one a line, continued lines joined.
commands_in() {
  awk '
    /^```/ { inside = ($0 == "```sh"); next }
    !inside { next }
    /\\$/ { sub(/\\$/, ""); joined = joined $0; next }
    { print joined $0; joined = "" }' "$1"
}

# Runs a page's commands in one folder, one after the other, as a reader would; those of other
# programs (installing, projecting) are left out.
ran=0
run_page() {
  local folder=$scratch/page command
  rm -rf "$folder"
  mkdir -p "$folder/bin"
  ln -s "$program" "$folder/bin/orograph"
  ln -s "$root/data_samples" "$folder/data_samples"
  ln -s "$root/data_samples/jacksboro.tif" "$folder/dem.tif" # the reader's own
  for tile in north south; do ln -s "$root/data_samples/jacksboro.tif" "$folder/$tile.tif"; done
  while IFS= read -r command; do
    [[ $command == orograph\ * ]] || continue
    ran=$((ran + 1))
    (cd "$folder" && PATH=$folder/bin:$PATH bash -e -o pipefail -c "$command") \
      >"$scratch/said" 2>&1 </dev/null ||
      fail "$1: $command: $(cat "$scratch/said")"
  done < <(commands_in "$1")
}

# Targets of a page's links and pictures that are files of ours.
links_in() {
  grep -o '](\([^)]*\))' "$1" | sed 's/^](//; s/)$//; s/#.*//' | grep -v '^\(https\{0,1\}:.*\)\{0,1\}$' || true
}

# Files and folders of ours that a page names in `code`.
paths_in() {
  grep -o '`[a-z_]\+/[A-Za-z0-9_./-]*`' "$1" | tr -d '`' | grep -v '^build/' || true
}

pages=("$root/README.md" "$root/CHANGELOG.md" "$root"/docs/*.md "$root"/docs/decisions/*.md)
for page in "${pages[@]}"; do
  run_page "$page"
  while IFS= read -r link; do
    [[ -z $link || -e ${page%/*}/$link ]] || fail "$page: $link isn't there"
    [[ $link != *figures/* ]] || echo "${link##*/}" >>"$scratch/shown"
  done < <(links_in "$page")
  while IFS= read -r path; do # a program is named without its extension
    [[ ! -d $root/${path%%/*} || -e $root/$path || -e $root/$path.cpp ]] ||
      fail "$page: $path isn't there"
  done < <(paths_in "$page")
done
[[ $ran -ge 5 ]] || fail "README.md shows $ran commands: the test has lost them"

for figure in "$root"/docs/figures/*; do
  name=${figure##*/}
  grep -qx "$name" "$scratch/shown" || fail "$name is on no page: leave it out of scripts/figures"
  [[ $(stat -c %s "$figure") -le 600000 ]] || fail "$name has more than 600 kB"
done

# The checks see what is wrong.
mkdir "$scratch/wrong"
printf '```sh\norograph render dem.tif \\\n  wrong.svg --no-such-option\nls\n```\n[x](nowhere.md) `docs/nowhere.md`\n' \
  >"$scratch/wrong/page.md"
before=$failures
run_page "$scratch/wrong/page.md" >/dev/null
seen=$((failures - before))
failures=$before
[[ $seen -eq 1 ]] || fail "a wrong command passes"
[[ $(links_in "$scratch/wrong/page.md") == nowhere.md ]] || fail "a link isn't found"
[[ $(paths_in "$scratch/wrong/page.md") == docs/nowhere.md ]] || fail "a path isn't found"

echo "$ran commands ran"
[[ $failures -eq 0 ]]
