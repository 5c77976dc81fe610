/* Guard, bus, board, one servo, controller, supervisor and people: what stands between a fault and a joint that moves.

   One turn of the loop is one cycle of the runtime: somebody acts, the guard decides (safety/guard.cpp), its write goes
   out, something may break, the servo answers. All choices are nondeterministic, so the checker tries every order of
   every event. The state machine and the fault table are those of the program: tables.pml is generated from them.

   Abstractions. One joint stands for twenty. Angles are not modelled: a goal is either where the joint is or elsewhere;
   a joint that was without torque for more than DRIFT cycles is elsewhere. Long times are short or arbitrary: the end of
   a slow move, stall and silence of a controller come at any cycle. Wire: one write in WIRE_GAP may be lost, or an outage
   of up to 7 cycles; faults of the wire are at least WIRE_GAP cycles apart.

   Checked: the assertions below, named A1 to A7; with WAY_OUT also that every state has a way out (at the end). */
#include "tables.pml"

#define PATIENCE ANSWER_PATIENCE   /* missed answers of board or servo that are ridden through */
#define DRIFT    3   /* cycles: 9 ticks at 12 rad/s2 take 48 ms */
#define LOOK     2   /* stands for a round of 25: each servo's torque switch is looked at */
#ifndef REPOWERS
#define REPOWERS 1   /* board_watch.hpp, kRepowers: stands for 3 */
#endif
#define WIRE_GAP 3
#ifndef ON_EXIT
#define ON_EXIT RE_kneel  /* [Safety] on_exit: RE_hold, RE_kneel, RE_limp */
#endif
#ifndef MAXMISS
#define MAXMISS  7
#endif
#ifndef MAXBOOT
#define MAXBOOT  5
#endif

#define OUT 0
#define CONFIRMING 1
#define PLACED 2
#define MOVING 3

#define NOBODY 0     /* who acts */
#define PERSON 1
#define PROGRAM 2

#define RUNNING 0    /* the runtime process */
#define RESCUING 1   /* it died; the supervisor's own loop brings the robot to rest */
#define DOWN 2       /* nothing is started again without a person */

#define DRIVES(s) (s != ST_offline && s != ST_limp && s != ST_found_stiff)

c_code {
  /* Active faults after a cycle with these causes. */
  static int noted(int active, int cause) {
    for (int i = 0; i < NFAULTS; ++i)
      if (!(cause >> i & 1) && !latched_table[i]) active &= ~(1 << i);
    return active | cause;
  }
  static int worst_reaction(int active) {
    int worst = RE_report;
    for (int i = 0; i < NFAULTS; ++i)
      if ((active >> i & 1) && reaction_table[i] > worst) worst = reaction_table[i];
    return worst;
  }
  static int any_latched(int active) {
    for (int i = 0; i < NFAULTS; ++i)
      if ((active >> i & 1) && latched_table[i]) return 1;
    return 0;
  }
  static int keeps_limp(int active) {
    for (int i = 0; i < NFAULTS; ++i)
      if ((active >> i & 1) && latched_table[i] && reaction_table[i] == RE_limp) return 1;
    return 0;
  }
  static int ends_controller(int active) {
    for (int i = 0; i < NFAULTS; ++i)
      if ((active >> i & 1) && ends_table[i]) return 1;
    return 0;
  }
}

/* -- guard -- */
byte state = ST_offline;
int faults = 0;              /* the active ones, a bit each */
bit session, ended, started, in_place, holding_up;
bit perhaps_held;            /* torque may be on: not every joint has been looked at since it was, or since the start */
byte silence;                /* of the controller: 0 talks, 1 stalled, 2 gone */
byte missed = 0;             /* answers of the board in a row */
bit ever;                    /* the board has answered */
bit powered, had_power, lost, off_once, withheld;
byte losses;
byte looking;

/* -- guard, the joint -- */
byte phase = OUT, writes, conf, age;
bit uncertain, tripped, off_due, off_ordered, stiff, known;
bit suspect;                                  /* JointGuard::suspect_: decides what is written */
bit bit_once, off_look, was_on, early, armed; /* TripWatch: its memory; a reset forgets it, and not `suspect` */

