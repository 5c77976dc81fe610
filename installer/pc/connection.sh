# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# One ssh connection to the robot: `connect` logs in once, every `robot_run` is a session of it, `disconnect` ends it.
# In: $target (user@host), $ssh_options (words quoted for eval), $new_host (1: accept an unknown host key), $installer.

# Ignores an environment variable of this name: `disconnect` removes this folder.
connection=
sudo_password=
host_key=    # accepted fingerprint of an unknown robot
ssh_apart=

connect() {
  command -v ssh >/dev/null 2>&1 || die "ssh not found; install it: sudo apt-get install openssh-client"
  connection=$(mktemp -d "${TMPDIR:-/tmp}/darwinop-install.XXXXXX") || die "cannot create a temporary folder"
  chmod 700 "$connection"
  phase "connecting to $target"
  host_keys=ask
  [ "${new_host:-0}" = 0 ] || host_keys=accept-new
  legacy_options=
  log_in_with_key || log_in_with_password
  look_for_root
}

disconnect() {
  trap '' INT TERM HUP
  restore_terminal
  [ -n "${connection:-}" ] || return 0
  [ ! -S "$connection/socket" ] || ssh_call -O exit "$target" >/dev/null 2>&1 || :
  rm -rf "$connection"
  connection=
}

# robot_run FUNCTION ARGUMENTS... <DATA: runs a function of installer/robot/*.sh as root on the robot, DATA its stdin.
# The program comes before the data: sudo would write a command line of 80 kB into the robot's log. Returns the function's
# status; 255: connection lost.
robot_run() {
  robot_program=$(robot_text && printf '\nmain ' && quote "$@") || die "cannot read $installer/robot"
  {
    [ -z "${sudo_password:-}" ] || printf '%s\n' "$password"
    printf '%s\n' darwinop-program "$robot_program" darwinop-data
    cat
  } | ssh_session "${as_root}sh -c $(quote "$receive_program")"
}

# On the robot, where stdin begins with the password if sudo did not read it. `read` takes no byte of the data.
receive_program='
line=
until [ "$line" = darwinop-program ]; do IFS= read -r line || break; done
program=
while IFS= read -r line; do
  if [ "$line" = darwinop-data ]; then
    eval "$program"
    exit
  fi
  program="$program$line
"
done
echo "robot: the connection was closed before the data; nothing was changed" >&2
exit 1'

