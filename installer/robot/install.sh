# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Installing: look, take the archive in, switch over, test, confirm. Every step leaves a whole version that can start.

# preflight SETTINGS...: status 0 go on, 1 refused, 5 another installation runs, 10 nothing to do.
preflight() {
  settings "$@"
  lock_alive "$(cat "$home/lock" 2>/dev/null)" &&
    die -5 "another installation is running on this robot (process $(cut -d ' ' -f 1 "$home/lock")); wait until it has ended"
  find_problems
  [ "$problems" = 0 ] || die "nothing was changed"
  say "$(uname -m), kernel $(uname -r), $(free_kb) kB free, serial port $(robot_port), installed: $(version_current)"
  if is_done; then
    say "version $version is installed and confirmed; nothing to do"
    exit 10
  fi
  say "autostart by $(autostart_wanted)$(autostart_notes)"
}

# Is this very build installed and confirmed, and was no later step cut?
is_done() {
  target=$(folder_for "$version" "$manifest")
  [ "$(version_current)" = "$target" ] && [ ! -e "$home/pending" ] && [ ! -e "$home/lock" ] && [ -x "$home/start" ] &&
    whole "$home/versions/$target" && autostart_is "$(autostart_wanted)" &&
    { [ -n "$(robot_setting controller_user)" ] || user_exists "$usual_user"; }
}

# install_bundle SETTINGS... <ARCHIVE
install_bundle() {
  settings "$@"
  lock
  remove_leftovers
  find_problems
  [ "$problems" = 0 ] || die "nothing was changed"
  # Asked now: later steps look for files that these steps make.
  kind=$(autostart_wanted)
  target=$(folder_for "$version" "$manifest")
  if [ "$(version_current)" = "$target" ] && [ ! -e "$home/pending" ] && whole "$home/versions/$target"; then
    finish "$target" "$(version_previous)" "$kind"
    return
  fi
  before=$(version_confirmed)
  [ "$before" != "$target" ] || before=$(version_previous)
  whole "$home/versions/$target" 2>/dev/null || stage "$target"
  switch_to "$target" "$before" "$kind"
}

# stage NAME: stdin, the archive, becomes versions/NAME: checked first, renamed last.
stage() {
  staging=$home/versions/.staging-$$
  mkdir -p "$home/kept" "$staging/unpacked" || undo_stage "cannot make $staging"
  cat >"$staging/archive.tar.gz" || undo_stage "cannot write the archive; is the disk full?"
  check_archive "$staging/archive.tar.gz"
  # -m: the robot's clock may be years behind.
  gzip -dc "$staging/archive.tar.gz" | (cd "$staging/unpacked" && tar -xmof -) || undo_stage "cannot unpack the archive; is the disk full?"
  refuse_strangers "$staging/archive.tar.gz" "$staging/unpacked"
  # Nobody but root may change a program, and none runs with rights that its caller does not have.
  chmod -R a-s,u+rwX,go-w,go+rX "$staging/unpacked" || undo_stage "cannot set the rights of the unpacked files"
  whole "$staging/unpacked" || undo_stage "the unpacked files are not what MANIFEST says; is the disk full or worn?"
  rm -f "$staging/archive.tar.gz"
  # What is there under this name is not whole.
  discard "$1"
  sync
  mv -T "$staging/unpacked" "$home/versions/$1" || undo_stage "cannot rename $staging/unpacked"
  rmdir "$staging"
  sync
}

check_archive() {
  bytes=$(wc -c <"$1" | tr -d ' ')
  [ "$bytes" = "$archive_bytes" ] || undo_stage "the connection ended after $bytes of $archive_bytes bytes"
  if [ "$sha256" != - ] && command -v sha256sum >/dev/null 2>&1; then
    digest=$(sha256sum <"$1" | cut -d ' ' -f 1) wanted=$sha256
  else
    digest=$(cksum <"$1" | cut -d ' ' -f 1) wanted=$cksum
  fi
  [ "$digest" = "$wanted" ] || undo_stage "the archive came in damaged (digest $digest instead of $wanted)"
}

# refuse_strangers ARCHIVE FOLDER: what MANIFEST does not name has no digest, and what is no plain file is none of ours.
refuse_strangers() {
  stranger=$(gzip -dc "$1" | tar -tf - | awk -v manifest="$2/MANIFEST" '
    BEGIN { while ((getline line <manifest) > 0) { sub(/^[0-9]* [0-9]* /, "", line); known[line] = 1 }; known["MANIFEST"] = 1 }
    { sub(/^\.\//, "") } /\/$/ || $0 == "" || $0 == "." { next } !($0 in known) { print; exit }')
  [ -z "$stranger" ] || undo_stage "the archive holds $stranger, which its MANIFEST does not name; make it again with './dev build --robot'"
  stranger=$(cd "$2" && sed 's/^[0-9]* [0-9]* //' MANIFEST | while IFS= read -r path; do
    case /$path/ in */../*) echo "$path" ;; esac
    { [ -f "$path" ] && [ ! -L "$path" ]; } || echo "$path"
  done | sed -n 1p)
  [ -z "$stranger" ] || undo_stage "$stranger in the archive is missing or no plain file; make it again with './dev build --robot'"
}

undo_stage() {
  rm -rf "$staging"
  die "$1; nothing was changed, try again"
}
