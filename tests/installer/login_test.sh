#!/usr/bin/env bash
# Login: passwords, keys, host keys, and the ssh of 2009.
. "$(dirname "$(readlink -f "$0")")/robot.sh"

# log_ssh_calls: records the arguments of every ssh call in $LAB/ssh_calls.
log_ssh_calls() {
  : >"$LAB/ssh_calls"
  pc_program ssh <<END
#!/bin/sh
printf '%s\n' "\$*" >>$LAB/ssh_calls
exec /usr/bin/ssh "\$@"
END
}

scenario_wrong_password_ends_with_a_sentence() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  remember_disk --touched
  password=wrong
  run_install --bundle "$v1"
  expect_status 1
  expect_said "$msg_password"
  expect_same_disk --touched "a wrong password changed something"
}

scenario_password_that_sudo_does_not_take() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  sed -i '/^darwin /d' "$ROBOT/etc/sudoers"
  remember_disk --touched
  run_install --bundle "$v1"
  expect_status 1
  expect_said sudo
  expect_same_disk --touched "a user who may not use sudo changed something"
}

scenario_password_is_asked_once_and_covers_sudo() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  run_install_on_terminal 'assword=111111' -- --bundle "$v1"
  expect_status 0
  expect_version 0.1.0+a
  [ "$(grep -ciE 'password[^:]*: *.?$' "$LAB/out")" = 1 ] || fail "the number of password prompts is not 1"
  ! grep -q 111111 "$LAB/out" || fail "the password was shown on the terminal"
}

scenario_password_with_spaces_and_quotes_stays_secret() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  password="two words ' \$x"
  # shellcheck disable=SC2016
  sed -i 's|^darwin:[^:]*:|darwin:$6$rounds=1000$darwinop$DX5SyIgh8DYOI5KOeQpbp4qTZartqpj5w0v1f29TcJ8PIfxcmocHG3GuoZDz0h3AWm/iZZ.Ae1gfJJtzErKgy1:|' \
    "$ROBOT/etc/shadow"
  log_ssh_calls
  (while sleep 0.01; do cat /proc/[0-9]*/cmdline || true; done >"$LAB/command_lines" 2>/dev/null) &
  local watcher=$!
  run_install --bundle "$v1"
  kill "$watcher"
  expect_status 0
  expect_version 0.1.0+a
  grep -aq sudo "$LAB/command_lines" || fail "the test did not see the robot's processes"
  ! grep -qF 'two words' "$LAB/ssh_calls" || fail "the password was in the arguments of ssh"
  ! grep -aqF 'two words' "$LAB/command_lines" || fail "the password was in the arguments of a process"
  ! grep -rqF 'two words' "$ROBOT"/{etc,home,opt,root,tmp,var} "$LAB/pc/home" || fail "the password was left in a file"
}

# Ctrl-C, sent twice by the harness' timeout, as by an impatient user. run_scenarios reports leftovers.
scenario_ctrl_c_at_any_question_leaves_nothing_behind() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  remember_disk --touched
  run_install_on_terminal "assword.*:="$'\003' -- --bundle "$v1"
  expect_status 130
  expect_same_disk --touched "Ctrl-C at the password changed something"
  forget_host_key
  run_install_on_terminal "yes/no="$'\003' -- --bundle "$v1"
  expect_status 130
  expect_same_disk --touched "Ctrl-C at the host key changed something"
}

scenario_ctrl_c_in_the_self_test_is_completed_by_the_robot() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  : >"$ROBOT/run/hold-self-test"
  run_install_on_terminal 'assword.*:=111111' 'self-test='$'\003' -- --bundle "$v1"
  expect_status 130
  expect_said "$msg_completes"
  [ -z "$(pgrep -f 'ssh.* -M ' || true)" ] || fail "the connection, whose ssh knows the password, is still open"
  rm "$ROBOT/run/hold-self-test"
  robot_quiet
  expect_version 0.1.0+a
  expect_confirmed
}

scenario_key_and_sudo_without_password() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  login=robotis
  password='not the password'
  run_install -i "$LAB/pc/key" --bundle "$v1"
  expect_status 0
  expect_version 0.1.0+a
}

