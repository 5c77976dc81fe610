# shellcheck shell=bash
# A fake bundle: the layout of the real one, but its programs are shell scripts with controllable failures. Sourced by robot.sh.
#
# Files on the robot that steer them (all in /run, so they count as memory, not disk):
#   fail-self-test    darwinop-doctor fails (only in the version named in the file, if any)
#   hold-self-test    darwinop-doctor waits until it is gone; self-test-begun appears
#   start-in-self-test  darwinop-doctor runs /opt/darwinop/start, as systemd does after a failure
#   stays-stiff       darwinop-supervisor --stop: exit 1 and the file's lines
#   pose-unsafe       darwinop-runtime --check-pose: exit 3 and the file's lines
# and what they leave: booted (VERSION of the supervisor that started), doctor-calls, runtime-calls (VERSION ARGS).

# fake_bundle VERSION [KILOBYTES of ballast [ARCHITECTURE]]: prints the path of the archive.
fake_bundle() {
  local version=$1 kilobytes=${2:-20} architecture=${3:-i686} folder=$LAB/bundles/$1
  local out=$LAB/bundles/darwinop-$1-$architecture.tar.gz
  rm -rf "$folder"
  fake_bundle_folder "$version" "$kilobytes" "$folder"
  echo "$architecture" >"$folder/ARCHITECTURE"
  write_manifest "$folder"
  pack "$folder" "$out"
  echo "$out"
}

pack() { (cd "$1" && tar --owner=0 --group=0 --sort=name -cf - -- *) | gzip -n >"$2"; }

write_manifest() (
  cd "$1" || exit
  find . -type f ! -name MANIFEST -printf '%P\0' | sort -z | xargs -0 cksum >"$LAB/manifest"
  mv "$LAB/manifest" MANIFEST
)

fake_bundle_folder() {
  local version=$1 kilobytes=$2 folder=$3 name
  mkdir -p "$folder/bin" "$folder/share/darwinop"
  echo "$version" >"$folder/VERSION"
  for name in darwinop darwinop-run darwinop-runtime darwinop-doctor darwinop-supervisor; do
    { echo '#!/bin/sh'; echo "version='$version'"; "fake_${name//-/_}"; } >"$folder/bin/$name"
  done
  {
    echo '#!/bin/sh'
    echo 'mkdir -p /opt/darwinop/log'
    echo 'exec /opt/darwinop/current/bin/darwinop-supervisor --home /opt/darwinop >>/opt/darwinop/log/supervisor.log 2>&1'
  } >"$folder/share/darwinop/boot"
  chmod 755 "$folder"/bin/* "$folder/share/darwinop/boot"
  printf '%s\n' "; robot.ini of $version" '[Robot]' ';port = /dev/ttyUSB0' >"$folder/share/darwinop/robot.ini"
  # Does not shrink under gzip, the same for the same version.
  openssl enc -aes-128-ctr -pass "pass:$version" -nosalt -pbkdf2 -iter 1 </dev/zero 2>/dev/null |
    head -c $((kilobytes * 1024)) >"$folder/share/darwinop/ballast" || true
}

fake_darwinop() { echo 'echo "$version"'; }
fake_darwinop_run() {
  cat <<'END'
# Runs the controller that it was given, as the real one does: last argument folder or program.
for target; do :; done
[ ! -d "$target" ] || target=$target/$(basename "$target")
exec "$target"
END
}
fake_darwinop_runtime() {
  cat <<'END'
echo "$version $*" >>/run/runtime-calls
case " $* " in
  *--check-pose*)
    if [ -e /run/pose-unsafe ]; then cat /run/pose-unsafe; exit 3; fi
    echo "start pose: ok" ;;
esac
exit 0
END
}
fake_darwinop_doctor() {
  cat <<'END'
echo "$version $*" >>/run/doctor-calls
: >/run/self-test-begun
while [ -e /run/hold-self-test ]; do sleep 0.02; done
if [ -e /run/start-in-self-test ]; then
  /opt/darwinop/start </dev/null >/dev/null 2>&1 &
  while [ -e /opt/darwinop/pending ]; do sleep 0.02; done
fi
if [ -e /run/fail-self-test ]; then
  wanted=$(cat /run/fail-self-test)
  if [ -z "$wanted" ] || [ "$wanted" = "$version" ]; then
    echo "servo 11 (PelvR) does not answer: look at its cable"
    exit 1
  fi
fi
echo "doctor: everything is well"
exit 0
END
}
fake_darwinop_supervisor() {
  cat <<'END'
pid_file=/run/fake-supervisor.pid
running() { [ -s $pid_file ] && kill -0 "$(cat $pid_file)" 2>/dev/null; }
case " $* " in
  *" --stop "*)
    if running; then kill "$(cat $pid_file)"; rm -f $pid_file; fi
    if [ -e /run/stays-stiff ]; then cat /run/stays-stiff; exit 1; fi
    exit 0 ;;
  *" --status "*) if running; then echo "supervisor: running"; exit 0; fi; echo "supervisor: not running"; exit 1 ;;
  *" --stop-controller "* | *" --restart-controller "*) echo "$version $*" >>/run/supervisor-calls; exit 0 ;;
esac
if running; then echo "supervisor: another one runs" >&2; exit 1; fi
echo $$ >$pid_file
echo "$version" >/run/booted
trap 'exit 0' TERM INT
while :; do sleep 1000 & wait $!; done
END
}
