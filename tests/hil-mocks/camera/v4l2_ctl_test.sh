#!/usr/bin/env bash
# The virtual camera as a program sees it that knows nothing of us: v4l2-ctl of v4l-utils.
# v4l2_ctl_test.sh CAMERA formats|stream|counts|faults|status, CAMERA being the program darwinop-virtual-camera.
set -euo pipefail
camera=$1 scenario=$2

fail() {
  echo "v4l2_ctl_test: $*" >&2
  exit 1
}
command -v v4l2-ctl >/dev/null || fail "there is no v4l2-ctl: install v4l-utils"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

readonly bytes=$((640 * 480 * 2))
stream() { # [OPTION...]: 30 frames of 640x480 to $folder/film, what v4l2-ctl tells to $folder/log
  "$camera" --pattern bars "$@" -- v4l2-ctl --set-fmt-video=width=640,height=480,pixelformat=YUYV --verbose \
    --stream-mmap=4 --stream-count=30 --stream-to="$folder/film" >"$folder/log" 2>&1
}
refuses() { # FAULT WORDS: it does not stream, for the reason that v4l2-ctl tells in these words
  ! stream --fault "$1" || fail "it streams although the camera's fault is $1"
  grep -q "$2" "$folder/log" || fail "$1 is not told as '$2': $(cat "$folder/log")"
}
pixels() { # OFFSET: a pair of pixels of the last frame, as hexadecimal Y U Y V
  od -An -tx1 -j$((29 * bytes + $1)) -N4 "$folder/film" | tr -d ' '
}
numbers() { sed -n 's/^cap dqbuf:.* seq: *\([0-9]*\) .*/\1/p' "$folder/log"; }

case $scenario in
  formats)
    "$camera" -- v4l2-ctl --list-formats-ext >"$folder/formats"
    grep -q "'YUYV'" "$folder/formats" || fail "YUYV is not listed: $(cat "$folder/formats")"
    sizes=$(sed -n 's/.*Size: Discrete //p' "$folder/formats" | tr '\n' ' ')
    [ "$sizes" = "320x240 640x360 640x400 640x480 768x480 800x600 " ] || fail "sizes are $sizes"
    grep -q '28.000 fps' "$folder/formats" || fail "768x480 does not come at 28 fps"
    grep -q '22.500 fps' "$folder/formats" || fail "800x600 does not come at 22.5 fps"
    ;;
  stream)
    stream || fail "v4l2-ctl failed: $(cat "$folder/log")"
    got=$(stat -c %s "$folder/film")
    [ "$got" = $((30 * bytes)) ] || fail "30 frames of $bytes bytes are not $got bytes"
    # The camera hangs upside down: the last row begins with the black bar's right end and ends with the grey one.
    [ "$(pixels $((bytes - 4)))" = bf80bf80 ] || fail "the upper left is $(pixels $((bytes - 4))), not grey"
    [ "$(pixels $((bytes - 1280)))" = 00800080 ] || fail "the upper right is $(pixels $((bytes - 1280))), not black"
    ;;
  counts)
    stream || fail "v4l2-ctl failed: $(cat "$folder/log")"
    [ "$(numbers | wc -l)" = 30 ] || fail "not 30 frames: $(cat "$folder/log")"
    [ "$(numbers | head -1)" = 0 ] || fail "the first frame is number $(numbers | head -1)"
    diff <(numbers) <(numbers | sort -n -u) >&2 || fail "the numbers of the frames do not grow"
    stream --fault drops || fail "v4l2-ctl failed: $(cat "$folder/log")"
    [ "$(numbers | wc -l)" = 30 ] || fail "not 30 frames: $(cat "$folder/log")"
    numbers | awk '$1 % 3 == 2 { exit 1 }' || fail "no frame was lost: $(numbers | tr '\n' ' ')"
    ;;
  faults)
    refuses gone 'Cannot open device /dev/video0\|No such file or directory'
    refuses no-access 'Permission denied'
    refuses busy 'STREAMON.*Device or resource busy'
    "$camera" --fault other-format -- v4l2-ctl --list-formats | grep -q MJPG || fail "it still gives YUYV"
    ;;
  status)
    status=0
    "$camera" -- sh -c 'exit 7' || status=$?
    [ $status = 7 ] || fail "the command's status 7 became $status"
    status=0
    "$camera" -- "$folder/nothing" 2>/dev/null || status=$?
    [ $status = 127 ] || fail "a command that does not exist gives $status"
    status=0
    # shellcheck disable=SC2016  # for the inner shell
    "$camera" -- sh -c 'trap "exit 9" TERM; kill -TERM $PPID; while :; do sleep 0.05; done' || status=$?
    [ $status = 9 ] || fail "SIGTERM was not passed on: $status"
    status=0
    "$camera" --for 0.3 --file "$folder/frames" -- sleep 60 || status=$?
    [ $status = 143 ] || fail "the command outlives --for: $status"
    [ ! -e "$folder/frames" ] || fail "the frame file is left"
    ;;
  *) fail "no scenario $scenario" ;;
esac
