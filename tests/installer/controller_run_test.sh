#!/usr/bin/env bash
# Sending, running, stopping and making default of controllers, on a robot with a runtime of shell scripts. The
# controllers are small programs for the robot's processor, without our library.
# shellcheck disable=SC2154  # controller_lab.sh and robot.sh set what is read here
. "$(dirname "$(readlink -f "$0")")/controller_lab.sh"

scenario_without_a_runtime_it_says_to_install_first() {
  rm -rf "$ROBOT/opt/darwinop"
  controller walker 'return 0;'
  run_install --controller "$LAB/pc/walker" --run
  expect_status 1
  expect_said "$msg_install_first"
  [ ! -e "$ROBOT/opt/darwinop" ] || fail "the robot was changed"
}

scenario_program_and_data_arrive_and_nothing_else() {
  controller walker 'return 0;'
  mkdir -p "$LAB/pc/walker/Töne und mehr" "$LAB/pc/walker/.git" "$LAB/pc/walker/build" "$LAB/pc/walker/motions"
  echo hello >"$LAB/pc/walker/Töne und mehr/a b.wav"
  echo shared >"$LAB/pc/walker/motions/shared.motion"
  ln -s motions/shared.motion "$LAB/pc/walker/linked.motion"
  ln -s "$LAB/pc/elsewhere.hpp" "$LAB/pc/walker/elsewhere.hpp"  # a source: not sent
  : >"$LAB/pc/elsewhere.hpp"
  touch "$LAB/pc/walker/"{.git/config,build/old,walker.cpp~,helper.hpp,-odd.txt}
  run_install --controller "$LAB/pc/walker"
  expect_status 0
  (cd "$ROBOT/opt/darwinop/controllers/walker" && find . -type f | sort) >"$LAB/arrived"
  printf '%s\n' ./-odd.txt './Töne und mehr/a b.wav' ./config.ini ./linked.motion ./motions/shared.motion ./walker | sort | diff - "$LAB/arrived" ||
    fail "other files arrived than expected"
  [ "$(cat "$ROBOT/opt/darwinop/controllers/walker/linked.motion")" = shared ] || fail "a link was not followed"
  [ -z "$(find "$ROBOT/opt/darwinop/controllers/walker/" ! -user root -o -perm /022)" ] || fail "wrong permissions or owner"
  (cd "$LAB/pc/walker" && [ "$(find . -name '*.o' -o -name walker)" = "" ]) || fail "the build changed the source folder"
}

scenario_a_controller_for_another_computer_is_refused() {
  controller walker 'return 0;'
  echo aarch64 >"$ROBOT/opt/darwinop/current/ARCHITECTURE"
  run_install --controller "$LAB/pc/walker"
  expect_status 1
  expect_said "walker was built for i686, but .* aarch64: run '\./dev build --robot=aarch64'"
  [ ! -e "$ROBOT/opt/darwinop/controllers/walker" ] || fail "it was sent all the same"
}

scenario_of_several_libraries_the_one_for_the_robots_version_is_used() {
  local copy=$LAB/copy
  unset DARWINOP_ROBOT_SDK
  rm -rf "$copy"
  mkdir -p "$copy/build/robot" "$copy/build/robot-aarch64"
  cp -r "$SOURCE/installer" "$SOURCE"/rc.local.template "$copy/"
  cp -r "$LAB/sdk" "$copy/build/robot/"
  cp -r "$LAB/sdk" "$copy/build/robot-aarch64/"
  echo 'ROBOT_ARCHITECTURE := aarch64' >>"$copy/build/robot-aarch64/sdk/share/darwinop/robot-toolchain.mk"
  installer=$copy/installer/darwinop-install
  controller walker 'return 0;'
  run_install --controller "$LAB/pc/walker"
  expect_status 0
  expect_said '\(i686\)'
  echo aarch64 >"$ROBOT/opt/darwinop/current/ARCHITECTURE"
  run_install --controller "$LAB/pc/walker"
  expect_said '\(aarch64\)'
  echo armhf >"$ROBOT/opt/darwinop/current/ARCHITECTURE"
  run_install --controller "$LAB/pc/walker"
  expect_status 1
  expect_said "$msg_not_built armhf: .*--robot=armhf"
}

