# shellcheck shell=bash disable=SC2034  # others read what is set here
# The simulated robot: root folder, sshd, power. Sourced by robot.sh, which has the overview.

# What stock Ubuntu 9.10 has; each is a link to this machine's program.
gnu_tools=(
  '[' base64 basename cat chgrp chmod chown chroot cksum cmp comm cp cut date dd df diff dirname du echo env expr
  false find flock fold gunzip gzip grep egrep head hostname id install join kill ln ls md5sum mkdir mkfifo mknod mktemp
  mount mv nice nl nohup od paste perl pgrep pkill printf ps pwd readlink rm rmdir sed seq setsid sha1sum sha256sum sleep sort
  split stat stty sudo sum sync tac tail tar tee test touch tr true tty umount uniq wc which who whoami xargs yes zcat)

# 111111, with few rounds so that logging in is quick.
# shellcheck disable=SC2016  # the dollars are the hash's
darwin_hash='$6$rounds=1000$darwinop$o2aBkWjwPqVnF9wqRXgvt5RNIoaAaiuo5dDntQEfjEmcGIgSkgDaiaVIXPE2s.wsdnm6j1j2ZJMyB1nhgBIr5.'

# robot_new gnu|busybox: a fresh robot, switched on. busybox: its sh and its tools, so that what only dash's sh or GNU's tools can do shows.
robot_new() {
  robot_off
  mkdir -p "$ROBOT"
  mount -t tmpfs -o mode=755 robot "$ROBOT"
  mkdir -p "$ROBOT"/{.host,bin,boot,dev/pts,dev/shm,etc/pam.d,etc/ssh,home/darwin,opt,proc,root,run/sshd,run/sudo,sys,tmp,usr,var/lib,var/log}
  chmod 1777 "$ROBOT/tmp" "$ROBOT/dev/shm"
  chmod 700 "$ROBOT/root"
  mount --bind /usr "$ROBOT/.host"
  mount -o remount,bind,ro "$ROBOT/.host"
  mount -t proc proc "$ROBOT/proc"
  mount --bind /dev/pts "$ROBOT/dev/pts"
  ln -s .host/lib .host/lib64 "$ROBOT/"
  ln -s bin "$ROBOT/sbin"
  ln -s ../.host/lib ../.host/lib64 ../.host/libexec ../.host/share ../bin "$ROBOT/usr/"
  ln -s bin "$ROBOT/usr/sbin"
  robot_tools "$1"
  robot_devices
  robot_etc
  robot_hardware
  start_sshd
  trust_host_key
}

robot_tools() {
  local tools=("${gnu_tools[@]/#//.host/bin/}")
  if [ "$1" = busybox ]; then
    busybox --list | grep -vxE 'sudo|bash|busybox' | sed "s|.*|$ROBOT/bin/&|" | xargs -d '\n' -n1 ln -s /.host/bin/busybox
    ln -s /.host/bin/cksum /.host/bin/sudo "$ROBOT/bin/"  # Debian's busybox has no cksum; POSIX asks for one
  else
    ln -s "${tools[@]}" /.host/sbin/{start-stop-daemon,useradd,userdel,groupadd,groupdel} "$ROBOT/bin/"
    ln -s /.host/bin/mawk "$ROBOT/bin/awk"  # not through /etc/alternatives, which the robot has not
    ln -s /.host/bin/dash "$ROBOT/bin/sh"
  fi
  ln -s /.host/sbin/sshd "$ROBOT/bin/sshd"
  rm -f "$ROBOT/bin/uname" "$ROBOT/bin/sync"
  ln -s true "$ROBOT/bin/sync"  # would flush this machine's disks, without use here
  cat >"$ROBOT/bin/uname" <<'END'
#!/bin/sh
# The robot's kernel and computer, as /run/kernel and /run/machine say.
kernel=$(cat /run/kernel) machine=$(cat /run/machine)
case ${1:--s} in
  -s) echo Linux ;;
  -n) echo darwin ;;
  -r) echo "$kernel" ;;
  -m | -p | -i) echo "$machine" ;;
  -sr) echo "Linux $kernel" ;;
  -rm) echo "$kernel $machine" ;;
  -srm) echo "Linux $kernel $machine" ;;
  -a) echo "Linux darwin $kernel #1 SMP $machine GNU/Linux" ;;
  *) echo "uname: the test's stand-in does not know $*" >&2; exit 1 ;;
