#!/usr/bin/env bash
# /etc/rc.local as robots have it, in every odd form: started by it, the ROBOTIS demo silenced, and given back byte for byte.
. "$(dirname "$(readlink -f "$0")")/robot.sh"

demo=/darwin/Linux/project/demo/demo
rc_local() { echo "$ROBOT/etc/rc.local"; }
fingerprint() { if [ -e "$(rc_local)" ]; then stat -c '%a %U:%G' "$(rc_local)"; cksum <"$(rc_local)"; else echo absent; fi; }

# run_rc_local: as init scripts do that name the shell; $booted is what it started.
run_rc_local() {
  local tries=0
  robot_kill_sessions
  rm -f "$ROBOT/run/"{booted,demo-started,fake-supervisor.pid}
  timeout 20 chroot "$ROBOT" /bin/sh -e /etc/rc.local </dev/null >>"$LAB/boot.log" 2>&1 || true
  until [ -s "$ROBOT/run/booted" ] || [ $((tries += 1)) -ge 100 ]; do sleep 0.02; done
  booted=$(cat "$ROBOT/run/booted" 2>/dev/null || true)
}

# odd_rc_local [--boot-too] [--upgrade-too]: stdin is /etc/rc.local. Everything that must hold for it.
odd_rc_local() {
  cat >"$(rc_local)"
  chmod "${mode:-755}" "$(rc_local)"
  life_of_rc_local "$@"
}

life_of_rc_local() {
  local v1 before after; v1=$(fake_bundle 0.1.0+a)
  before=$(fingerprint)
  remember_disk
  run_install --bundle "$v1"
  expect_status 0
  { echo "--- rc.local now:"; cat -A "$(rc_local)"; } >>"$LAB/history"
  [ -x "$(rc_local)" ] || fail "rc.local is not executable, so no boot would run it"
  run_rc_local
  [ "$booted" = 0.1.0+a ] || fail "sh -e /etc/rc.local started: ${booted:-nothing}"
  expect_no_demo
  if [[ " $* " = *" --boot-too "* ]]; then expect_boots 0.1.0+a; expect_no_demo; fi
  after=$(fingerprint)
  run_install --bundle "$v1"
  expect_status 0
  [ "$(fingerprint)" = "$after" ] || fail "the second install changed rc.local"
  if [[ " $* " = *" --upgrade-too "* ]]; then upgrade_keeps_rc_local "$after"; fi
  run_install --uninstall
  expect_status 0
  robot_quiet
  [ "$(fingerprint)" = "$before" ] || fail "uninstall gave back: $(fingerprint); it was: $before"
  expect_same_disk "uninstall did not bring the disk back"
}

upgrade_keeps_rc_local() {
  run_install --bundle "$(fake_bundle 0.2.0+b)"
  expect_status 0
  [ "$(fingerprint)" = "$1" ] || fail "the upgrade changed rc.local: $(cat -A "$(rc_local)")"
  run_rc_local
  [ "$booted" = 0.2.0+b ] || fail "after the upgrade sh -e /etc/rc.local started: ${booted:-nothing}"
}