scenario_a_link_out_of_the_folder_is_refused() {
  controller linker 'return 0;'
  echo secret >"$LAB/pc/home/.ssh/id_robot"
  mkdir "$LAB/pc/linker/sounds"
  ln -s "$LAB/pc/home/.ssh" "$LAB/pc/linker/sounds/more"
  run_install --controller "$LAB/pc/linker"
  expect_status 1
  expect_said "linker/sounds/more/.* $msg_link_out, to .*/\.ssh/"
  [ ! -e "$ROBOT/opt/darwinop/controllers" ] || fail "something was sent"
}

scenario_setuid_does_not_travel_and_private_files_stay_private() {
  controller keeper 'return 0;'
  cp /bin/true "$LAB/pc/keeper/helper"
  chmod 6755 "$LAB/pc/keeper/helper"
  echo secret >"$LAB/pc/keeper/key.txt"
  chmod 600 "$LAB/pc/keeper/key.txt"
  run_install --controller "$LAB/pc/keeper"
  expect_status 0
  local there=$ROBOT/opt/darwinop/controllers/keeper
  [ "$(stat -c %a "$there/helper")" = 755 ] || fail "the helper's mode is $(stat -c %a "$there/helper")"
  [ "$(stat -c %a "$there/key.txt")" = 600 ] || fail "a private file became readable: $(stat -c %a "$there/key.txt")"
}

scenario_a_controllers_files_are_its_users_and_its_name_is_still_roots() {
  echo 'darwinop:x:998:997::/nonexistent:/bin/false' >>"$ROBOT/etc/passwd"
  echo 'darwinop:x:997:' >>"$ROBOT/etc/group"
  controller walker 'return 0;'
  run_install --controller "$LAB/pc/walker"
  expect_status 0
  local there=$ROBOT/opt/darwinop/controllers
  [ -z "$(find "$there/walker/" ! -uid 998 -o ! -gid 997)" ] || fail "it cannot write its own files"
  [ "$(stat -c %u:%a "$there" "$there"/.sent-*)" = $'0:755\n0:755' ] || fail "it can replace its own program"
}

scenario_controllers_of_an_older_version_get_the_user_when_a_new_one_comes() {
  controller walker 'return 0;'
  run_install --controller "$LAB/pc/walker"
  local there=$ROBOT/opt/darwinop/controllers
  [ "$(stat -L -c %u "$there/walker")" = 0 ] || fail "there is a user already"
  run_install --bundle "$(fake_bundle 0.2.0+b)"
  expect_status 0
  [ "$(stat -L -c %U "$there/walker/config.ini")" = "$(stat -L -c %U "$there/walker")" ] || fail "some files have another owner"
  [ "$(stat -L -c %u "$there/walker")" != 0 ] || fail "it still belongs to root"
  [ "$(stat -c %a "$there"/.sent-*)" = 755 ] || fail "the folder is not readable"
}

scenario_names_that_the_installer_needs_itself_are_free() {
  local name
  for name in walker.new-1 archive walker.by-hand-1; do
    controller "$name" 'puts("it runs"); return 0;'
    run_install --controller "$LAB/pc/$name"
    expect_status 0
    # Cleanup by another transfer must not remove it.
    controller other 'return 0;'
    run_install --controller "$LAB/pc/other"
    [ "$(chroot "$ROBOT" "/opt/darwinop/controllers/$name/$name")" = "it runs" ] || fail "$name is gone"
  done
}

scenario_a_folder_with_blanks_and_umlauts_runs() {
  controller "Mein Läufer" 'puts("it runs"); return 0;'
  run_install --controller "$LAB/pc/Mein Läufer" --run
  expect_status 0
  expect_said '^it runs$'
}

