/* What people and processes do, and what breaks: the choices of one cycle. Part of robot.pml. */

/* People and processes: at most one acts in a cycle. */
/* A release is noted in a file within a few cycles; a process that dies before is not considered. */
#define NOTED (!released || remembered || (BOARD && by_reset))
/* Servos alone: after their supply was cut under torque nothing else breaks until that is noted or a person acts. */
#define UNNOTICED (!BOARD && released && by_reset && !remembered)
#define START_COUNTS (withheld || (fact && !DRIVES(state)))  /* BoardWatch::update; fact: a latched fault is active */
#define FREE (!session || ended || silence == 2)
inline choose_who_acts() {
  act = A_NOBODY;
  if
  :: calm -> the_way_out()
  :: !calm ->
     if
     :: skip
#ifndef NO_PEOPLE
     :: BOARD && process != DOWN -> act = A_MODE
     :: BOARD && process == RUNNING && START_COUNTS -> act = A_START
     :: process == RUNNING -> act = A_RESET
     :: process == RUNNING -> act = A_RELEASE
#endif
     :: process == RUNNING && FREE -> act = A_COMES; if :: in_place_now = 0 :: in_place_now = 1 fi
     :: process == RUNNING && FREE && automatic -> act = A_RESTARTED; if :: in_place_now = 0 :: in_place_now = 1 fi
     :: process == RUNNING && session && !ended -> if :: act = A_ENDS :: act = A_FAILS fi
     :: process == RUNNING && session && !ended && silence < 2 && state != ST_starting ->
        act = A_HANGS
     :: process == RUNNING && silence == 1 -> act = A_GOES_ON
#ifndef FIXED_PROCESSES
     :: process == RUNNING && NOTED -> act = A_RUNTIME_DIES
     :: process != DOWN && NOTED -> act = A_SUPERVISOR_DIES
#endif
     :: process == DOWN -> act = A_BOOTS
     fi
  fi
}

/* What a person does who wants the robot to move (1), or to release it (2), and reads what docs/faults.md says: nothing
   breaks any more. */
inline the_way_out() {
  if
  :: process == DOWN -> act = A_BOOTS
  :: process == RESCUING -> skip                                /* waits for its end */
#if WAY_OUT == 2
  :: process == RUNNING && !mode_pressed -> act = A_MODE; mode_pressed = 1
  :: process == RUNNING && mode_pressed -> skip
#else
  :: process == RUNNING && FREE -> act = A_COMES; if :: in_place_now = 0 :: in_place_now = 1 fi
  :: process == RUNNING && !FREE && silence == 1 -> act = A_GOES_ON
  :: process == RUNNING && START_COUNTS -> act = (BOARD -> A_START : A_RESET)
  :: process == RUNNING && !FREE && silence == 0 && !START_COUNTS -> skip
#endif
  fi
}

inline carry_out() {
  came = NOBODY;
  if
  :: act == A_MODE || act == A_RELEASE -> released = 1; by_reset = 0
  :: act == A_START || act == A_RESET -> released = 0
  :: act == A_COMES -> came = PERSON; released = 0          /* a person starts a controller */
  :: act == A_RESTARTED -> came = PROGRAM; automatic = 0    /* the supervisor starts it again */
  :: act == A_ENDS -> ended = 1; automatic = 0              /* exit code 0 */
  :: act == A_FAILS -> ended = 1; automatic = 1             /* another exit code */
  :: act == A_HANGS -> silence++; automatic = 1             /* hangs or was killed */
  :: act == A_GOES_ON -> silence = 0
  :: act == A_RUNTIME_DIES -> forget_guard(); process = RESCUING; session = 1; ended = 1; automatic = 0
  :: act == A_BOOTS -> remembered = 0; held = 0; forget_guard(); process = RUNNING; released = 0; mode_pressed = 0  /* --restart-controller, or the power switch */
  :: act == A_SUPERVISOR_DIES -> forget_guard(); process = RUNNING; automatic = 1  /* systemd starts another one */
  :: else -> skip
  fi
}

/* Board and servo: at most one thing breaks in a cycle, before or after the write. Charge and heat, which the guard reads
   before it writes, are tried where they change anything: one for both as long as their rows are the same. */
inline choose_what_breaks() {
  broken = B_NOTHING;
  if
  :: skip
  :: BOARD && !calm && board_power -> broken = B_RESET
  :: !BOARD && !UNNOTICED && !calm && boot == 0 -> broken = B_RESET; if :: boot_now = 1 :: boot_now = SUPPLY_BOOT fi
  :: !calm && !UNNOTICED && board_power && boot == 0 -> broken = B_RAIL;
     if :: boot_now = 0 :: boot_now = 1 :: boot_now = MAXBOOT fi  /* 0: it is back before it is asked */
  :: !calm && (s_on || phase == PLACED || phase == MOVING) -> broken = B_OVERLOAD
  :: !calm && up && (possible & 1) -> broken = B_EMPTY
  :: !calm && up && (possible & 2) -> broken = B_OVERHEAT
  :: !calm && up && (possible & 4) -> broken = B_MINOR
#ifdef ON_FALL
  :: !calm && up -> broken = B_TURNS
#endif
  fi;
  if :: broken == B_RESET || broken == B_RAIL || broken == B_OVERLOAD -> if :: before_write = 0 :: before_write = 1 fi :: else -> skip fi
}

/* A servo starts with its goal where it is; a joint that was held falls from there. */
inline restart_servo() {
  kept = !s_on; servo_off(); s_shut = 0; s_reset = 1; s_placed = 0;
  s_goal_right = kept;
  boot = boot_now
}

inline something_breaks() {
  if
  :: broken == B_RESET ->                                             /* RESET, or the supply dipped */
     /* Under torque it is a person's release. Before a loop has had its first answer it is one only if an earlier loop
        has noted that it held joints: without both a board without servo power is a board that was just switched on.
        Servos alone: before the first look. */
     if :: s_on && ((BOARD && ever) || polled || held) && !released -> released = 1; by_reset = 1 :: else -> skip fi;
     if
     :: BOARD -> board_power = 0; servo_off()
     :: else -> restart_servo(); by_supply = 1; quiet = boot_now; up = 0
     fi
  :: broken == B_RAIL && boot == 0 -> restart_servo()                 /* the rail or the chain dipped */
  :: broken == B_OVERLOAD && s_on -> servo_off(); s_shut = 1          /* it shuts itself off */
  :: else -> skip
  fi
}

/* Wire: one write lost, or an outage. */
inline choose_wire() {
  wire = W_FINE;
#ifndef NO_WIRE
  if
  :: skip
  :: !calm && since_wire >= WIRE_GAP -> if :: wire = W_WRITE_LOST :: wire = W_WRONG_BIT fi
  :: !calm && (since_wire >= WIRE_GAP || (missed > 0 && !up)) && missed < MAXMISS ->
     if :: wire = W_REPLY_LOST :: wire = W_BOTH_LOST fi
  fi
#endif
}