scenario_key_and_sudo_with_password() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  install -d -o 1000 -g 1000 -m 700 "$ROBOT/home/darwin/.ssh"
  install -o 1000 -g 1000 -m 600 "$LAB/pc/key.pub" "$ROBOT/home/darwin/.ssh/authorized_keys"
  run_install -i "$LAB/pc/key" --bundle "$v1"
  expect_status 0
  expect_version 0.1.0+a
}

# Of it ssh says "Permission denied" as well.
scenario_a_key_file_that_cannot_be_read_leaves_the_password() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  pc_program ssh <<'END'
#!/bin/sh
case " $* " in *" PasswordAuthentication=no "*) echo 'Load key "/home/me/.ssh/id_rsa": Permission denied' >&2 ;; esac
exec /usr/bin/ssh "$@"
END
  run_install --bundle "$v1"
  expect_status 0
  expect_version 0.1.0+a
}

scenario_the_program_is_in_no_command_line_that_sudo_logs() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  mv "$ROBOT/bin/sudo" "$ROBOT/bin/sudo.real"
  printf '#!/bin/sh\necho "$*" >>/tmp/sudo-calls\nexec /bin/sudo.real "$@"\n' >"$ROBOT/bin/sudo"
  chmod 755 "$ROBOT/bin/sudo"
  run_install --bundle "$v1"
  expect_status 0
  [ "$(wc -c <"$ROBOT/tmp/sudo-calls")" -lt 4000 ] || fail "sudo would log $(wc -c <"$ROBOT/tmp/sudo-calls") bytes"
}

scenario_root_by_key() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  login=root
  rm "$ROBOT/bin/sudo"
  run_install -i "$LAB/pc/key" --bundle "$v1"
  expect_status 0
  expect_version 0.1.0+a
}

scenario_user_without_sudo_on_the_robot() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  rm "$ROBOT/bin/sudo"
  remember_disk --touched
  run_install --bundle "$v1"
  expect_status 1
  expect_said 'sudo'
  expect_same_disk --touched "a robot without sudo was changed"
}

scenario_unknown_host_key_without_terminal_is_refused() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  forget_host_key
  remember_disk --touched
  run_install --bundle "$v1"
  expect_status 1
  expect_said '--new-host'
  expect_same_disk --touched "an unknown robot was changed"
  [ ! -s "$(known_hosts)" ] || fail "the unknown key was stored"
  run_install --new-host --bundle "$v1"
  expect_status 0
  expect_version 0.1.0+a
  run_install --bundle "$v1"  # known from now on
  expect_status 0
}

scenario_unknown_host_key_is_asked_for_on_a_terminal() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  forget_host_key
  run_install_on_terminal 'yes/no=yes' 'assword.*:=111111' -- --bundle "$v1"
  expect_status 0
  expect_version 0.1.0+a
}

scenario_changed_host_key_is_refused() {
  local v1 option; v1=$(fake_bundle 0.1.0+a)
  echo "$ADDRESS $(cut -d' ' -f1,2 "$LAB/pc/key.pub")" >"$(known_hosts)"
  cp "$(known_hosts)" "$LAB/known_before"
  remember_disk --touched
  for option in '' --new-host; do
    run_install ${option:+"$option"} --bundle "$v1"
    expect_status 1
    expect_said "$msg_other_key"
    expect_said "ssh-keygen -R $ADDRESS"
    expect_same_disk --touched "a robot with another host key was changed"
    cmp -s "$(known_hosts)" "$LAB/known_before" || fail "known_hosts was changed"
  done
}