# The functions, and small files to be written, as shell variables.
robot_text() {
  cat "$installer"/robot/*.sh || return 1
  for robot_file in start:start unit:darwinop.service.template rc_local:../rc.local.template; do
    robot_file_text=$(cat "$installer/${robot_file#*:}") || return 1
    printf '\ntext_%s=' "${robot_file%%:*}"
    quote "$robot_file_text"
  done
  printf '\nerror_mark=%s\n' "$(quote "$error_mark")"
}

# ssh_call ARGUMENTS: ssh over the control socket. The user's options come first: ssh uses the first value of an option.
ssh_call() { ssh_with "" "$@"; }

# ssh_session COMMAND: over the master connection only; fails without it instead of logging in again.
ssh_session() { ssh_with "-o ProxyCommand=false" -o ControlMaster=no -o BatchMode=yes -T "$target" "$1"; }

ssh_with() { # WORDS-BEFORE-THE-USERS ARGUMENTS
  ssh_words="$1 $ssh_options -S \"\$connection/socket\" -o ConnectTimeout=10 -o ServerAliveInterval=5 \
    -o ServerAliveCountMax=3 $legacy_options"
  shift
  eval "set -- $ssh_words \"\$@\""
  ${ssh_apart:-} ssh "$@"  # optional prefix: see attended() in controller.sh
}

# open_master OPTIONS: ssh's messages go to $connection/said, its questions to the terminal.
# In a subshell, so that the response to Ctrl-C goes to the terminal, not to that file.
open_master() { (ask_for_host_key && ssh_call -M -N -f -o ControlPersist=no -o ClearAllForwardings=yes "$@" "$target") </dev/null 2>"$connection/said"; }

# Without a terminal ssh asks a program whether to trust an unknown host. Ours accepts one key and stores the question.
ask_for_host_key() {
  [ -n "$host_key" ] || [ "$progress" = 1 ] || return 0
  [ -z "${SSH_ASKPASS_REQUIRE:-}" ] || [ "${SSH_ASKPASS:-}" != "$connection/askpass" ] || return 0  # set for the password
  cat >"$connection/askhost" <<'END' && chmod 700 "$connection/askhost" || return
#!/bin/sh
case $1 in *fingerprint*) ;; *) exit 1 ;; esac
printf '%s\n' "$1" >"${0%/*}/asked-host"
case " $1" in *" $DARWINOP_HOST_KEY"[!A-Za-z0-9+/]*) echo yes ;; *) echo no ;; esac
END
  export DARWINOP_HOST_KEY="${host_key:-none}" SSH_ASKPASS="$connection/askhost" SSH_ASKPASS_REQUIRE=force DISPLAY="${DISPLAY:-:0}"
}

# SHA256 and 43 characters: a complete fingerprint; a part would match many keys.
check_host_key() {
  [ -n "$host_key" ] || return 0
  letters=${host_key#SHA256:}
  case $host_key:$letters in
    SHA256:*:*[!A-Za-z0-9+/]*) letters= ;;
    SHA256:*) ;;
    *) letters= ;;
  esac
  [ ${#letters} = 43 ] || wrong_usage "--host-key requires a fingerprint as printed by ssh, SHA256:..., not '$host_key'"
}

# report_host_key: sets $host_key_text to " (TYPE key SHA256:...)" and reports the key on the progress channel.
report_host_key() {
  host_key_text=$(grep -o -m 1 '[A-Za-z0-9-]* key fingerprint is SHA256:[A-Za-z0-9+/]*' "$connection/asked-host" 2>/dev/null) || return 0
  [ "$progress" = 0 ] || printf 'host-key %s\n' "${host_key_text##* }" >&3
  host_key_text=" (${host_key_text%% key*} key ${host_key_text##* })"
}

# Login by key or agent. Returns 1 if the robot requires a password.
log_in_with_key() {
  open_master -o StrictHostKeyChecking="$host_keys" -o PasswordAuthentication=no -o KbdInteractiveAuthentication=no && return
  if grep -q -e 'no matching' -e 'Unable to negotiate' "$connection/said" && [ -z "$legacy_options" ]; then
    say "$target supports $msg_old_ssh, which are disabled by default as weak; enabling them for this robot and command only"
    legacy_options=$(legacy_ssh_options)
    log_in_with_key
    return
  fi
  if grep -q -e 'Permission denied' -e 'Too many authentication failures' "$connection/said"; then return 1; fi
  explain_ssh
}

log_in_with_password() {
  # In brackets: what the robot accepts. Without, what ssh says of a key file.
  if grep 'Permission denied (' "$connection/said" | grep -v -q -e password -e keyboard-interactive; then
    die "$target accepts keys only, and none of yours; copy a key to it from a machine that can log in, or specify one with -i"
  fi
  need_password "login"
  [ "$host_keys" = accept-new ] || host_keys=yes
  # The helper passes the password from its environment to ssh: it is in no file or argument list.
  # shellcheck disable=SC2016
  printf '#!/bin/sh\nprintf "%%s\\n" "$DARWINOP_PASSWORD"\n' >"$connection/askpass"
  chmod 700 "$connection/askpass"
  (
    export DARWINOP_PASSWORD="$password" SSH_ASKPASS="$connection/askpass" SSH_ASKPASS_REQUIRE=force DISPLAY="${DISPLAY:-:0}"
    open_master -o StrictHostKeyChecking="$host_keys" -o PubkeyAuthentication=no -o NumberOfPasswordPrompts=1
  ) && return
  if grep -q 'Permission denied' "$connection/said"; then
    die "$target $msg_password; the default of a DARwIn-OP is 'darwin' and 111111, of an OP2 'robotis' and 111111"
  fi
  explain_ssh
}

# Sets $as_root, a command prefix, and $sudo_password if sudo requires one.
look_for_root() {
  as_root=
  sudo_password=
  case $(ssh_session 'id -u; sudo -n true 2>/dev/null && echo free; command -v sudo' </dev/null) in
    0*) return ;;
    *free*) as_root="sudo -n " ;;
    */*)
      as_root="sudo -S -p '' "
      need_password "sudo"
      printf '%s\n' "$password" | ssh_session "sudo -S -p '' true" >/dev/null 2>&1 ||
        die "sudo on $target $msg_password or this user; log in as a user with sudo permission"
      sudo_password=1
      ;;
    "") die "$target accepted the login but ran no command; check with 'ssh $target id'" ;;
    *) die "$target has no sudo; log in as root" ;;
  esac
}