esac
END
  chmod 755 "$ROBOT/bin/uname"
}

robot_devices() {
  local name
  mknod -m 666 "$ROBOT/dev/null" c 1 3
  mknod -m 666 "$ROBOT/dev/zero" c 1 5
  mknod -m 666 "$ROBOT/dev/full" c 1 7
  mknod -m 444 "$ROBOT/dev/random" c 1 8
  mknod -m 444 "$ROBOT/dev/urandom" c 1 9
  mknod -m 666 "$ROBOT/dev/tty" c 5 0
  mknod -m 666 "$ROBOT/dev/ptmx" c 5 2
  mknod -m 660 "$ROBOT/dev/ttyUSB0" c 1 3  # the serial device: something that can be opened
  for name in fd:fd stdin:fd/0 stdout:fd/1 stderr:fd/2; do ln -s "/proc/self/${name#*:}" "$ROBOT/dev/${name%:*}"; done
}

robot_etc() {
  local etc=$ROBOT/etc user
  cat >"$etc/passwd" <<'END'
root:x:0:0:root:/root:/bin/sh
sshd:x:100:65534::/run/sshd:/bin/false
darwin:x:1000:1000:darwin:/home/darwin:/bin/sh
robotis:x:1001:1001:robotis:/home/robotis:/bin/sh
nobody:x:65534:65534:nobody:/nonexistent:/bin/false
END
  printf '%s\n' root:x:0: dialout:x:20:darwin video:x:44:darwin darwin:x:1000: robotis:x:1001: nogroup:x:65534: >"$etc/group"
  printf '%s\n' 'root:*:19000::::::' 'sshd:*:19000::::::' "darwin:$darwin_hash:19000::::::" 'robotis:*:19000::::::' >"$etc/shadow"
  chmod 640 "$etc/shadow"
  printf '%s\n' 'passwd: files' 'group: files' 'shadow: files' 'hosts: files' >"$etc/nsswitch.conf"
  printf '%s\n' '127.0.0.1 localhost darwin' >"$etc/hosts"
  echo darwin >"$etc/hostname"
  printf '%s\n' 'auth required pam_unix.so nodelay' 'account required pam_unix.so' 'session required pam_permit.so' >"$etc/pam.d/sudo"
  printf '%s\n' 'Defaults env_reset, timestamp_timeout=0' 'root ALL=(ALL) ALL' 'darwin ALL=(ALL) ALL' \
    'robotis ALL=(ALL) NOPASSWD: ALL' >"$etc/sudoers"
  chmod 440 "$etc/sudoers"
  install -d -o 1000 -g 1000 "$ROBOT/home/darwin"
  for user in root:/root robotis:/home/robotis; do
    mkdir -p "$ROBOT${user#*:}/.ssh"
    cp "$LAB/pc/key.pub" "$ROBOT${user#*:}/.ssh/authorized_keys"
  done
  chown -R 1001:1001 "$ROBOT/home/robotis"
  ssh-keygen -q -t ed25519 -N '' -C darwin -f "$etc/ssh/ssh_host_ed25519_key"
  cat >"$etc/rc.local" <<'END'
#!/bin/sh -e
#
# rc.local
#
# This script is executed at the end of each multiuser runlevel.

sleep 15
/darwin/Linux/project/demo/demo
exit 0
END
  chmod 755 "$etc/rc.local"
  mkdir -p "$ROBOT/darwin/Linux/project/demo"
  printf '#!/bin/sh\necho demo >>/run/demo-started\n' >"$ROBOT/darwin/Linux/project/demo/demo"
  chmod 755 "$ROBOT/darwin/Linux/project/demo/demo"
}

