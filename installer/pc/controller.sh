# shellcheck shell=sh
# `darwinop install --controller DIR [--run | --make-default]`, --stop and --logs: the PC's side.
# In: variables of arguments.sh, mainly $controller_action. Out: the exit status; 3 if the start pose is not safe.

controller_main() {
  phase_count=5
  [ "$controller_action" != send ] || phase_count=4
  case $controller_action in
    send | run | make-default)
      [ "$controller_action" != send ] || [ -z "$controller_arguments" ] || die -2 "arguments after -- need --run"
      phase "building the controller"
      compile_controller "$controller_dir"  # first: reports compiler errors before asking for a password
      if [ "${dry_run:-0}" = 1 ]; then
        list_transfer
        return
      fi
      [ -n "$connection" ] || connect
      send_controller
      ;;
    stop | no-default | logs)
      phase_count=2
      connect
      ;;
  esac
  [ "$controller_action" = send ] || phase "$controller_action on the robot"
  case $controller_action in
    send) say "start it with --run, or at every boot with --make-default" ;;
    run)
      eval "set -- $controller_arguments"
      attended "$controller_name" run_controller "$controller_name" "${force:-0}" "$@"
      report_ending $?
      ;;
    make-default) at_once make_default "$controller_name" ;;
    no-default) at_once make_no_default ;;
    stop) at_once stop_controllers ;;
    logs)
      if [ "${logs_follow:-0}" = 1 ]; then
        attended '' show_logs 1
        report_lost $?
      else
        at_once show_logs 0
      fi
      ;;
  esac
}

on_signal=ask_to_stop  # action of Ctrl-C while a function on the robot is attended

list_transfer() {
  say "dry run: $controller_name would be sent to $target, with:"
  list_data_files "$controller_folder" "$controller_name" | sed 's/^\.\//  /' >&2
}

# Program and data as one archive through one session. The present files on the robot stay until it is complete.
send_controller() {
  pack_controller
  say "sending $controller_name with $data_count other files"
  phase "sending $controller_name"
  # shellcheck disable=SC2086  # checksum and length
  send_with_progress "$connection/controller.tar.gz" "${archive_sum#* }" "unpacking $controller_name on the robot" |
    robot_run receive_controller "$controller_name" "$kilobytes" $archive_sum "$(sdk_architecture)"
  status=$?
  phase_number=$((phase_number + 1))  # unpacking started in a subshell
  [ $status != 255 ] || die "$msg_robot_lost while sending $controller_name; the robot is unchanged. Try again"
  [ $status = 0 ] || exit $status
}

pack_controller() { # -> kilobytes data_count archive_sum
  { mkdir "$connection/program" && install -m 755 "$controller_program" "$connection/program/$controller_name"; } ||
    die "cannot write to $connection: is the disk full?"
  list_data_files "$controller_folder" "$controller_name" >"$connection/data-files"
  data_count=$(grep -c . "$connection/data-files")
  # Follows symbolic links. Files belong to a user of the robot; private files stay readable for the controller only.
  tar -cf "$connection/controller.tar" --format=gnu --owner=0 --group=0 --numeric-owner --mode=a-s,u+rwX,go-w \
    --dereference --hard-dereference --no-recursion --verbatim-files-from -C "$controller_folder" -T "$connection/data-files" \
    -C "$connection/program" "./$controller_name" || die "cannot pack $controller_folder; see the line above"
  kilobytes=$(($(wc -c <"$connection/controller.tar") / 1024 + 1))
  gzip "$connection/controller.tar" || die "cannot write to $connection: is the disk full?"
  archive_sum=$(cksum <"$connection/controller.tar.gz")
  close_build_cache
}

# at_once FUNCTION ARGUMENTS...: runs a function on the robot that needs no input.
at_once() {
  robot_run "$@" </dev/null
  report_lost $?
}

# What a lost connection left open.
report_lost() { # STATUS of the function
  if [ "$1" = 255 ]; then
    case $controller_action in
      stop) lost_means="the robot may still be driven; run the same command again" ;;
      logs) lost_means="nothing on the robot has changed" ;;
      *) lost_means="the robot may have changed or not; run the same command again" ;;
    esac
    die "$msg_robot_lost; $lost_means"
  fi
  return "$1"
}

# attended NAME FUNCTION ARGUMENTS...: runs a function on the robot until its stdin ends, streaming its output. Sends a
# heartbeat line per second. Ctrl-C ends stdin and waits for the normal end.
attended() {
  attended_name=$1
  shift
  mkfifo "$connection/attended" || die "cannot write to $connection"
  asked_to_stop=0
  exec 9<>"$connection/attended"
  # ssh must run until the robot has answered, so it gets its own session without Ctrl-C.
  ssh_apart=
  ! command -v setsid >/dev/null || ssh_apart=setsid
  {
    trap '' HUP  # a closing terminal signals the whole group; only this script handles it
    robot_run "$@" <"$connection/attended"
    echo $? >"$connection/ended.new"
    mv "$connection/ended.new" "$connection/ended"
    kill -0 $$ 2>/dev/null || disconnect  # this script was killed and cannot
  } 9>&- &
  session=$!
  ssh_apart=
  # Ends when this script does, even if it is killed.
  { trap '' HUP; while echo && sleep 1 >/dev/null 9>&- && kill -0 $$ 2>/dev/null; do :; done; } >&9 2>/dev/null &
  beat=$!
  trap '"$on_signal"' INT HUP
  trap ask_to_stop TERM
  # A signal ends wait early; the session has ended when its status file exists.
  until [ -s "$connection/ended" ]; do
    wait "$session"
    kill -0 "$session" 2>/dev/null || [ -s "$connection/ended" ] || echo 255 >"$connection/ended"
  done
  end_on_signals
  exec 9>&-
  kill "$beat" 2>/dev/null
  return "$(cat "$connection/ended")"
}

# On Ctrl-C: closing is sufficient; the robot's side reacts as to a lost connection.
ask_to_stop() {
  if [ "$asked_to_stop" = 1 ]; then
    [ -z "$attended_name" ] || say "$attended_name $msg_being_stopped; please wait (at most 10 s, then it is killed). In an emergency press MODE on the robot"
    return
  fi
  asked_to_stop=1
  : >"$connection/stopping"  # read by concurrent parts
  kill "$beat" 2>/dev/null
  exec 9>&-
  [ -z "$attended_name" ] || say "stopping $attended_name"
}

# Exit status is the controller's; crashes are described.
report_ending() { # STATUS
  case $1 in
    132) say "$error_mark$controller_name crashed: illegal instruction (signal 4)" ;;
    134) say "$error_mark$controller_name crashed: abort(), a failed assert or an uncaught exception (signal 6)" ;;
    135 | 139) say "$error_mark$controller_name crashed: invalid memory access, such as a null pointer or an index out of range (signal $(($1 - 128)))" ;;
    136) say "$error_mark$controller_name crashed: integer division by zero (signal 8)" ;;
    137) say "$error_mark$controller_name was killed (signal 9)" ;;
    255)
      # A controller may also return 255.
      ssh_call -O check "$target" >/dev/null 2>&1 ||
        say "${error_mark}$msg_robot_lost; $controller_name is stopped there within 10 s. See --logs"
      ;;
  esac
  return "$1"
}