scenario_stock() { odd_rc_local --boot-too --upgrade-too <<<$'#!/bin/sh -e\n# rc.local\n'"$demo"$'\nexit 0'; }
scenario_demo_in_the_background() { odd_rc_local --boot-too <<<$'#!/bin/sh -e\n'"$demo"$' &\nexit 0'; }
scenario_demo_with_arguments_and_blanks() { odd_rc_local --boot-too <<<$'#!/bin/sh -e\n\t '"$demo"$' -x >/dev/null 2>&1 &\nexit 0'; }
scenario_demo_after_cd() { odd_rc_local --boot-too <<<$'#!/bin/sh -e\ncd /darwin/Linux/project/demo && '"$demo"$'\nexit 0'; }
scenario_demo_inside_an_if() {
  odd_rc_local --boot-too <<<$'#!/bin/sh -e\nif [ -x '"$demo"$' ]; then\n  '"$demo"$'\nfi\nexit 0'
}
scenario_demo_inside_an_if_with_else() {
  odd_rc_local --boot-too <<<$'#!/bin/sh\nif true; then\n'"$demo"$' &\nelse\n'"$demo"$'\nfi'
}
# As Webots' own installation writes it: of 2013, and for the OP2.
webots_default() {
  mkdir -p "$ROBOT$1"
  cp -p "$ROBOT$demo" "$ROBOT$1/default"
}
scenario_default_controller_of_webots_2013() {
  webots_default /darwin/Linux/project/webots
  odd_rc_local --boot-too --upgrade-too <<<$'#!/bin/sh -e\n/darwin/Linux/project/webots/default\nexit 0'
}
scenario_default_controller_of_webots_for_the_op2() {
  webots_default /robotis/Linux/project/webots
  odd_rc_local --boot-too <<<$'#!/bin/sh -e\nif [ -d /robotis ]; then\n  cd /robotis/Linux/project/webots && ./default || /darwin/Linux/project/webots/default\nfi\nexit 0'
}
scenario_no_newline_at_the_end() { odd_rc_local --boot-too < <(printf '#!/bin/sh -e\n%s\nexit 0' "$demo"); }
scenario_demo_is_the_last_line_without_newline() { odd_rc_local --boot-too < <(printf '#!/bin/sh -e\n%s' "$demo"); }
scenario_only_the_first_line_without_newline() { odd_rc_local --boot-too < <(printf '#!/bin/sh -e'); }
scenario_exit_in_the_middle() { odd_rc_local --boot-too <<<$'#!/bin/sh -e\necho before\nexit 0\n'"$demo"$'\nexit 0'; }
scenario_a_command_that_fails_first() { odd_rc_local --boot-too <<<$'#!/bin/sh -e\nfalse\n'"$demo"$'\nexit 0'; }
scenario_spaces_and_tabs() { odd_rc_local --boot-too <<<$'#! /bin/sh  -e\n\n\t  \n   '"$demo"$'   \n\n  exit   0  \n\n\n'; }
scenario_absent() { rm "$(rc_local)"; life_of_rc_local --boot-too --upgrade-too; }
scenario_empty() { odd_rc_local --boot-too </dev/null; }
scenario_not_executable() { mode=644 odd_rc_local --boot-too --upgrade-too <<<$'#!/bin/sh -e\n'"$demo"$'\nexit 0'; }
scenario_private_mode() { mode=700 odd_rc_local --boot-too <<<$'#!/bin/sh -e\nexit 0'; }
scenario_other_owner_and_writable_for_its_group() {
  printf '#!/bin/sh -e\nexit 0\n' >"$(rc_local)"
  chmod 775 "$(rc_local)"
  chown 1000:20 "$(rc_local)"
  life_of_rc_local --boot-too
}
scenario_no_interpreter_line() { odd_rc_local --boot-too <<<"$demo"$'\nexit 0'; }
scenario_windows_line_ends() { odd_rc_local --boot-too --upgrade-too < <(printf '#!/bin/sh -e\r\n%s\r\nexit 0\r\n' "$demo"); }
scenario_bytes_that_are_not_utf8() { odd_rc_local --boot-too < <(printf '#!/bin/sh -e\n# Gr\374\337e \200\377 %%s \\n $HOME `x` "\n%s\nexit 0\n' "$demo"); }
scenario_long_comment_and_here_document() {
  odd_rc_local --boot-too < <(printf '#!/bin/sh -e\n# %05000d\ncat <<END >/dev/null\ntext\nEND\nexit 0\n' 7)
}

scenario_other_lines_still_run() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  printf '%s\n' '#!/bin/sh -e' 'echo first >>/run/mine' "$demo" 'echo "second & third" >>/run/mine' 'exit 0' >"$(rc_local)"
  run_install --bundle "$v1"
  rm -f "$ROBOT/run/mine"
  run_rc_local
  [ "$(cat "$ROBOT/run/mine")" = $'first\nsecond & third' ] || fail "own lines of rc.local did not run"
}

scenario_a_comment_about_the_demo_stays() {
  printf '%s\n' '#!/bin/sh -e' "# $demo" 'exit 0' >"$(rc_local)"
  run_install --bundle "$(fake_bundle 0.1.0+a)"
  expect_status 0
  grep -qx "# $demo" "$(rc_local)" || fail "a comment was changed"
}