scenario_output_arguments_and_status_come_back() {
  controller walker 'for (int i = 1; i < argc; i++) printf("<%s>\n", argv[i]); fputs("this is stderr\n", stderr); return 42;'
  start_install --controller "$LAB/pc/walker" --run "$login@$ADDRESS" -- 'a b' "it's" '' '$HOME' '*' --stop
  wait_install
  expect_status 42
  printf '%s\n' '<a b>' "<it's>" '<>' '<$HOME>' '<*>' '<--stop>' | diff - "$LAB/stdout" || fail "arguments or output changed on the way"
  grep -q '^this is stderr$' "$LAB/stderr" || fail "stderr did not come on stderr"
}

scenario_a_crash_is_described() {
  controller walker 'raise(SIGSEGV); return 0;'
  run_install --controller "$LAB/pc/walker" --run
  expect_status 139
  expect_said 'walker crashed: invalid memory access'
}

scenario_output_comes_live_and_ctrl_c_ends_it_normally() {
  controller walker "$until_stopped"
  start_install --controller "$LAB/pc/walker" --run "$login@$ADDRESS"
  wait_for "$LAB/stdout" '^walking$'
  kill -INT -- "-$install_pid"
  wait_for "$LAB/stdout" '^kneeling$'
  kill -INT -- "-$install_pid"
  wait_install
  expect_status 7
  grep -q '^done$' "$LAB/stdout" || fail "the second Ctrl-C interrupted the end of the controller"
  grep -q "$msg_being_stopped" "$LAB/stderr" || fail "no message for the second Ctrl-C"
  robot_quiet
}

scenario_a_killed_installer_stops_the_controller() {
  controller walker "$until_stopped"
  start_install --controller "$LAB/pc/walker" --run "$login@$ADDRESS"
  wait_for "$LAB/stdout" '^walking$'
  kill -KILL "$install_pid"
  wait_install
  wait_for "$ROBOT/tmp/ended" "^done$"
  robot_quiet
}

scenario_a_link_that_falls_silent_stops_the_controller() {
  controller walker "$until_stopped"
  start_install --controller "$LAB/pc/walker" --run "$login@$ADDRESS"
  wait_for "$LAB/stdout" '^walking$'
  local begun=$SECONDS
  silence_link
  wait_for "$ROBOT/tmp/ended" "^done$" 20
  [ $((SECONDS - begun)) -ge 8 ] || fail "stopped after $((SECONDS - begun)) s: a short WLAN interruption would suffice"
  wait_install
  expect_status 255
  grep -q "$msg_robot_lost" "$LAB/stderr" || fail "the lost connection was not reported"
}

scenario_a_controller_that_ignores_everything_is_ended() {
  controller walker 'signal(SIGINT, SIG_IGN); signal(SIGTERM, SIG_IGN); puts("walking"); fflush(stdout); for (;;) pause();'
  start_install --controller "$LAB/pc/walker" --run "$login@$ADDRESS"
  wait_for "$LAB/stdout" '^walking$'
  kill -INT -- "-$install_pid"
  wait_install 25
  expect_status 137
  robot_quiet
}

scenario_a_second_run_is_refused_while_one_runs() {
  controller walker "$until_stopped"
  controller other 'return 0;'
  start_install --controller "$LAB/pc/walker" --run "$login@$ADDRESS"
  wait_for "$LAB/stdout" '^walking$'
  run_install --controller "$LAB/pc/other" --run
  expect_status 1
  expect_said 'walker is already running on this robot; stop it first'
  # A new version may arrive meanwhile; the running one keeps its files.
  run_install --controller "$LAB/pc/walker"
  expect_status 0
  [ "$(find "$ROBOT/opt/darwinop/controllers" -maxdepth 1 -name '.sent-*' | wc -l)" = 3 ] || fail "the files of the running controller were removed"
  kill -INT -- "-$install_pid"
  wait_install
  run_install --controller "$LAB/pc/other"
  [ "$(find "$ROBOT/opt/darwinop/controllers" -maxdepth 1 -name '.*-*' | wc -l)" = 2 ] || fail "old versions are left on the disk"
}

