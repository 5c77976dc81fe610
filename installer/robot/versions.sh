# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Which versions lie on the robot, which one runs, which one would come back.

# Name of the version that `current` points to, or -.
version_current() {
  link=$(readlink "$home/current" 2>/dev/null) || link=
  if [ -n "$link" ] && [ -d "$home/$link" ]; then echo "${link#versions/}"; else echo -; fi
}

# The version that the next boot would start: an unconfirmed one does not count.
version_confirmed() {
  if [ -s "$home/pending" ]; then cat "$home/pending"; else version_current; fi
}

# The version that --rollback goes to, or -.
version_previous() {
  before=$(cat "$home/previous" 2>/dev/null) || before=
  if [ -n "$before" ] && [ "$before" != "$(version_current)" ] && [ -d "$home/versions/$before" ]; then
    echo "$before"
  else
    echo -
  fi
}

manifest_of() { cksum <"$1/MANIFEST" 2>/dev/null | tr ' ' '-'; }

# folder_for VERSION MANIFEST: its name below versions/. Another build of the same version gets a name of its own, so
# that the one that runs stays whole.
folder_for() {
  if [ -d "$home/versions/$1" ] && [ "$(manifest_of "$home/versions/$1")" != "$2" ]; then
    echo "$1.${2%%-*}"
  else
    echo "$1"
  fi
}

# whole FOLDER: is every file as MANIFEST says?
whole() {
  [ -s "$1/MANIFEST" ] && (
    cd "$1" || exit
    sed 's/^[0-9]* [0-9]* //' MANIFEST | while IFS= read -r path; do cksum "$path"; done 2>/dev/null | cmp -s - MANIFEST
  )
}

# What an installation that was killed leaves. Only under the lock.
remove_leftovers() {
  rm -rf "$home"/versions/.staging-*
  rm -f "$home"/*.new-[0-9]* "$home"/lock.dead-* "$home"/kept/*.new-[0-9]* "$home/.current-start"
  autostart_leftovers
}

# discard VERSION: out of sight in one step, then file by file.
discard() {
  [ -d "$home/versions/$1" ] || return 0
  mv -T "$home/versions/$1" "$home/versions/.staging-$$-$1" && rm -rf "$home/versions/.staging-$$-$1"
}

# All versions but these two.
discard_others() {
  for other in "$home"/versions/*; do
    other=${other##*/}
    case $other in "$1" | "$2" | '*') ;; *) discard "$other" ;; esac
  done
}
