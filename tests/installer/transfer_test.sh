#!/usr/bin/env bash
# The Transfer tab of the robot window: real installer, real sshd, real browser. What it does
# there: tests/window/transfer/transfer_lab.mjs and transfer_versions_lab.mjs.
# shellcheck disable=SC2154  # controller_lab.sh and robot.sh set what is read here
. "$(dirname "$(readlink -f "$0")")/controller_lab.sh"

# in_browser FILE [NAME=VALUE...]: tests of tests/window/transfer, with the lab about them.
in_browser() {
  env LAB="$LAB" ROBOT="$ROBOT" DARWINOP_BIN="${DARWINOP_BIN:-$SOURCE/build/debug/bin}" \
    DARWINOP_NPM="${DARWINOP_NPM:-$SOURCE/build/npm/node_modules}" "${@:2}" \
    node --test "$SOURCE/tests/window/transfer/$1" >"$LAB/out" 2>&1 || { cat "$LAB/out"; fail "see above"; }
  cat "$LAB/out" >>"$LAB/history"
}

scenario_from_an_unknown_robot_to_a_default_controller() {
  # shellcheck disable=SC2016
  sed -i 's|^darwin:[^:]*:|darwin:$6$rounds=1000$darwinop$DX5SyIgh8DYOI5KOeQpbp4qTZartqpj5w0v1f29TcJ8PIfxcmocHG3GuoZDz0h3AWm/iZZ.Ae1gfJJtzErKgy1:|' \
    "$ROBOT/etc/shadow"
  password="two words ' \$x"
  controller walker '
    signal(SIGINT, stop); printf("walking %s %s\n", argv[1], argv[2]); fflush(stdout); fputs("it wobbles\n", stderr);
    while (!stopped) usleep(20000);
    puts("kneeling"); fflush(stdout);
    FILE* ended = fopen("/tmp/ended", "w"); fprintf(ended, "%s\n", argv[1]); fclose(ended); return 7;'
  controller slip 'int unused = 1; return 0 }'
  forget_host_key
  in_browser transfer_lab.mjs PASSWORD="$password" \
    HOST_KEY="$(ssh-keygen -lf "$ROBOT/etc/ssh/ssh_host_ed25519_key.pub" | cut -d ' ' -f 2)"
  wait_for "$ROBOT/tmp/ended" '^--again$'
  local tries=0
  while pgrep -x ssh >/dev/null; do
    [ $((tries += 1)) -lt 250 ] || fail "ssh still runs on the PC: $(pgrep -ax ssh | cut -c -200)"
    sleep 0.02
  done
  [ "$(readlink "$ROBOT/opt/darwinop/default")" = controllers/walker ] || fail "walker is not the default controller"
  [ -s "$LAB/pc/home/.config/darwinop/robots.json" ] || fail "the robot is not remembered"
  ! grep -rqF 'two words' "$ROBOT"/{etc,home,opt,root,tmp,var} "$LAB/pc/home" || fail "the password was left in a file"
  robot_quiet
}

# The installer sends the newest of what ./dev build --robot has left: here that is what the lab puts there.
scenario_install_go_back_and_remove() {
  bare_robot_new gnu
  remember_disk
  local built=$SOURCE/build/robot next
  mkdir -p "$built" "$LAB/built"
  mount --bind "$LAB/built" "$built"
  cp "$(fake_bundle 0.1.0+a)" "$built/"
  next=$(fake_bundle 0.2.0+b)
  in_browser transfer_versions_lab.mjs BUILT="$built" NEXT="$next"
  umount "$built"
  robot_quiet
  expect_same_disk "what was installed through the page, and removed, left something"
  expect_boots_nothing_of_ours
}

run_scenarios "$@"