scenario_nothing_runs_out_of_the_start_pose() {
  controller walker 'puts("walking"); return 0;'
  echo 'knee is 0.8 rad off' >"$ROBOT/run/pose-unsafe"
  run_install --controller "$LAB/pc/walker" --run
  expect_status 3
  expect_said 'knee is 0.8 rad off'
  expect_said "$msg_sit_down"
  expect_not_said '^walking$'
  run_install --controller "$LAB/pc/walker" --run --force
  expect_status 0
  expect_said '^walking$'
}

scenario_the_default_controller_is_stopped_first() {
  controller walker 'return 0;'
  ln -s controllers/other "$ROBOT/opt/darwinop/default"
  start_runtime
  run_install --controller "$LAB/pc/walker" --run
  expect_status 0
  expect_said "$msg_stopping_default"
  grep -q -e --stop-controller "$ROBOT/run/supervisor-calls" || fail "the supervisor was not called"
}

scenario_a_window_that_drives_is_named_and_goes_on() {
  controller walker 'puts("walking"); return 0;'
  start_runtime
  (exec -a darwinop-remote bash -c 'kill -STOP $$' window --end-with-parent) &
  local driver=$!
  sed -i "2i echo 'driver    pid $driver, for 3 s'" "$ROBOT/opt/darwinop/current/bin/darwinop-runtime"
  run_install --controller "$LAB/pc/walker" --run
  expect_status 1
  expect_said "$msg_driven_from_window \(process $driver\)"
  expect_not_said '^walking$'
  [ ! -e "$ROBOT/opt/darwinop/running" ] || fail "the robot is still claimed"
  run_install --controller "$LAB/pc/walker" --make-default
  expect_status 0
  expect_said "$msg_window_drives .*; walker "
  ! grep -qs . "$ROBOT/run/supervisor-calls" || fail "the supervisor was called"
  kill -KILL "$driver"
}

scenario_make_default_links_it_and_restarts_it() {
  controller walker 'return 0;'
  start_runtime
  run_install --controller "$LAB/pc/walker" --make-default
  expect_status 0
  expect_said "$msg_every_boot"
  [ "$(readlink "$ROBOT/opt/darwinop/default")" = controllers/walker ] || fail "default is $(readlink "$ROBOT/opt/darwinop/default")"
  [ -x "$ROBOT/opt/darwinop/default/walker" ] || fail "default is a dangling link"
  grep -q -e --restart-controller "$ROBOT/run/supervisor-calls" || fail "the supervisor was not called"
}

scenario_no_default_starts_nothing_at_boot_any_more() {
  controller walker 'return 0;'
  start_runtime
  run_install --no-default
  expect_status 0
  expect_said "$msg_no_default"
  run_install --controller "$LAB/pc/walker" --make-default
  run_install --no-default
  expect_status 0
  expect_said 'walker no longer starts at boot'
  [ ! -L "$ROBOT/opt/darwinop/default" ] || fail "the default is still there"
  [ -x "$ROBOT/opt/darwinop/controllers/walker/walker" ] || fail "the controller itself is gone"
  grep -q -e --stop-controller "$ROBOT/run/supervisor-calls" || fail "the supervisor was not called to stop it"
}

scenario_a_cut_sending_leaves_the_old_controller() {
  controller walker 'puts("old"); return 0;'
  run_install --controller "$LAB/pc/walker"
  expect_status 0
  controller walker 'puts("new"); return 0;'
  head -c 3000000 /dev/urandom >"$LAB/pc/walker/sound.wav"
  mv "$ROBOT/bin/cksum" "$ROBOT/bin/cksum.real"
  printf '#!/bin/sh\necho 1 1\n' >"$ROBOT/bin/cksum"
  chmod 755 "$ROBOT/bin/cksum"
  run_install --controller "$LAB/pc/walker"
  expect_status 1
  expect_said 'walker was not changed'
  [ "$(chroot "$ROBOT" /opt/darwinop/controllers/walker/walker)" = old ] || fail "the old controller is gone"
  [ "$(find "$ROBOT/opt/darwinop/controllers" -maxdepth 1 -name '.*-*' | wc -l)" = 1 ] || fail "a partial new version is left"
  mv "$ROBOT/bin/cksum.real" "$ROBOT/bin/cksum"
  run_install --controller "$LAB/pc/walker"
  expect_status 0
  [ "$(chroot "$ROBOT" /opt/darwinop/controllers/walker/walker)" = new ] || fail "the new controller did not arrive"
}

