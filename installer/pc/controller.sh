# shellcheck shell=sh
# `darwinop install --controller DIR [--run | --make-default]`, --stop and --logs: the PC's side.
# In: what arguments.sh has set, $controller_action first. Out: the exit status; 3 when the start pose is not safe.

controller_main() {
  phase_count=5
  [ "$controller_action" != send ] || phase_count=4
  case $controller_action in
    send | run | make-default)
      [ "$controller_action" != send ] || [ -z "$controller_arguments" ] || die -2 "arguments after -- need --run"
      phase "building the controller"
      compile_controller "$controller_dir"  # first: who has a slip in the source needs no password
      if [ "${dry_run:-0}" = 1 ]; then
        list_parcel
        return
      fi
      connect
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
      tell_ending $?
      ;;
    make-default) robot_run make_default "$controller_name" </dev/null ;;
    no-default) robot_run make_no_default </dev/null ;;
    stop) robot_run stop_controllers </dev/null ;;
    logs)
      if [ "${logs_follow:-0}" = 1 ]; then
        attended '' show_logs 1
      else
        robot_run show_logs 0 </dev/null
      fi
      ;;
  esac
}

on_signal=ask_to_stop  # what Ctrl-C does while somebody is attended

list_parcel() {
  say "dry run: $controller_name would be sent to $target, with:"
  list_data_files "$controller_folder" "$controller_name" | sed 's/^\.\//  /' >&2
}

# Program and data as one archive through one session. What the robot has now stays until all of it has come.
send_controller() {
  pack_controller
  say "sending $controller_name with $data_count other files"
  phase "sending $controller_name"
  # shellcheck disable=SC2086  # checksum and length
  send_with_progress "$connection/controller.tar.gz" "${archive_sum#* }" "unpacking $controller_name on the robot" |
    robot_run receive_controller "$controller_name" "$kilobytes" $archive_sum
  status=$?
  phase_number=$((phase_number + 1))  # unpacking began in a shell of its own
  [ $status != 255 ] || die "the link to the robot was lost while $controller_name was sent; what the robot had is still there. Try again"
  [ $status = 0 ] || exit $status
}

pack_controller() { # -> kilobytes data_count archive_sum
  { mkdir "$connection/program" && install -m 755 "$controller_program" "$connection/program/$controller_name"; } ||
    die "cannot write to $connection: is the disk full?"
  list_data_files "$controller_folder" "$controller_name" >"$connection/data-files"
  data_count=$(grep -c . "$connection/data-files")
  # Links are followed: the robot gets what they lead to. The owner is the robot's. What only you may read only the
  # controller can read there.
  tar -cf "$connection/controller.tar" --format=gnu --owner=0 --group=0 --numeric-owner --mode=a-s,u+rwX,go-w \
    --dereference --hard-dereference --no-recursion --verbatim-files-from -C "$controller_folder" -T "$connection/data-files" \
    -C "$connection/program" "./$controller_name" || die "cannot pack $controller_folder; see the line above"
  kilobytes=$(($(wc -c <"$connection/controller.tar") / 1024 + 1))
  gzip "$connection/controller.tar" || die "cannot write to $connection: is the disk full?"
  archive_sum=$(cksum <"$connection/controller.tar.gz")
  close_build_cache
}

# attended NAME FUNCTION ARGUMENTS...: a function on the robot that goes on until we end its stdin, with its output as it
# comes. A line a second says that we are still there. Ctrl-C ends stdin and waits for the tidy end.
attended() {
  attended_name=$1
  shift
  mkfifo "$connection/attended" || die "cannot write to $connection"
  asked_to_stop=0
  exec 9<>"$connection/attended"
  # ssh must live until the robot has answered: in a session of its own it does not see Ctrl-C.
  ssh_apart=
  ! command -v setsid >/dev/null || ssh_apart=setsid
  {
    trap '' HUP  # a terminal that goes away tells its whole group; only the script itself acts on it
    robot_run "$@" <"$connection/attended"
    echo $? >"$connection/ended.new"
    mv "$connection/ended.new" "$connection/ended"
    kill -0 $$ 2>/dev/null || disconnect  # this script was killed: nobody else will
  } 9>&- &
  session=$!
  ssh_apart=
  # Ends when this script does, even if it is killed.
  { trap '' HUP; while echo && sleep 1 >/dev/null 9>&- && kill -0 $$ 2>/dev/null; do :; done; } >&9 2>/dev/null &
  beat=$!
  trap '"$on_signal"' INT HUP
  trap ask_to_stop TERM
  # A signal ends wait early; the session has ended when its status is there.
  until [ -s "$connection/ended" ]; do
    wait "$session"
    kill -0 "$session" 2>/dev/null || [ -s "$connection/ended" ] || echo 255 >"$connection/ended"
  done
  end_on_signals
  exec 9>&-
  kill "$beat" 2>/dev/null
  return "$(cat "$connection/ended")"
}

# On Ctrl-C. Closing is all that is needed: the robot's side does the rest, as it would if the link were lost.
ask_to_stop() {
  if [ "$asked_to_stop" = 1 ]; then
    [ -z "$attended_name" ] || say "$attended_name is already being stopped; please wait (10 s at most, then it is ended). In danger press MODE on the robot"
    return
  fi
  asked_to_stop=1
  : >"$connection/stopping"  # for what runs beside us
  kill "$beat" 2>/dev/null
  exec 9>&-
  [ -z "$attended_name" ] || say "stopping $attended_name"
}

# The controller's status is ours; a crash is said in words.
tell_ending() { # STATUS
  case $1 in
    132) say "$error_mark$controller_name crashed: it came to an instruction that this processor does not have (signal 4)" ;;
    134) say "$error_mark$controller_name crashed: it gave up by itself, by abort(), an assert or an uncaught exception (signal 6)" ;;
    135 | 139) say "$error_mark$controller_name crashed: it used memory that is not its own, such as a null pointer or an index too large (signal $(($1 - 128)))" ;;
    136) say "$error_mark$controller_name crashed: a whole number was divided by zero (signal 8)" ;;
    137) say "$error_mark$controller_name was ended by force (signal 9)" ;;
    255)
      # A controller may end with 255, too.
      ssh_call -O check "$target" >/dev/null 2>&1 ||
        say "${error_mark}the link to the robot was lost; $controller_name is stopped there within 10 s. Look at --logs"
      ;;
  esac
  return "$1"
}
