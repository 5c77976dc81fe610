#!/usr/bin/env bash
# Each machine of tools/robot-vm/machines is complete and has a deep stage, which builds for that machine and tests it.
set -euo pipefail
source=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.." && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT

wrong() {
  echo "robot-vm: $*" >&2
  exit 1
}

# A tree with the real stages, where builds and tests only report what they were started for.
mkdir -p "$tree/tests/vm" "$tree/tools"
cp -a "$source/tools/test" "$tree/tools/"
cat >"$tree/tools/test/ctest.sh" <<'END_OF_STUB'
builds() { grep -q '^# builds: ' "$0"; }
build_robot() { echo "bundle for $1"; }
END_OF_STUB
printf '#!/bin/sh\necho "machine $ROBOT_VM_MACHINE"\n' >"$tree/tests/vm/robot_vm_test.sh"
chmod +x "$tree/tests/vm/robot_vm_test.sh"

count=0
for file in "$source"/tools/robot-vm/machines/*.sh; do
  machine=$(basename -s .sh "$file")
  stage=vm-$machine
  [ "$machine" != i686 ] || stage=vm
  [[ " $("$source/tools/test/run.sh" --list deep) " == *" $stage "* ]] || wrong "$machine has no deep stage $stage"
  # As run.sh starts it: with a path from the top folder.
  output=$(cd "$tree" && "tools/test/$stage.sh") || wrong "stage $stage cannot start"
  [ "$output" = "bundle for $machine"$'\n'"machine $machine" ] || wrong "stage $stage does not test $machine: $output"

  for name in description debian kernel user ways preset qemu console boot_limit; do
    # shellcheck source=../../tools/robot-vm/machines/i686.sh
    value=$(. "$file" && echo "${!name:-}")
    [ -n "$value" ] || wrong "$file has no $name"
  done
  # shellcheck source=../../tools/robot-vm/machines/i686.sh
  preset=$(. "$file" && echo "$preset")
  grep -q "\"name\": \"$preset\"" "$source/CMakePresets.json" || wrong "$machine: there is no preset $preset"
  grep -q "^| \`$machine\`" "$source/docs/robot-vm.md" || wrong "docs/robot-vm.md does not list $machine"
  count=$((count + 1))
done
[ "$count" -ge 4 ] || wrong "only $count machines: owners have i686, amd64, armhf and aarch64"