scenario_own_edits_survive_uninstall() {
  printf '%s\n' '#!/bin/sh -e' "$demo" 'exit 0' >"$(rc_local)"
  run_install --bundle "$(fake_bundle 0.1.0+a)"
  sed -i 's/^exit 0/echo mine\nexit 0/' "$(rc_local)"
  run_install --uninstall
  expect_status 0
  expect_said 'rc\.local'
  printf '%s\n' '#!/bin/sh -e' "$demo" 'echo mine' 'exit 0' | cmp -s - "$(rc_local)" ||
    fail "uninstall left: $(cat -A "$(rc_local)")"
  [ ! -e "$ROBOT/opt/darwinop" ] || fail "uninstall left /opt/darwinop"
}

scenario_own_edits_survive_an_upgrade() {
  run_install --bundle "$(fake_bundle 0.1.0+a)"
  echo '# mine' >>"$(rc_local)"
  run_install --bundle "$(fake_bundle 0.2.0+b)"
  expect_status 0
  grep -qx '# mine' "$(rc_local)" || fail "the upgrade threw an own line away"
  [ "$(grep -c '/opt/darwinop/start' "$(rc_local)")" -ge 1 ] || fail "the upgrade lost the block"
  expect_boots 0.2.0+b
}

scenario_block_taken_out_by_hand_comes_back_with_the_next_install() {
  run_install --bundle "$(fake_bundle 0.1.0+a)"
  printf '#!/bin/sh -e\nexit 0\n' >"$(rc_local)"
  run_install --bundle "$(fake_bundle 0.2.0+b)"
  expect_status 0
  expect_boots 0.2.0+b
  run_install --uninstall
  expect_status 0
  printf '#!/bin/sh -e\nexit 0\n' | cmp -s - "$(rc_local)" || fail "uninstall left: $(cat -A "$(rc_local)")"
}

with_systemd() {
  mkdir -p "$ROBOT/run/systemd/system" "$ROBOT/etc/systemd/system/multi-user.target.wants"
  printf '#!/bin/sh\necho "systemctl $*" >>/run/systemctl-calls\n' >"$ROBOT/bin/systemctl"
  chmod 755 "$ROBOT/bin/systemctl"
}

scenario_systemd_robot() {
  local v1 v2; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  with_systemd
  remember_disk
  cp "$(rc_local)" "$LAB/rc.local"
  run_install --bundle "$v1"
  expect_status 0
  [ -e "$ROBOT/etc/systemd/system/darwinop.service" ] || fail "there is no unit"
  cmp -s "$(rc_local)" "$LAB/rc.local" || cat -A "$(rc_local)"
  expect_boots 0.1.0+a
  run_install --bundle "$v2"
  expect_status 0
  expect_boots 0.2.0+b
  run_install --uninstall
  expect_status 0
  robot_quiet
  expect_same_disk "uninstall did not bring the disk back"
}

# The unit's start would fail beside it, again and again.
scenario_a_supervisor_of_rc_local_is_ended_before_a_unit_starts_one() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  with_systemd
  run_install --autostart rc.local --bundle "$v1"
  expect_status 0
  run_rc_local
  [ "$booted" = 0.1.0+a ] || fail "no supervisor runs"
  run_install --autostart systemd --bundle "$v1"
  expect_status 0
  grep -q restart "$ROBOT/run/systemctl-calls" || fail "the unit was not started"
  [ ! -e "$ROBOT/run/fake-supervisor.pid" ] || fail "the unit was started beside a supervisor"
}

scenario_an_autostart_that_was_switched_off_is_announced() {
  local v1 v2; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  with_systemd
  run_install --bundle "$v1"
  expect_not_said "$msg_autostart_again"
  rm "$ROBOT/etc/systemd/system/multi-user.target.wants/darwinop.service"  # systemctl disable
  run_install --dry-run --bundle "$v2"
  expect_status 0
  expect_said "$msg_autostart_again"
}

scenario_autostart_none_then_rc_local() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  cp -p "$(rc_local)" "$LAB/rc.local"
  run_install --autostart none --bundle "$v1"
  expect_status 0
  expect_version 0.1.0+a
  cmp -s "$(rc_local)" "$LAB/rc.local" || fail "--autostart none changed rc.local"
  expect_boots_nothing_of_ours
  run_install --autostart rc.local --bundle "$v1"
  expect_status 0
  expect_boots 0.1.0+a
}

run_scenarios "$@"
