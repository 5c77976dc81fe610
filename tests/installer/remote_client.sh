#!/usr/bin/env bash
# A controller that drives by remote control: remote_client.sh [FILE]. It says "driving" after the first reply, nods until
# SIGINT, then says "kneeling", waits a moment with the connection in use, and ends with 7. While FILE is there it is
# ignores SIGINT.
address=${DARWINOP_ROBOT#tcp://}
exec 3<>"/dev/tcp/${address%:*}/${address#*:}" || exit 9
stopped=0
trap '[ -e "${1:-/none}" ] || stopped=1' INT
trap 'exit 143' TERM HUP

# Neck (18) to 0.5 rad, its position asked for; the answer is 10 bytes.
ask() {
  printf '\x57\x0d\x00\x53\x12\x70\x00\x00\x01\x45\x50\x12\x00' >&3 || exit 8
  [ "$(head -c 10 <&3 2>/dev/null | wc -c)" = 10 ] || [ $stopped = 1 ] || { echo "the server has left"; exit 8; }
}

ask
echo driving
while [ $stopped = 0 ]; do
  ask
  sleep 0.02
done
echo kneeling
for ((i = 0; i < 10; i++)); do
  ask
  sleep 0.02
done
exit 7
