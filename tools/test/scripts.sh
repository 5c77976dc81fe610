#!/usr/bin/env bash
# Shell scripts: their syntax, and shellcheck. What runs on a robot has to be POSIX. Patterns of tools/mutate.sh. Rooms
# with threads.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

# A script ends in .sh or begins with a line for a shell. Parts of scripts name their shell in a comment, and use each
# other's variables.
scripts=() parts=()
while read -r script; do
  if grep -qE '^#!.*bash|^# shellcheck shell=bash' "$script"; then
    bash -n "$script"
  else
    for shell in dash 'busybox sh'; do $shell -n "$script"; done
  fi
  if grep -q '^# shellcheck shell=' "$script"; then parts+=("$script"); else scripts+=("$script"); fi
done < <({ sources '*.sh' && sources ':!*.sh' | xargs grep -lE -m 1 '^#!.*[/ ](ba|da)?sh\b'; } | sort -u)
printf '%s\n' "${scripts[@]}" |
  xargs -P "$(nproc)" -n 20 shellcheck --external-sources --source-path=SCRIPTDIR --exclude=SC1091,SC2016
shellcheck --exclude=SC1091,SC2016,SC2034,SC2154 "${parts[@]}"
tools/mutate.sh --list >/dev/null  # a pattern must be in the code that it changes
tools/check_threads.sh
