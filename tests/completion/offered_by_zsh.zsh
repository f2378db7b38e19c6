#!/usr/bin/env zsh
# SPDX-License-Identifier: GPL-3.0-or-later
# Prints what zsh offers for a line, each in a line of its own: in an interactive zsh at a terminal
# of its own Tab is pressed, and what its functions hand to the completion system is told.
# usage: offered_by_zsh.zsh COMPLETION LINE   (the file with what `orograph --completion zsh` printed)
zmodload zsh/zpty
zpty shell zsh -f -i
setup=$(mktemp)
trap 'rm -f $setup' EXIT
cat >$setup <<SETUP
autoload -U compinit && compinit -u -d ${(q)1:h}/zcompdump # what all shells after the first read
source ${(q)1}
SETUP
cat >>$setup <<'SETUP'
PROMPT=
bindkey '^I' complete-word
bindkey '^M' undefined
tell-begin() { print -r -- BEGIN }
tell-end() { print -r -- END; exit }
compprefuncs=(tell-begin)
comppostfuncs=(tell-end)
zstyle ':completion:*' insert-tab false
compadd() {
  # Those that only ask what matches.
  if [[ ${@[1,(i)(-|--)]} == *-(O|A|D)\ * ]]; then
    builtin compadd "$@"
    return
  fi
  local -a matches
  builtin compadd -A matches "$@"
  setopt localoptions norcexpandparam
  local match
  for match in $matches; do print -r -- $match; done
  builtin compadd "$@" # so that no further kinds of matches are tried
}
print READY
SETUP
zpty -w shell source $setup
repeat 200; do
  zpty -r shell line && [[ $line == *READY* ]] && break
done
zpty -n -w shell "$2"$'\t'
inside=0
while zpty -r shell line; do
  line=${line//[$'\r\n']/}
  case $line in
    *BEGIN) inside=1 ;;
    END*) exit ;;
    *) ((inside)) && print -r -- $line ;;
  esac
done
exit 0