scenario_a_controller_is_on_the_disk_before_its_name_leads_to_it() {
  local first
  controller walker 'return 0;'
  run_install --controller "$LAB/pc/walker"
  first=$(readlink "$ROBOT/opt/darwinop/controllers/walker")
  rm "$ROBOT/bin/sync"
  printf '#!/bin/sh\nreadlink /opt/darwinop/controllers/walker >>/run/synced\n' >"$ROBOT/bin/sync"
  chmod 755 "$ROBOT/bin/sync"
  run_install --controller "$LAB/pc/walker"
  expect_status 0
  [ "$(head -n 1 "$ROBOT/run/synced")" = "$first" ] || fail "synced: $(cat "$ROBOT/run/synced")"
  [ "$(tail -n 1 "$ROBOT/run/synced")" != "$first" ] || fail "the new name was not written to the disk"
}

scenario_a_running_controller_keeps_its_files_where_opt_is_a_link() {
  local first process
  controller walker 'return 0;'
  mv "$ROBOT/opt" "$ROBOT/home/opt"
  ln -s /home/opt "$ROBOT/opt"
  run_install --controller "$LAB/pc/walker"
  expect_status 0
  first=$ROBOT/home/opt/darwinop/controllers/$(readlink "$ROBOT/home/opt/darwinop/controllers/walker")
  chroot "$ROBOT" /bin/sh -c 'cd /opt/darwinop/controllers/walker && exec sleep 300' &
  process=$!
  until [[ $(readlink "/proc/$process/cwd") = *walker ]]; do sleep 0.02; done
  run_install --controller "$LAB/pc/walker"
  expect_status 0
  [ -e "$first/walker" ] || fail "the files of a running controller were removed"
  kill "$process"
}

scenario_a_full_disk_is_refused_before_anything_is_sent() {
  controller walker 'return 0;'
  mkdir "$ROBOT/opt/darwinop/controllers"
  mount -t tmpfs -o size=15m small "$ROBOT/opt/darwinop/controllers"
  mv "$ROBOT/bin/df" "$ROBOT/bin/df.real"
  printf '#!/bin/sh\nexec df.real -P -k /opt/darwinop/controllers\n' >"$ROBOT/bin/df"
  chmod 755 "$ROBOT/bin/df"
  run_install --controller "$LAB/pc/walker"
  expect_status 1
  expect_said "$msg_disk_full: [0-9]+ kB .* [0-9]+ kB "
}

scenario_logs_show_the_last_lines_and_follow() {
  run_install --logs
  expect_status 1
  expect_said "$msg_no_log"
  mkdir -p "$ROBOT/opt/darwinop/log"
  seq 300 >"$ROBOT/opt/darwinop/log/controller.log"
  run_install --logs
  expect_status 0
  expect_said '^300$'
  expect_not_said '^100$'
  start_install --logs -f "$login@$ADDRESS"
  wait_for "$LAB/stdout" '^300$'
  echo later >>"$ROBOT/opt/darwinop/log/controller.log"
  wait_for "$LAB/stdout" '^later$'
  kill -INT -- "-$install_pid"
  wait_install
  expect_status 0
  robot_quiet
}

scenario_all_of_it_works_with_busybox() {
  robot_new busybox
  controller walker "$until_stopped"
  start_install --controller "$LAB/pc/walker" --run "$login@$ADDRESS"
  wait_for "$LAB/stdout" '^walking$'
  kill -INT -- "-$install_pid"
  wait_install
  expect_status 7
  run_install --controller "$LAB/pc/walker" --make-default
  expect_status 0
  run_install --no-default
  expect_status 0
  run_install --stop
  expect_status 0
  robot_quiet
}

run_scenarios "$@"
