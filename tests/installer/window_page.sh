#!/usr/bin/env bash
# Messages sent and received by a page of the robot window: window_page.sh URL monitor|steering [WORDS...]. WORDS are sent ten times a
# second, each once, the last again and again, as a page does; what comes is printed as it comes, frames and all.
url=${1#http://}
host=${url%%/*}
channel=$2
shift 2
exec 3<>"/dev/tcp/${host%:*}/${host#*:}" || exit 9
printf 'GET /%s%s HTTP/1.1\r\nHost: %s\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n' \
  "${url#*/}" "$channel" "$host" >&3
printf 'Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Protocol: darwinop-%s.1\r\n\r\n' "$channel" >&3
until read -r line <&3 && [ "$line" = $'\r' ]; do :; done
cat <&3 &
trap 'kill %1' EXIT
trap 'exit 0' TERM

# A masked frame of text, the mask being 0.
say() { printf '%b\0\0\0\0%s' "\\x81\\x$(printf %x $((128 + ${#1})))" "$1" >&3; }

while [ $# -gt 0 ]; do
  say "$1" || exit 0
  [ $# = 1 ] || shift
  sleep 0.1
done
