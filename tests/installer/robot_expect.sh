# shellcheck shell=bash disable=SC2154  # status is set by run_install
# Checks of user-visible results. Each ends the scenario with a message. Sourced by robot.sh.

fail() {
  printf 'installer test: %s\n' "$*" >&2
  exit 1
}

# expect_status CODE...: exit code of the last run_install.
expect_status() {
  local code
  for code; do [ "$status" != "$code" ] || return 0; done
  fail "exit code $status instead of $*"
}

# expect_said PATTERN: an extended regular expression in what the installer printed.
expect_said() { grep -qE -- "$1" "$LAB/out" || fail "the installer did not say: $1"; }
expect_not_said() { ! grep -qE -- "$1" "$LAB/out" || fail "the installer said: $(grep -E -- "$1" "$LAB/out" | head -1)"; }

# A version folder is whole: every file as its MANIFEST says, and no other.
whole() {
  (
    cd "$1" 2>/dev/null || exit 1
    [ -s MANIFEST ] || exit 1
    find . -type f ! -name MANIFEST -printf '%P\0' | sort -z | xargs -0 cksum | cmp -s - MANIFEST
  )
}

# Version printed by the installed program.
program_says() { chroot "$ROBOT" /opt/darwinop/current/bin/darwinop; }

# Prints the version that the robot would run now: whole and really the one; or what is wrong.
version_now() {
  local home=$ROBOT/opt/darwinop link version
  if [ ! -e "$home" ]; then echo none; return; fi
  if [ ! -L "$home/current" ]; then
    if [ -e "$home/current" ]; then echo 'current is not a link'; else echo none; fi
    return
  fi
  link=$(readlink "$home/current")
  whole "$home/$link" || { echo "mixture in $link"; return; }
  version=$(program_says </dev/null 2>&1) || { echo "does not run: $version"; return; }
  case $link/ in "versions/$version"[./]*) ;; *) echo "$version in $link"; return ;; esac
  echo "$version"
}

# expect_version VERSION|none ...: one of these is what runs, and no half-done work is pending.
expect_version() {
  local now wanted
  now=$(version_now)
  for wanted; do [ "$now" != "$wanted" ] || return 0; done
  fail "on the robot runs: $now; expected: $*"
}

expect_confirmed() {
  [ ! -e "$ROBOT/opt/darwinop/pending" ] || fail "the install was not confirmed: pending says $(cat "$ROBOT/opt/darwinop/pending")"
}

# expect_boots VERSION: what a power cycle brings up.
expect_boots() {
  robot_boot
  [ "$booted" = "$1" ] || fail "after a boot runs: ${booted:-nothing}; expected: $1"
}
expect_boots_nothing_of_ours() {
  robot_boot 15
  [ -z "$booted" ] || fail "after a boot runs $booted; nothing of ours should"
}

expect_no_demo() { [ ! -e "$ROBOT/run/demo-started" ] || fail "the ROBOTIS demo was started beside ours"; }

# remember_disk [--touched], expect_same_disk [--touched] SENTENCE
remember_disk() { robot_disk "$@" >"$LAB/disk_before"; }
expect_same_disk() {
  local touched=()
  if [ "$1" = --touched ]; then touched=(--touched); shift; fi
  robot_disk "${touched[@]}" >"$LAB/disk_now"
  cmp -s "$LAB/disk_before" "$LAB/disk_now" ||
    fail "$1; the disk differs: $(diff "$LAB/disk_before" "$LAB/disk_now" | head -20)"
}

# hold_an_install BUNDLE: runs one in the background that is in its self-test now; $held is its process.
hold_an_install() {
  local tries=0
  : >"$ROBOT/run/hold-self-test"
  rm -f "$ROBOT/run/self-test-begun"
  (run_install --bundle "$1"; cp "$LAB/out" "$LAB/held_out"; exit "$status") &
  held=$!
  until [ -e "$ROBOT/run/self-test-begun" ]; do
    [ $((tries += 1)) -lt 500 ] || fail "the install did not come to its self-test"
    sleep 0.02
  done
}
