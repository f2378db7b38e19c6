#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What shells offer for a line that isn't finished: bash always, zsh and fish where they are installed.
# usage: completion_test.sh OROGRAPH
set -euo pipefail
program=$(realpath "$1")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
mkdir -p bin plain folder
ln -s "$program" bin/orograph
export PATH=$scratch/bin:$PATH
touch plain/view.toml plain/report.json plain/dem.tif "plain/my dem.tif"
cd plain
for shell in bash zsh fish; do orograph --completion $shell >"$scratch/orograph.$shell"; done
failures=0
asked=0

# --- one line for each word that a shell offers for "$@", the last word being the one to complete

in_bash() {
  bash --norc -c '
    source "$1"
    line=$2
    read -ra COMP_WORDS <<<"${line//=/ = }"
    [[ $line != *[\ =] ]] || COMP_WORDS+=("")
    COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
    _orograph
    printf "%s\n" "${COMPREPLY[@]}"' bash "$scratch/orograph.bash" "$1"
}

in_zsh() {
  timeout 20 zsh -f "$here/offered_by_zsh.zsh" "$scratch/orograph.zsh" "$1"
}

in_fish() {
  fish --no-config -c 'source $argv[1]; complete -C $argv[2]' "$scratch/orograph.fish" "$1" | cut -f1
}

# expect LINE OFFERED… [-- NOT-OFFERED…]
expect() {
  local line=$1 word wanted=yes
  shift
  $ask "$line" >"$scratch/offered" 2>"$scratch/said" || true
  asked=$((asked + 1))
  for word in "$@"; do
    if [[ $word == -- ]]; then
      wanted=no
    elif grep -qxF -- "$word" "$scratch/offered"; then
      [[ $wanted == yes ]] || { echo "FAILED: $ask '$line' offers $word" && failures=$((failures + 1)); }
    elif [[ $wanted == yes ]]; then
      echo "FAILED: $ask '$line' doesn't offer $word but: $(head -c 600 "$scratch/offered" | tr '\n' ' ')" \
        "$(head -c 300 "$scratch/said")"
      failures=$((failures + 1))
    fi
  done
}

all_shells_alike() {
  expect 'orograph ' render sweep info tin
  expect 'orograph re' render -- sweep
  expect 'orograph render --proj' --projection -- --spacing
  expect 'orograph info --f' --fill-voids -- --fov
  expect 'orograph render --projection o' orthographic oblique -- perspective
  expect 'orograph render --page ' a4 letter
  expect 'orograph render --of p' pdf png -- svg
  expect 'orograph render dem.tif map.svg --device ' hp7475a generic
}

ask=in_bash
all_shells_alike
expect 'orograph render --projection=or' orthographic -- oblique
expect 'orograph render --layers ' profiles contours skyline
expect 'orograph render --layers profiles,sk' profiles,skyline -- profiles,profiles
expect 'orograph render --layers profiles,' profiles,mesh -- profiles,profiles
expect 'orograph render --view ' view.toml report.json -- dem.tif
expect 'orograph render --scene ' view.toml -- report.json
expect 'orograph render ' dem.tif 'my dem.tif'
expect 'orograph render --breaklines d' dem.tif -- view.toml
expect 'orograph render --fov ' -- dem.tif --fov
expect 'orograph render --pitch -' -- --pitch
expect 'orograph sweep --azimuth ' -- dem.tif

if command -v fish >/dev/null; then
  ask=in_fish
  all_shells_alike
  expect 'orograph render --projection=or' --projection=orthographic
  expect 'orograph render --layers profiles,sk' profiles,skyline
  expect 'orograph render --view ' view.toml report.json
  expect 'orograph render ' dem.tif
fi
if command -v zsh >/dev/null; then
  ask=in_zsh
  all_shells_alike
  expect 'orograph render --projection=or' orthographic -- oblique
  expect 'orograph render --layers profiles,sk' skyline -- profiles
  expect 'orograph render --view ' view.toml report.json -- dem.tif
  expect 'orograph render ' dem.tif 'my\ dem.tif'
fi

# The checks see what is missing.
before=$failures
ask=in_bash
expect 'orograph render --proj' --no-such-option >/dev/null
[[ $failures -gt $before ]] || { echo 'FAILED: what is missing passes' && exit 1; }
failures=$before

echo "$asked lines completed"
[[ $failures -eq 0 ]]
