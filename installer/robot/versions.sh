# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Installed versions: current, previous, complete.

# Name of the version that `current` points to, or -.
version_current() {
  link=$(readlink "$home/current" 2>/dev/null) || link=
  if [ -n "$link" ] && [ -d "$home/$link" ]; then echo "${link#versions/}"; else echo -; fi
}

# Version started by the next boot, which is never an unconfirmed one.
version_confirmed() {
  if [ -s "$home/pending" ]; then cat "$home/pending"; else version_current; fi
}

# Target version of --rollback, or -.
version_previous() {
  before=$(cat "$home/previous" 2>/dev/null) || before=
  if [ -n "$before" ] && [ "$before" != "$(version_current)" ] && [ -d "$home/versions/$before" ]; then
    echo "$before"
  else
    echo -
  fi
}

manifest_of() { cksum <"$1/MANIFEST" 2>/dev/null | tr ' ' '-'; }

# folder_for VERSION MANIFEST: folder name below versions/. Another build of the same version gets another name, so that
# the running one stays complete. The underscore ends the version for `compare`.
folder_for() {
  if [ -d "$home/versions/$1" ] && [ "$(manifest_of "$home/versions/$1")" != "$2" ]; then
    echo "$1_${2%%-*}"
  else
    echo "$1"
  fi
}

# whole FOLDER: true if every file matches MANIFEST.
whole() {
  [ -s "$1/MANIFEST" ] && (
    cd "$1" || exit
    sed 's/^[0-9]* [0-9]* //' MANIFEST | while IFS= read -r path; do cksum "$path"; done 2>/dev/null | cmp -s - MANIFEST
  )
}

# What a killed installation has left, in kB: remove_leftovers gives it back.
leftover_kb() { du -s -k "$home"/versions/.staging-* 2>/dev/null | awk '{ kb += $1 } END { print kb + 0 }'; }

# Removes leftovers of a killed installation. Requires the lock.
remove_leftovers() {
  rm -rf "$home"/versions/.staging-*
  rm -f "$home"/*.new-[0-9]* "$home"/lock.dead-* "$home"/kept/*.new-[0-9]* "$home/.current-start"
  autostart_leftovers
}

# discard VERSION: renames atomically, then removes.
discard() {
  [ -d "$home/versions/$1" ] || return 0
  mv -T "$home/versions/$1" "$home/versions/.staging-$$-$1" && rm -rf "$home/versions/.staging-$$-$1"
}

# Removes all versions except these two.
discard_others() {
  for other in "$home"/versions/*; do
    other=${other##*/}
    case $other in "$1" | "$2" | '*') ;; *) discard "$other" ;; esac
  done
}