/* -- ghosts: what the guard cannot know -- */
bit goal_right;              /* the guard's goal is where the joint is */
bit ref_right;               /* its newest reading was taken after the joint lost torque */
bit released;                /* a person released the robot, and no person has acted since */
bit by_reset;                /* with RESET, which the board remembers by its servo power */
byte off_for = 4;            /* cycles without torque */
byte limp_for;               /* cycles in which the guard says limp and the servo answers */
byte since_wire = WIRE_GAP;  /* cycles since the wire lost something */

/* -- board and servo -- */
bit board_power, reset_seen, shut_seen, up, fresh, bit_seen, looked, flicker;
bit off_seen;                /* two answers in a row say that servo power is off */
bit s_on, s_goal_right, s_shut, s_reset, kept;  /* reset: restarted, its settings are those of power-up */
byte boot;
byte look_age;

/* -- processes -- */
byte process = RUNNING;
bit remembered;              /* a file says that a person's release waits for a person */
bit held;                    /* a file says that the runtime holds joints; it outlives the runtime */
bit automatic;               /* the supervisor may start the controller again */
bit calm;                    /* from here on nothing breaks, and a person looks after the robot */
bit let_go;                  /* since then MODE was pressed */

/* -- of one cycle; zero between two -- */
mtype = { A_NOBODY, A_MODE, A_START, A_RESET, A_RELEASE, A_COMES, A_RESTARTED, A_ENDS, A_FAILS, A_HANGS, A_GOES_ON,
          A_RUNTIME_DIES, A_BOOTS, A_SUPERVISOR_DIES, B_NOTHING, B_RESET, B_RAIL, B_OVERLOAD, W_FINE, W_WRITE_LOST,
          W_WRONG_BIT, W_REPLY_LOST, W_BOTH_LOST }
byte act, broken, wire, boot_now, obeys, rearm, armed_now;  /* obeys: a controller that step() tells to end: 0 goes on, 1 ends, 2 fails */
bit before_write, in_place_now, arrived;
byte came, ev, demand, write_off, write_on, write_goal, delivered, wanted, heard;
byte lost_now, under_torque, was_suspect, offline_now, restart, verdict;
int cause, told, event = NEVENTS;

inline servo_off() {
  if :: s_on -> off_for = 0; goal_right = 0; ref_right = 0 :: else -> skip fi;  /* a limp joint stays where it is */
  s_on = 0; s_goal_right = 0
}

/* Torque comes on. */
inline servo_on() {
  if
  :: !s_on ->
    assert(s_goal_right || off_for <= DRIFT);  /* A1: its goal was put where it is since it lost torque */
    assert(!released);                         /* A2: no torque after a person's release without a person */
    s_on = 1;
    s_goal_right = 1;
    goal_right = 1;
    off_for = 0
  :: else -> skip
  fi
}

inline forget_guard() {
  state = ST_offline; faults = 0; session = 0; ended = 0; started = 0; in_place = 0; holding_up = 0; silence = 0;
  missed = 0; ever = 0; powered = 0; lost = 0; off_once = 0; off_seen = 0; withheld = 0; losses = 0; looking = 0;
  had_power = held; perhaps_held = 1;  /* Config::held_before */
  phase = OUT; writes = 0; conf = 0; age = PATIENCE + 1; uncertain = 0; tripped = 0; off_due = 0; off_ordered = 0;
  suspect = 0; bit_once = 0; off_look = 0; was_on = 0; early = 0; armed = 0;
  if :: remembered -> faults = 1 << FA_released_by_operator :: else -> skip fi;  /* the daemon says so in its first word */
  stiff = 0; known = 0; goal_right = 0; up = 0; fresh = 0; bit_seen = 0; looked = 0; limp_for = 0
}