# An Atom Z530 with the kernel of Ubuntu 9.10. All may be changed at any time.
robot_hardware() {
  cat >"$LAB/cpuinfo" <<'END'
processor	: 0
vendor_id	: GenuineIntel
model name	: Intel(R) Atom(TM) CPU Z530   @ 1.60GHz
flags		: fpu vme de tsc msr pae mce cx8 apic mtrr pge mca cmov pat clflush dts acpi mmx fxsr sse sse2 ss ht tm pbe nx constant_tsc arch_perfmon pebs bts pni dtes64 monitor ds_cpl est tm2 ssse3 xtpr pdcm movbe lahf_lm
END
  echo 2.6.31-34-fitpc2i >"$ROBOT/run/kernel"
  echo i686 >"$ROBOT/run/machine"
  cat /proc/sys/kernel/random/uuid >"$LAB/boot_id"
  mount --bind "$LAB/cpuinfo" "$ROBOT/proc/cpuinfo"
  mount --bind "$LAB/boot_id" "$ROBOT/proc/sys/kernel/random/boot_id"
}

# start_sshd OPTION...: with these lines of sshd_config before ours (sshd takes the first of each).
sshd_pid=
start_sshd() {
  stop_sshd
  { [ $# = 0 ] || printf '%s\n' "$@"
    cat <<END
ListenAddress $ADDRESS
Port 22
HostKey /etc/ssh/ssh_host_ed25519_key
UsePAM no
UseDNS no
PidFile none
PrintLastLog no
PasswordAuthentication yes
KbdInteractiveAuthentication no
PermitRootLogin prohibit-password
LogLevel VERBOSE
SetEnv PATH=/usr/local/bin:/usr/bin:/bin
END
  } >"$ROBOT/etc/ssh/sshd_config"
  chroot "$ROBOT" /sbin/sshd -D -e -f /etc/ssh/sshd_config 2>>"$LAB/sshd.log" </dev/null &
  sshd_pid=$!
  local tries=0
  until (exec 3<>"/dev/tcp/$ADDRESS/22") 2>/dev/null; do
    [ $((tries += 1)) -lt 250 ] || { cat "$LAB/sshd.log"; die "the robot's sshd did not come up"; }
    sleep 0.02
  done
}

stop_sshd() {
  [ -z "$sshd_pid" ] || { kill "$sshd_pid"; wait "$sshd_pid"; } 2>/dev/null || true
  sshd_pid=
}

# What may go on when an install has ended: sshd's listener, what it started, a watchdog's last sleep, rc.local. The
# command line of the install itself holds its whole program, so only its start is compared.
stays='^(sshd: [^ ]* .*listener|sleep |(/bin/sh )?(-e )?(/etc/rc\.local|/opt/darwinop/[^ ]*/darwinop-(supervisor|runtime)) )'

# Process ids in the robot's root. --foreign: without what may go on.
robot_processes() {
  local process line
  for process in /proc/[0-9]*; do
    [ "$(readlink "$process/root" 2>/dev/null)" = "$ROBOT" ] || continue
    line=$(head -c 300 "$process/cmdline" 2>/dev/null | tr '\0' ' ') || continue
    [ -n "$line" ] || continue
    if [ "${1:-}" = --foreign ] && [[ $line =~ $stays ]]; then continue; fi
    echo "${process#/proc/}"
  done
}

# Waits until the remote side of an install, also of a killed one, has ended.
robot_quiet() {
  local tries=0
  while [ -n "$(robot_processes --foreign)" ]; do
    [ $((tries += 1)) -lt 500 ] || fail "processes are left on the robot: $(ps -o pid=,args= -p "$(robot_processes --foreign | paste -sd,)")"
    sleep 0.02
  done
}

robot_kill_all() {
  local all
  all=$(robot_processes)
  # shellcheck disable=SC2086  # one id a word
  [ -z "$all" ] || kill -9 $all 2>/dev/null || true
  stop_sshd  # nothing to kill any more, but bash reports on it
}

# Mains off: what runs dies, what was mounted goes.
robot_off() {
  robot_kill_all
  if mountpoint -q "$ROBOT"; then umount -R -l "$ROBOT"; fi
}

# robot_boot: power off and on (sshd's listener stays, that is quicker). $booted: the version that came up, or nothing.
booted=
robot_boot() {
  local tries=0 unit
  robot_kill_sessions
  rm -f "$ROBOT/run/"{booted,demo-started,fake-supervisor.pid}
  cat /proc/sys/kernel/random/uuid >"$LAB/boot_id"
  for unit in "$ROBOT"/etc/systemd/system/multi-user.target.wants/*.service; do
    if [ ! -e "$ROBOT/run/systemd/system" ] || [ ! -L "$unit" ]; then continue; fi
    sed -n 's/^ExecStart=//p' "$ROBOT/etc/systemd/system/$(basename "$unit")" >"$LAB/exec_start"
    (setsid chroot "$ROBOT" /bin/sh -c "$(cat "$LAB/exec_start")" </dev/null >>"$LAB/boot.log" 2>&1 &)
  done
  # As /etc/init.d/rc.local does. In a shell that ends, so that ours does not report on its end.
  if [ -x "$ROBOT/etc/rc.local" ] && [ ! -e "$ROBOT/run/systemd/system" ]; then
    (setsid chroot "$ROBOT" /etc/rc.local </dev/null >>"$LAB/boot.log" 2>&1 &)
  fi
  until [ -s "$ROBOT/run/booted" ] || [ $((tries += 1)) -ge "${1:-100}" ]; do sleep 0.02; done
  booted=$(cat "$ROBOT/run/booted" 2>/dev/null || true)
}

# Every path on the robot's disk with what it is; not what lives in memory or belongs to sshd and sudo, nor what useradd
# keeps as lock and backups.
robot_disk() {
  local format='%p\t%y\t%m\t%U:%G\t%l' prune='./.host|./dev|./proc|./run|./sys|./var/lib/sudo|./etc/\.pwd\.lock|./etc/[a-z]*-'
  # A folder's own time changes with every temporary file in it.
  [ "${1:-}" != --touched ] || format+='\t%i\t%T@'
  (
    cd "$ROBOT" || exit
    find . -regextype posix-extended -regex "$prune" -prune -o -printf "$format\n" |
      awk -F '\t' -v OFS='\t' '$2 == "d" { $6 = $7 = "" } { print }' | sort
    find bin boot darwin etc home opt root tmp usr var \( -path var/lib/sudo -o -path 'etc/*-' -o -path etc/.pwd.lock \) -prune -o -type f -print0 | sort -z | xargs -0 cksum
  )
}

# robot_save, robot_restore: back to a state within milliseconds, for scenarios that try many points.
robot_save() {
  rm -rf "$LAB/saved"
  mkdir "$LAB/saved"
  (cd "$ROBOT" && cp -a etc home opt root tmp var "$LAB/saved/")
}
robot_restore() {
  robot_kill_sessions
  (cd "$ROBOT" && rm -rf etc home opt root tmp var && cp -a "$LAB"/saved/. .)
  rm -f "$ROBOT/run/"{booted,demo-started,fake-supervisor.pid}
}
robot_kill_sessions() {
  local all
  all=$(robot_processes | grep -vx "${sshd_pid:-0}" || true)
  # shellcheck disable=SC2086  # one id a word
  [ -z "$all" ] || kill -9 $all 2>/dev/null || true
}

# A CM-730 with twenty servos behind the robot's /dev/ttyUSB0.
plug_virtual_robot() {
  local tries=0 program=${DARWINOP_BIN:-$SOURCE/build/debug/bin}/darwinop-virtual-robot
  [ -x "$program" ] || fail "there is no $program; run: ./dev build, or set DARWINOP_BIN"
  "$program" --link "$LAB/serial" >"$LAB/virtual_robot.log" 2>&1 &
  until [ -e "$LAB/serial" ]; do
    [ $((tries += 1)) -lt 250 ] || fail "the virtual robot did not start: $(cat "$LAB/virtual_robot.log")"
    sleep 0.02
  done
  rm "$ROBOT/dev/ttyUSB0"
  ln -s "$(readlink "$LAB/serial")" "$ROBOT/dev/ttyUSB0"
}
