# shellcheck shell=bash disable=SC2154
# The virtual robot as the scenario sees it. Sourced by robot_vm_test.sh, which sets $repository and $scratch. Sets what the
# table of the machine has: $user, $demo, $ways, $preset.

export ROBOT_VM=$scratch/vm
home=/opt/darwinop
# shellcheck source=../../tools/robot-vm/machines/i686.sh
. "$repository/tools/robot-vm/machines/${ROBOT_VM_MACHINE:-i686}.sh"

vm() { "$repository/tools/robot-vm.sh" "$@"; }
# As root, through the testers' door; the installer goes in as $user, with the password.
guest() { vm ssh "$@"; }

say() { printf '%4d s  %s\n' $((SECONDS - started)) "$*"; }
fail() {
  say "FAILED: $*"
  echo "--- the last command:"
  cat "$scratch/install.log" || true
  echo "--- the machine:"
  guest "ls -l $home; tail -n 30 $home/log/*.log" || true
  exit 1
}

# install ARGUMENTS...: the command under test. What it says is in install.log. A busy PC makes the emulated USB too slow
# for a cycle of 16 ms, and then the self-test rightly fails: that is this PC's fault, and another try is fair.
install() {
  local tries=0
  until install_once "$@"; do
    grep -q '^FAIL  a full cycle takes' "$scratch/install.log" || return 1
    [ $((tries += 1)) -lt 4 ] || return 1
    say "this PC is too busy: $(grep '^FAIL  a full cycle takes' "$scratch/install.log"); trying again"
    sleep 20
  done
}

# What stands behind -- goes to the controller.
for_controller=()
install_once() {
  DARWINOP_PASSWORD=111111 "$repository/installer/darwinop-install" --new-host -p "$ROBOT_VM_PORT" -F none \
    -o UserKnownHostsFile="$scratch/known_hosts" -o IdentitiesOnly=yes "$@" "$user@127.0.0.1" "${for_controller[@]}" \
    >"$scratch/install.log" 2>&1 </dev/null
}

# said TEXT: the last install said so.
said() { grep -q -e "$1" "$scratch/install.log" || fail "it did not say '$1'"; }

# --- judged on this side of the cable -------------------------------------------------------------------------------

# joint NAME: where the virtual robot's body has it, rad; trunk_x: its trunk, m.
joint() { vm joints | tr ' ' '\n' | sed -n "s/^$1=//p"; }

# moves SECONDS: within that time the head turns to both sides. hello_head takes it 0.6 rad to each in 4 s; what the
# runtime does by itself, going to the start pose or sitting down, takes it to the middle at most.
moves() {
  local sides='' end=$((SECONDS + $1))
  while [ $SECONDS -lt $end ]; do
    sides=$sides$(joint Neck | awk '$1 > 0.3 { print "left" } $1 < -0.3 { print "right" }')
    [[ $sides != *left* || $sides != *right* ]] || return 0
    sleep 0.5
  done
  return 1
}

expect_motion() {
  moves 90 || fail "$1: the default controller does not move the virtual joints"
  say "$1: the default controller came up by itself and moves the head, $(joint Neck) rad"
}

# --- judged in the machine -----------------------------------------------------------------------------------------

# The version that runs, after a check that every file of it is as its MANIFEST says and that the programs are its own.
whole_version() {
  guest "cd $home/current/ || exit
    sed 's/^[0-9]* [0-9]* //' MANIFEST | while read -r path; do cksum \"\$path\"; done | cmp - MANIFEST || exit
    for program in supervisor runtime; do
      ls -l /proc/[0-9]*/exe 2>/dev/null | grep -q -e \"-> \$(readlink -f .)/bin/darwinop-\$program\\$\" ||
        { echo \"no \$program of this version runs\" >&2; exit 1; }
    done
    cat VERSION"
}

expect_version() {
  local version
  version=$(whole_version) || fail "$2: what runs is not one whole version"
  [[ " $1 " == *" $version "* ]] || fail "$2: version $version runs, not $1"
  say "$2: version $version runs, and is whole"
}

# Every file with kind, mode, owner and size; with its digest where an installer could have been at work. Left out is
# what Debian writes by itself: the random seed, the logs of logins, and sudo's note that the user has used it.
# Of the users' files only the contents: useradd and userdel rewrite them, and keep backups and a lock.
listing() {
  guest "find / -xdev \( -path /var/lib/systemd/random-seed -o -path /var/log/wtmp -o -path /var/log/btmp \
      -o -path /var/log/lastlog -o -path /home/$user/.sudo_as_admin_successful -o -path '/tmp/systemd-private-*' -o -path '/var/tmp/systemd-private-*' \
      -o -path '/etc/passwd*' -o -path '/etc/group*' -o -path '/etc/shadow*' -o -path '/etc/gshadow*' -o -path '/etc/sub[ug]id*' \
      -o -path /etc/.pwd.lock \) -prune \
      -o -type d -printf '%p %y %m %U:%G\n' -o -printf '%p %y %m %U:%G %s %T@ %l\n' | sort
    find /boot /etc /home /opt /root /srv /usr/local /var/spool ${demo:+/darwin} -xdev -type f \
      ! -name .sudo_as_admin_successful ! -path '/etc/*-' ! -path /etc/.pwd.lock -exec cksum {} + | sort -k 3"
}

# power_cut NAME CONDITION ARGUMENTS...: installs, and cuts the machine's power as soon as CONDITION, a command for the
# machine's shell, is true.
power_cut() {
  local name=$1 condition=$2 installing
  shift 2
  : >"$scratch/watch"  # The last cut's word must be gone before the loop below looks for this one's.
  guest "until $condition; do sleep 0.05; done; echo now" >"$scratch/watch" &
  install "$@" &
  installing=$!
  until grep -q now "$scratch/watch"; do
    kill -0 $installing 2>/dev/null || fail "the installation ended before the power cut $name"
    sleep 0.02
  done
  vm kill
  wait || true
  say "power cut $name; the installer had said: $(grep -v "$msg_lost" "$scratch/install.log" | tail -n 1)"
  grep -q "$msg_lost" "$scratch/install.log" || fail "the installer did not notice the power cut $name"
}
