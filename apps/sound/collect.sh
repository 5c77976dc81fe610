#!/bin/sh
# collect.sh PROGRAM FOLDER SYSTEM CORE LOADER STRIP OBJDUMP: creates FOLDER with the program, its libraries, their loader,
# the voices, and the ALSA configuration for the robot's sound card. SYSTEM and CORE are the sysroot's folders of libraries,
# STRIP and OBJDUMP programs for the robot's architecture.
set -eu
program=$1 folder=$2 system=$3 core=$4 loader=$5 strip=$6 objdump=$7
here=$(dirname "$(readlink -f "$0")")

rm -rf "$folder"
mkdir -p "$folder"
"$strip" -o "$folder/darwinop-sound" "$program"
cp "$here/alsa.conf" "$folder"

needed() { "$objdump" -p "$1" | sed -n 's/^ *NEEDED *//p'; }
collect() {
  needed "$1" | while read -r library; do
    case $library in ld-linux*) continue ;; esac
    [ ! -e "$folder/$library" ] || continue
    for place in "$core" "$system"; do
      [ ! -e "$place/$library" ] || cp -L "$place/$library" "$folder/"
    done
    [ -e "$folder/$library" ] || { echo "collect.sh: $1 needs $library, which the sysroot does not have" >&2; exit 1; }
    collect "$folder/$library"
  done
}
collect "$program"
# The name that connect/sound_program.cpp looks for, on every architecture.
cp -L "$loader" "$folder/ld-linux.so.2"

# The languages that the robot spoke in 2013 (docs/sound.md), without three whose dictionaries take 4.2 MB: Russian and
# the two of Chinese.
languages='af bs ca cs cy da de el en eo es fi fr grc hi hr hu hy hyw id is it jbo ka kn ku la lv mk ml nb nci nl pap pl
  pt ro sk sq sr sv sw ta tr vi'
from=$system/espeak-ng-data
to=$folder/espeak-ng-data
mkdir -p "$to/voices/!v"
cp "$from/phontab" "$from/phonindex" "$from/phondata" "$from/intonations" "$to"
for language in $languages; do
  case $language in nb) dictionary=no ;; hyw) dictionary=hy ;; *) dictionary=$language ;; esac
  cp "$from/${dictionary}_dict" "$to"
  find "$from/lang" \( -name "$language" -o -name "$language-*" \) -type f | while read -r file; do
    mkdir -p "$to/$(dirname "${file#"$from/"}")"
    cp "$file" "$to/${file#"$from/"}"
  done
done
for variant in m1 m2 m3 m4 m5 m6 m7 m8 f1 f2 f3 f4 f5 croak whisper; do cp "$from/voices/!v/$variant" "$to/voices/!v"; done
