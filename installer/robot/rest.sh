# shellcheck shell=sh disable=SC2154  # variables are shared with the other files
# State of the robot, and the report of it at the end of a session.

robot_driver() { "$home/current/bin/darwinop-runtime" --status 2>/dev/null | sed -n 's/^driver  *pid \([0-9]*\),.*/\1/p'; }
robot_state() { "$home/current/bin/darwinop-runtime" --status 2>/dev/null | sed -n 's/^state  *//p'; }

# Prints the last line. Waits for a robot that is kneeling; one that holds may still kneel, or is configured to hold.
report_rest() {
  looks=0 limp=0 held=0 held_longest=15  # without a reader, `say` fails
  # A killed server has not ended its session: the safety layer ends it after gone_s.
  [ "${status:-0}" -lt 128 ] || held_longest=60
  while state=$(robot_state); do
    case $state in
      *limp*)
        # Checked twice: a client that has just connected may be taking over.
        [ $limp = 0 ] || { say "$msg_limp"; return; }
        limp=1 held=0
        ;;
      '') say "$msg_state_unknown: $msg_no_runtime. Check with: darwinop install --status"; return ;;
      offline*) say "$msg_state_unknown: its board does not respond. Check its power"; return ;;
      holding*) limp=0 held=$((held + 1)) ;;
      driven*)
        driver=$(robot_driver)
        [ -z "$driver" ] || { say "$msg_now_driven, process $driver"; return; }
        ;;
      *) limp=0 held=0 ;;
    esac
    looks=$((looks + 1))
    if [ $held -ge $held_longest ] || [ $looks -ge 150 ]; then break; fi
    nap
  done
  say "the robot is still under torque ($state): hold it, or release it with 'darwinop runtime --release' on the robot or its MODE button"
}