# ssh keeps keys by type, and who stands in between may choose which one to offer.
scenario_a_key_of_another_type_is_refused_where_one_is_known() {
  local v1 option; v1=$(fake_bundle 0.1.0+a)
  other_type_is_refused() {
    cp "$(known_hosts)" "$LAB/known_before"
    for option in '' --new-host; do
      run_install ${option:+"$option"} --bundle "$v1"
      expect_status 1
      expect_said "$msg_other_key"
      expect_said "ssh-keygen -R $ADDRESS"
      cmp -s "$(known_hosts)" "$LAB/known_before" || fail "known_hosts was changed"
    done
  }
  # Known by RSA, and an Ed25519 key is offered.
  ssh-keygen -q -t rsa -b 2048 -N '' -f "$LAB/pc/rsa_of_the_robot"
  echo "$ADDRESS $(cut -d' ' -f1,2 "$LAB/pc/rsa_of_the_robot.pub")" >"$(known_hosts)"
  other_type_is_refused
  # Known by Ed25519, and a server of 2009 offers RSA.
  local known; known=$(cut -d' ' -f1,2 "$LAB/pc/key.pub")
  legacy_sshd
  echo "$ADDRESS $known" >"$(known_hosts)"
  other_type_is_refused
}

scenario_nobody_there() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  stop_sshd
  run_install --bundle "$v1"
  expect_status 1
  expect_said "$msg_refuses.*\(-p\)"
  status=0
  "$installer" --remote "$login@$ADDRESS" < <(sleep 10) >"$LAB/out" 2>&1 || status=$?
  expect_status 1
  expect_said "$msg_refuses.*\(--ssh-port\)"
}

legacy_sshd() {
  ssh-keygen -q -t rsa -b 2048 -N '' -f "$ROBOT/etc/ssh/ssh_host_rsa_key"
  start_sshd 'HostKey /etc/ssh/ssh_host_rsa_key' 'HostKeyAlgorithms ssh-rsa' 'PubkeyAcceptedAlgorithms ssh-rsa' "$@"
  trust_host_key
}

scenario_ssh_of_2009() {
  local v1; v1=$(fake_bundle 0.1.0+a 300)
  legacy_sshd 'KexAlgorithms diffie-hellman-group14-sha1,diffie-hellman-group1-sha1' \
    'Ciphers aes128-cbc,3des-cbc' 'MACs hmac-sha1,hmac-md5'
  run_install --bundle "$v1"
  expect_status 0
  expect_said "$msg_old_ssh"
  expect_version 0.1.0+a
}

scenario_the_weakest_ssh_of_2009_by_rsa_key_and_unknown() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  legacy_sshd 'KexAlgorithms diffie-hellman-group1-sha1' 'Ciphers 3des-cbc' 'MACs hmac-md5'
  ssh-keygen -q -t rsa -b 2048 -N '' -f "$LAB/pc/rsa"
  cp "$LAB/pc/rsa.pub" "$ROBOT/home/robotis/.ssh/authorized_keys"
  forget_host_key
  login=robotis
  password='not the password'
  run_install --new-host -i "$LAB/pc/rsa" --bundle "$v1"
  expect_status 0
  expect_said "$msg_old_ssh"
  expect_version 0.1.0+a
  grep -q 'ssh-rsa' "$(known_hosts)" || fail "the robot's key was not stored"
}

scenario_a_modern_robot_gets_no_weak_algorithm() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  log_ssh_calls
  run_install --bundle "$v1"
  expect_status 0
  [ -s "$LAB/ssh_calls" ] || fail "the test did not see ssh being called"
  ! grep -E 'KexAlgorithms|HostKeyAlgorithms|Ciphers|MACs|ssh-rsa|sha1' "$LAB/ssh_calls" | grep -v '^-Q ' ||
    fail "a modern sshd was offered weak algorithms"
  expect_not_said "$msg_old_ssh"
}

scenario_port_and_option_of_the_user_are_taken() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  start_sshd 'Port 2222'
  ssh-keyscan -p 2222 "$ADDRESS" >"$(known_hosts)" 2>/dev/null
  run_install -p 2222 --bundle "$v1"
  expect_status 0
  status=0
  # shellcheck disable=SC2086
  DARWINOP_PASSWORD=$password "$installer" --status -p 2222 -o HostName=$ADDRESS -o "HostKeyAlias=[$ADDRESS]:2222" darwin@robot \
    </dev/null >"$LAB/out" 2>&1 || status=$?
  cat "$LAB/out" >>"$LAB/history"
  expect_status 0
  expect_said '0\.1\.0\+a'
}

run_scenarios "$@"