/* People and processes: at most one acts in a cycle. */
/* A release is noted in a file within a few cycles; a process that dies before is not considered. */
#define NOTED (!released || remembered || by_reset)
#define START_COUNTS (withheld || (told && !DRIVES(state)))  /* BoardWatch::update; told: a latched fault is active */
#define FREE (!session || ended || silence == 2)
inline choose_who_acts() {
  act = A_NOBODY;
  if
  :: calm -> the_way_out()
  :: !calm ->
     if
     :: skip
#ifndef NO_PEOPLE
     :: process != DOWN -> act = A_MODE
     :: process == RUNNING && START_COUNTS -> act = A_START
     :: process == RUNNING -> act = A_RESET
     :: process == RUNNING -> act = A_RELEASE
#endif
     :: process == RUNNING && FREE -> act = A_COMES; if :: in_place_now = 0 :: in_place_now = 1 fi
     :: process == RUNNING && FREE && automatic -> act = A_RESTARTED; if :: in_place_now = 0 :: in_place_now = 1 fi
     :: process == RUNNING && session && !ended -> if :: act = A_ENDS :: act = A_FAILS fi
     :: process == RUNNING && session && !ended && silence < 2 && state != ST_taking_over && state != ST_starting ->
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

/* What a person does who wants the robot to move (1), or to let go (2), and reads what docs/faults.md says: nothing
   breaks any more. */
inline the_way_out() {
  if
  :: process == DOWN -> act = A_BOOTS
  :: process == RESCUING -> skip                                /* waits for its end */
#if WAY_OUT == 2
  :: process == RUNNING && !let_go -> act = A_MODE; let_go = 1
  :: process == RUNNING && let_go -> skip
#else
  :: process == RUNNING && FREE -> act = A_COMES; if :: in_place_now = 0 :: in_place_now = 1 fi
  :: process == RUNNING && !FREE && silence == 1 -> act = A_GOES_ON
  :: process == RUNNING && START_COUNTS -> act = A_START
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
  :: act == A_BOOTS -> remembered = 0; held = 0; forget_guard(); process = RUNNING; released = 0; let_go = 0  /* --restart-controller, or the power switch */
  :: act == A_SUPERVISOR_DIES -> forget_guard(); process = RUNNING; automatic = 1  /* systemd starts another one */
  :: else -> skip
  fi
}

/* Board and servo: at most one thing breaks in a cycle, before or after the write. */
inline choose_what_breaks() {
  broken = B_NOTHING;
  if
  :: skip
  :: !calm && board_power -> broken = B_RESET
  :: !calm && board_power && boot == 0 -> broken = B_RAIL;
     if :: boot_now = 0 :: boot_now = 1 :: boot_now = MAXBOOT fi  /* 0: it is back before it is asked */
  :: !calm && (s_on || phase == PLACED || phase == MOVING) -> broken = B_OVERLOAD
  fi;
  if :: broken != B_NOTHING -> if :: before_write = 0 :: before_write = 1 fi :: else -> skip fi
}

inline something_breaks() {
  if
  :: broken == B_RESET ->                                             /* RESET, or the supply dipped */
     /* Under torque it is a person's release. Before a loop has had its first answer it is one only if an earlier loop
        has noted that it held joints: without both a board without servo power is a board that was just switched on. */
     if :: s_on && (ever || held) && !released -> released = 1; by_reset = 1 :: else -> skip fi;
     board_power = 0; servo_off()
  :: broken == B_RAIL && boot == 0 ->                                 /* the rail or the chain dipped */
     kept = !s_on; servo_off(); s_shut = 0; s_reset = 1;
     s_goal_right = kept;  /* a servo starts with its goal where it is; a joint that was held falls from there */
     boot = boot_now
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

/* A reset: a person has acted. The guard forgets before it looks at this cycle's reading. */
inline clear_faults() {
  faults = 0; withheld = 0; losses = 0; tripped = 0; bit_once = 0; off_look = 0; was_on = 0; early = 0
}

/* Guard::hear */
inline hear() {
  if
  :: came != NOBODY -> session = 1; ended = 0; silence = 0; started = 0;
     in_place = in_place_now
  :: else -> skip
  fi;
  if :: came == PERSON || act == A_RESET || act == A_START -> clear_faults() :: else -> skip fi;
  if :: act == A_RELEASE -> ended = 1 :: else -> skip fi
}

inline restart_joint() {
  if :: phase != OUT -> phase = CONFIRMING; conf = 0; writes = 0 :: else -> skip fi
}

/* JointGuard::observe, in its order. */
inline observe() {
  /* noteRestart */
  restart = looked && (reset_seen || (!stiff && !shut_seen && uncertain && phase == MOVING));
  uncertain = !looked && (uncertain || !fresh);
  if
  :: (phase == PLACED || phase == MOVING) && (restart || (phase == PLACED && uncertain) || age > PATIENCE) -> restart_joint()
  :: else -> skip
  fi;
  /* TripWatch::update */
  if
  :: phase != MOVING -> off_look = 0; was_on = 0; armed = 0
  :: else -> armed = armed || armed_now
  fi;
  verdict = 0;
  if
  :: fresh && flicker && armed && bit_once -> verdict = 2; bit_once = 0
  :: fresh && flicker && armed && !bit_once -> bit_once = 1
  :: fresh && !(flicker && armed) -> bit_once = 0
  :: else -> skip
  fi;
  if
  :: phase != MOVING || armed -> early = 0
  :: phase == MOVING && !armed && fresh -> early = flicker || (looked && shut_seen)
  :: else -> skip
  fi;
  if
  :: armed && looked && (!stiff || shut_seen) && !off_look -> off_look = 1
  :: armed && looked && (!stiff || shut_seen) && off_look -> off_look = 0;
     if
     :: verdict == 2 -> skip
     :: verdict != 2 && (shut_seen || was_on) -> verdict = 2
     :: else -> verdict = 3
     fi
  :: armed && looked && stiff && !shut_seen -> off_look = 0; was_on = 1
  :: else -> skip
  fi;
  if :: verdict == 0 && (early || bit_once || off_look) -> verdict = 1 :: else -> skip fi;
  was_suspect = suspect;
  suspect = verdict == 1;
  if :: verdict == 2 -> tripped = 1 :: else -> skip fi;
  if :: (was_suspect && !suspect) || verdict == 3 || age > PATIENCE -> restart_joint() :: else -> skip fi;
  if :: age > PATIENCE -> known = 0; if :: !off_ordered -> stiff = 0 :: else -> skip fi :: else -> skip fi;
  if :: off_ordered && looked && stiff -> off_due = 1 :: else -> skip fi;
  /* JointChannel::observe */
  if
  :: phase == CONFIRMING && fresh && conf < 2 -> conf++
  :: phase == CONFIRMING && !fresh && conf == 2 -> conf = 1  /* the last reading is remembered */
  :: else -> skip
  fi
}

/* Guard::watch */
inline watch() {
  /* BoardWatch */
  if :: up -> missed = 0; ever = 1 :: !up && missed < 7 -> missed++ :: else -> skip fi;
  if :: !ever || missed > PATIENCE -> powered = 0; off_once = 0; off_seen = 0 :: else -> skip fi;
  lost_now = 0;
  if
  :: up && bit_seen -> off_once = 0; off_seen = 0; powered = 1; had_power = 1; lost = 0
  :: up && !bit_seen && !off_once -> off_once = 1
  :: up && !bit_seen && off_once ->
     powered = 0; off_seen = 1;
     if
     :: had_power && !lost -> lost = 1; lost_now = 1;
        if :: losses >= REPOWERS -> withheld = 1 :: else -> losses++ fi
     :: else -> skip
     fi
  :: else -> skip
  fi;
  observe();
  under_torque = lost_now && (DRIVES(state) || state == ST_found_stiff || holding_up || perhaps_held);
  if :: off_seen || (powered && (known || age > PATIENCE)) -> perhaps_held = 0 :: else -> skip fi;
  if :: lost -> holding_up = 0; stiff = 0; known = 0 :: else -> skip fi
}

inline note_faults() {
  cause = 0;
  if :: missed > PATIENCE -> cause = cause | (1 << FA_bus_silent) :: else -> skip fi;
  if :: under_torque -> cause = cause | (1 << FA_board_reset) :: else -> skip fi;
  if :: lost -> cause = cause | (1 << FA_servo_power_off) :: else -> skip fi;
  if :: tripped -> cause = cause | (1 << FA_servo_overload) :: else -> skip fi;
  if :: act == A_MODE -> cause = cause | (1 << FA_released_by_button) :: else -> skip fi;
  if :: act == A_RELEASE -> cause = cause | (1 << FA_released_by_operator) :: else -> skip fi;
  if :: session && !ended && silence >= 1 -> cause = cause | (1 << FA_controller_stalled) :: else -> skip fi;
  if :: session && !ended && silence == 2 -> cause = cause | (1 << FA_controller_gone) :: else -> skip fi;
  c_code { now.faults = noted(now.faults, now.cause); };
  cause = 0;
  /* A controller whose step() returns -1 ends; without that its process goes on asking. */
  c_code { now.told = ends_controller(now.faults); };
  if :: session && !ended && told && obeys != 0 -> ended = 1; automatic = (obeys == 2)
  :: else -> skip fi
}

inline find_event() {
  ev = NEVENTS;
  offline_now = !ever || missed > PATIENCE;
  c_code { now.told = worst_reaction(now.faults); };
  demand = told;
  if
  :: ended && state != ST_kneeling ->
     if
     :: process == RUNNING && demand < ON_EXIT -> demand = ON_EXIT
     :: process != RUNNING && demand < RE_kneel -> demand = RE_kneel
     :: else -> skip
     fi
  :: else -> skip
  fi;
  wanted = session && !ended && silence < 2 && demand < RE_kneel;
  if
  :: offline_now -> if :: state != ST_offline -> ev = EV_board_lost :: else -> skip fi
  :: !offline_now && state == ST_offline ->
     if
     :: !up -> skip
     :: up && (stiff || holding_up) -> ev = EV_stiff_seen
     :: up && !(stiff || holding_up) && (!powered || known || age > PATIENCE || looking > LOOK || (session && !ended)) ->
        ev = EV_board_found
     :: else -> if :: looking <= LOOK -> looking++ :: else -> skip fi
     fi
  :: else ->
     if
     :: demand >= RE_limp && (DRIVES(state) || holding_up || (state == ST_found_stiff && stiff && !off_ordered)) ->
        ev = EV_release
     :: demand == RE_kneel && state != ST_kneeling &&
        (DRIVES(state) || holding_up || (state == ST_found_stiff && stiff && !off_ordered)) -> ev = EV_kneel
     :: else ->
        if
        :: demand < RE_limp && came != NOBODY && wanted -> ev = EV_driver_came
        :: (demand >= RE_limp || !(came != NOBODY && wanted)) && (state == ST_limp || state == ST_found_stiff) ->
           if
           :: wanted -> ev = EV_driver_came
           :: !wanted && state == ST_limp && stiff -> ev = EV_stiff_seen
           :: !wanted && state == ST_found_stiff && !stiff -> ev = EV_limp_seen
           :: else -> skip
           fi
        :: state == ST_taking_over && came == NOBODY ->
           if
           :: powered && phase == MOVING -> ev = (in_place || started -> EV_taken_over_in_place : EV_taken_over)
           :: powered && phase == OUT && tripped -> ev = (in_place || started -> EV_taken_over_in_place : EV_taken_over)
           :: else -> skip
           fi
        :: state == ST_starting && came == NOBODY ->
           if :: demand == RE_hold -> ev = EV_hold :: demand != RE_hold && arrived -> ev = EV_start_done :: else -> skip fi
        :: state == ST_driven && came == NOBODY -> if :: demand == RE_hold -> ev = EV_hold :: else -> skip fi
        :: state == ST_holding && came == NOBODY ->
           if :: demand != RE_hold && wanted -> ev = (started -> EV_resume : EV_driver_came) :: else -> skip fi
        :: state == ST_kneeling && came == NOBODY ->
           if :: wanted -> ev = EV_driver_came :: !wanted && (lost || arrived) -> ev = EV_knelt :: else -> skip fi
        :: else -> skip
        fi
     fi
  fi
}

inline change_state() {
  if
  :: ev == EV_release || ev == EV_knelt -> 
     perhaps_held = perhaps_held || DRIVES(state) || state == ST_found_stiff || holding_up;
     off_due = 1; holding_up = 0; started = 0
  :: ev == EV_driver_came -> if :: phase != OUT -> phase = CONFIRMING; conf = 0; writes = 0 :: else -> skip fi
  :: ev == EV_kneel || ev == EV_taken_over -> started = 0
  :: ev == EV_taken_over_in_place || ev == EV_start_done -> started = 1
  :: else -> skip
  fi;
  if :: ev != NEVENTS -> event = ev; c_code { now.state = next_table[now.state][now.event]; }; event = NEVENTS :: else -> skip fi;
  if :: state != ST_offline -> looking = 0 :: else -> skip fi;
  /* engage */
  if
  :: !DRIVES(state) || !powered || tripped -> phase = OUT
  :: DRIVES(state) && powered && !tripped && phase == OUT -> phase = CONFIRMING; conf = 0; writes = 0
  :: else -> skip
  fi
}

/* Guard::compose */
inline compose() {
  write_off = 0; write_on = 0; write_goal = 0; heard = up;
  if
  :: state == ST_offline -> skip
  :: state != ST_offline && (off_due || (heard && phase == PLACED && writes >= 2 && !suspect && !uncertain)) ->
     write_off = off_due;
     if
     :: off_due -> off_due = 0; if :: !off_ordered -> stiff = 0; known = 0 :: else -> skip fi; off_ordered = 1
     :: else -> skip
     fi;
     if :: heard && phase == PLACED && writes >= 2 && !suspect && !uncertain -> write_on = 1; phase = MOVING :: else -> skip fi
  :: else ->
     if
     :: heard && phase == CONFIRMING && conf == 2 && !suspect ->
        phase = PLACED; writes = 1; off_ordered = 0; uncertain = 0; goal_right = ref_right
     :: heard && phase == PLACED && writes < 2 && !suspect && !uncertain -> writes++
     :: else -> skip
     fi;
     write_goal = heard && (phase == PLACED || phase == MOVING) && !suspect && !uncertain
  fi;
  if :: (phase == PLACED || phase == MOVING) && !suspect -> holding_up = 1 :: else -> skip fi
}

inline deliver() {
  up = wire == W_FINE || wire == W_WRITE_LOST || wire == W_WRONG_BIT;
  delivered = wire == W_FINE || wire == W_REPLY_LOST || wire == W_WRONG_BIT;
  if :: wire != W_FINE -> since_wire = 0 :: wire == W_FINE && since_wire < WIRE_GAP -> since_wire++ :: else -> skip fi;
  /* what it does */
  if
  :: delivered && ever && missed <= PATIENCE && !board_power && !withheld && (lost || !had_power) ->
     board_power = 1; boot = 2; s_shut = 0; s_reset = 1; s_goal_right = 1
  :: else -> skip
  fi;
  if
  :: delivered && board_power && boot == 0 ->
     if :: write_off -> servo_off() :: else -> skip fi;
     if :: write_on -> s_shut = 0; s_reset = 0; servo_on() :: else -> skip fi;
     if
     :: write_goal ->
        s_goal_right = goal_right;
        /* The first writes of a goal carry all settings, as do those in which another joint enters: a torque limit
           that is not 0 arms a servo again that has shut itself off. */
        if :: phase == PLACED || rearm -> s_reset = 0; s_shut = 0 :: else -> skip fi;
        if :: !s_shut -> servo_on() :: else -> skip fi   /* a goal write enables torque */
     :: else -> skip
     fi
  :: else -> skip
  fi
}

inline answer() {
  bit_seen = board_power;
  fresh = up && board_power && boot == 0;
  looked = 0; flicker = 0; reset_seen = 0; shut_seen = 0;
  if
  :: fresh ->
     age = 0; ref_right = 1;
     looked = look_age >= LOOK || uncertain || !known;  /* a doubtful servo is looked at as soon as it is heard */
     if :: looked -> look_age = 0; stiff = s_on; known = 1; reset_seen = s_reset; shut_seen = s_shut :: else -> look_age++ fi;
     flicker = s_shut || wire == W_WRONG_BIT
  :: !fresh && up && age <= PATIENCE -> age++       /* the board answered, the servo did not */
  :: !fresh && !up && age <= PATIENCE -> age++
  :: else -> skip
  fi;
  kept = 0;
  if :: boot > 0 -> boot-- :: else -> skip fi;
  if :: !s_on && off_for < 4 -> off_for++ :: else -> skip fi
}

inline judge() {
  c_code { now.told = keeps_limp(now.faults); };
  if :: process != DOWN -> remembered = told :: else -> skip fi;           /* ReleaseNote */
  if :: process != DOWN && ever -> held = DRIVES(state) || state == ST_found_stiff || (held && (state != ST_limp || perhaps_held))
  :: else -> skip fi;
  printf("%d came %d act %d broke %d wire %d | state %d event %d faults %x session %d ended %d silence %d | phase %d writes %d conf %d age %d suspect %d off %d/%d stiff %d | write off %d on %d goal %d delivered %d up %d | servo power %d boot %d on %d shut %d right %d off for %d released %d missed %d\n",
    process, came, act, broken, wire, state, ev, faults, session, ended, silence, phase, writes, conf, age, suspect, off_due, off_ordered, stiff, write_off, write_on, write_goal, delivered, up, board_power, boot, s_on, s_shut, s_goal_right, off_for, released, missed);
  assert(!(state == ST_offline && ever && missed > 0 && missed <= 5 && ev == EV_board_lost));  /* A3: 5 misses */
  /* A4: the state says limp, the servo answers, and holds its joint for longer than a look and a repeated order take */
  if
  :: state == ST_limp && s_on && up && fresh && since_wire >= WIRE_GAP -> if :: limp_for < 3 * LOOK + 4 -> limp_for++ :: else -> skip fi
  :: state == ST_limp && s_on && (!up || since_wire < WIRE_GAP) -> skip
  :: else -> limp_for = 0
  fi;
  assert(!(limp_for >= 3 * LOOK + 4 && s_on));
  assert(!(state == ST_offline && (write_on || write_goal || write_off)));       /* A5: nothing is sent to a silent board */
  assert(!(withheld && board_power && !powered && boot == 2));                   /* A6: power stays off when it was lost too often */
  if
  :: process == RESCUING && state == ST_limp && (known || age > PATIENCE) && !stiff && !off_due ->
     assert(!s_on || !fresh);                                                   /* A7: at rest means no torque */
     process = DOWN; forget_guard()
  :: else -> skip
  fi
}

/* What nothing reads before it is set again is 0: fewer states, the same behaviour. */
inline forget_the_dead() {
  if :: phase != PLACED -> writes = 0 :: else -> skip fi;
  if :: phase != CONFIRMING -> conf = 0 :: else -> skip fi;
  if :: phase == OUT || phase == CONFIRMING -> goal_right = 0 :: else -> skip fi;
  if :: phase != MOVING -> armed = 0; early = 0; was_on = 0; off_look = 0 :: else -> skip fi;
  if :: !board_power -> s_shut = 0; s_reset = 0; s_goal_right = 0; look_age = 0; boot = 0; ref_right = 0 :: else -> skip fi;
  if :: !released -> by_reset = 0 :: else -> skip fi;
  if :: process != RUNNING -> automatic = 0 :: else -> skip fi
}

active proctype robot() {
  forget_guard();
  if :: board_power = 0 :: board_power = 1; if :: s_on = 1; s_goal_right = 1 :: skip fi fi;  /* found limp or stiff */
  do
  :: atomic {
#ifdef WAY_OUT
       if :: calm = 1 :: skip fi;
#endif
       c_code { now.told = any_latched(now.faults); };
       choose_who_acts();
       choose_what_breaks();
       choose_wire();
       /* A kneel takes a second at least: lost power is noticed before it ends. */
       if
       :: !calm && (state == ST_starting || (state == ST_kneeling && (board_power || lost))) -> if :: arrived = 0 :: arrived = 1 fi
       :: else -> arrived = calm
       fi;
       if :: session && !ended && faults != 0 -> if :: obeys = 1 :: obeys = 2 :: !calm -> obeys = 0 fi :: else -> obeys = 1 fi;
       /* The grace in which an overload bit is no fact yet ends at any time; another joint enters in any cycle. */
       if :: phase == MOVING && !armed -> if :: !calm -> armed_now = 0 :: armed_now = 1 fi :: else -> armed_now = 0 fi;
       if :: s_shut && phase == MOVING && !calm -> if :: rearm = 0 :: rearm = 1 fi :: else -> rearm = 0 fi;
       d_step {
         carry_out();
         if
         :: process == DOWN -> something_breaks()
         :: else ->
            hear();
            watch();
            note_faults();
            find_event();
            change_state();
            compose();
            if :: before_write -> something_breaks() :: else -> skip fi;
            deliver();
            if :: !before_write -> something_breaks() :: else -> skip fi;
            answer();
            judge()
         fi;
         forget_the_dead();
         act = 0; broken = 0; wire = 0; boot_now = 0; before_write = 0; in_place_now = 0; obeys = 0; arrived = 0;
         came = 0; ev = 0; demand = 0; write_off = 0; write_on = 0; write_goal = 0; delivered = 0; wanted = 0; heard = 0;
         lost_now = 0; under_torque = 0; was_suspect = 0; offline_now = 0; told = 0; cause = 0; kept = 0;
         rearm = 0; armed_now = 0; restart = 0; verdict = 0
       }
     }
  od
}

/* Every state has a way out: when nothing breaks any more and a person does what docs/faults.md says, the robot drives
   again (1) or lets go (2), and stays so. */
#if WAY_OUT == 2
#define HOME (state == ST_limp && !s_on && let_go)
#else
#define HOME (state == ST_driven && phase == MOVING && s_on && s_goal_right)
#endif
#ifdef WAY_OUT
ltl way_out { [] (calm -> <> [] HOME) }
#endif
