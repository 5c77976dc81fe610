/* Guard, bus, board, one servo, controller, supervisor and people: what stands between a fault and a joint that moves.

   One turn of the loop is one cycle of the runtime: somebody acts, the guard decides (safety/guard.cpp), its write goes
   out, something may break, the servo answers. All choices are nondeterministic, so the checker tries every order of
   every event. The state machine and the fault table are those of the program: tables.pml is generated from them.

   Abstractions. One joint stands for twenty. Angles are not modelled: a goal is either where the joint is or elsewhere;
   a joint that was without torque for more than DRIFT cycles is elsewhere. Long times are short or arbitrary: the end of
   a slow move, stall and silence of a controller come at any cycle. Wire: one write in WIRE_GAP may be lost, or an outage
   of up to 7 cycles; faults of the wire are at least WIRE_GAP cycles apart.

   Servos alone (NO_BOARD): nothing switches their supply, which a person or a dip interrupts for at least one answer; all
   restart together, and are polled in the same cycle.

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
#ifdef ON_FALL  /* [Safety] on_fall: RE_limp; without it the row counts */
#define REACTION(i) ((i) == FA_fell ? ON_FALL : reaction_table[i])
#else
#define REACTION(i) reaction_table[i]
#endif
#ifdef NO_BOARD  /* [Robot] board = none */
#define BOARD 0
#define ROUNDS (MAXBOOT + LOOK)     /* two polling rounds, 0.8 s: a servo boots in less */
#define SUPPLY_BOOT (PATIENCE + 1)  /* a servo boots for longer than the bus may be silent */
#else
#define BOARD 1
#define ROUNDS 0
#define SUPPLY_BOOT 0
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
      if ((active >> i & 1) && REACTION(i) > worst) worst = REACTION(i);
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
  /* At least the effects of the other, for as long: beside a latched fault that dominates it, a fault changes nothing. */
  static int dominates(int i, int j) {
    return latched_table[i] && reaction_table[i] >= reaction_table[j] && ends_table[i] >= ends_table[j];
  }
  /* What later cycles need of the active faults. Those that end with their cause are noted again in each cycle; of the
     latched ones that none dominates, the first of equal rows stands for all. Fewer states, the same behaviour. */
  static int remember(int active) {
    int kept = 0;
    for (int i = 0; i < NFAULTS; ++i) {
      if (!(active >> i & 1) || !latched_table[i]) continue;
      int first = i, dominated = 0;
      for (int j = 0; j < NFAULTS; ++j) {
        if (!dominates(j, i)) continue;
        if (!dominates(i, j)) dominated |= active >> j & 1;
        else if (j < first) first = j;
      }
      if (!dominated) kept |= 1 << first;
    }
    return kept;
  }
  /* Would these faults change anything now? */
  static int matters(int active, int more) {
    return worst_reaction(active | more) != worst_reaction(active) || remember(active | more) != remember(active);
  }
  /* Causes outside of the state of board and servo that would change anything now: a bit each. */
#define MINOR (1 << FA_battery_low | 1 << FA_servo_hot | 1 << FA_encoder_stuck | 1 << FA_fell)
  static int to_try(int active) {
    int same = remember(1 << FA_servo_overheat) == remember(1 << FA_battery_empty);
    return matters(active, 1 << FA_battery_empty) | (!same && matters(active, 1 << FA_servo_overheat)) << 1 |
           matters(active, MINOR) << 2;
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
bit perhaps_held;            /* torque may be on: not every joint was seen limp since it was, or since the start */
byte silence;                /* of the controller: 0 talks, 1 stalled, 2 gone */
byte missed = 0;             /* answers of the board in a row */
bit ever;                    /* the board has answered */
bit powered, had_power, lost, off_once, withheld;
byte losses;
byte looking;
bit limited, missed_since;   /* SupplyWatch: it had a speed limit when it was looked at; it has missed an answer since */

/* -- guard, the joint -- */
byte phase = OUT, conf, age;
bit has_goal;                /* a look of this cycle found the placed goal and a speed limit in the servo */
bit on_seen;                 /* a look has found torque on since it was switched on */
bit had_limit;               /* it had a speed limit when it was looked at last */
bit shut_at_once;            /* off again when it was seen with the placed goal */
bit uncertain, tripped, off_due, off_ordered, stiff, known;
bit suspected;                                  /* JointGuard::suspected_: decides what is written */
bit bit_once, off_look, was_on, early, armed; /* TripWatch: its memory; a reset forgets it, and not `suspected` */

/* -- ghosts: what the guard cannot know -- */
bit goal_right;              /* the guard's goal is where the joint is */
bit ref_right;               /* its newest reading was taken after the joint lost torque */
bit released;                /* a person released the robot, and no person has acted since */
bit polled;                  /* this loop has looked at the servo */
bit by_reset;                /* with RESET, which the board remembers by its servo power */
byte off_for = 4;            /* cycles without torque */
byte limp_for;               /* cycles in which the guard says limp and the servo answers */
byte since_wire = WIRE_GAP;  /* cycles since the wire lost something */

/* -- board and servo -- */
bit board_power, reset_seen, shut_seen, placed_seen, up, fresh, bit_seen, looked, flicker;
bit off_seen;                /* two answers in a row say that servo power is off */
bit s_on, s_goal_right, s_shut, kept;
bit s_reset;                 /* restarted, its settings are those of power-up */
bit by_supply;               /* all servos have restarted since their settings were written */
byte quiet;                  /* cycles in which none replies, as all boot */
bit lies;                    /* the robot has fallen */
bit s_placed;                /* it has the goal that was placed last */
byte boot;
byte look_age;

/* -- processes -- */
byte process = RUNNING;
bit remembered;              /* a file says that a person's release waits for a person */
bit held;                    /* a file says that the runtime holds joints; it outlives the runtime */
bit automatic;               /* the supervisor may start the controller again */
bit calm;                    /* from here on nothing breaks, and a person looks after the robot */
bit mode_pressed;                  /* since then MODE was pressed */

/* -- of one cycle; zero between two -- */
mtype = { A_NOBODY, A_MODE, A_START, A_RESET, A_RELEASE, A_COMES, A_RESTARTED, A_ENDS, A_FAILS, A_HANGS, A_GOES_ON,
          A_RUNTIME_DIES, A_BOOTS, A_SUPERVISOR_DIES, B_NOTHING, B_RESET, B_RAIL, B_OVERLOAD, B_EMPTY, B_OVERHEAT, B_MINOR, B_TURNS, W_FINE, W_WRITE_LOST,
          W_WRONG_BIT, W_REPLY_LOST, W_BOTH_LOST }
byte act, broken, wire, boot_now, obeys, rearm, armed_now;  /* obeys: a controller that step() requests to end: 0 goes on, 1 ends, 2 fails */
bit before_write, in_place_now, arrived;
byte came, ev, demand, write_off, write_on, write_goal, delivered, wanted, received;
byte lost_now, under_torque, was_suspected, offline_now, restart, verdict;
int cause, fact, possible, event = NEVENTS;

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
  polled = 0;
  limited = !BOARD && held; missed_since = !BOARD && held;
  phase = OUT; has_goal = 0; on_seen = 0; had_limit = 0; shut_at_once = 0; conf = 0; age = PATIENCE + 1; uncertain = 0; tripped = 0; off_due = 0; off_ordered = 0;
  suspected = 0; bit_once = 0; off_look = 0; was_on = 0; early = 0; armed = 0;
  if :: remembered -> faults = 1 << FA_released_by_operator :: else -> skip fi;  /* the daemon says so in its first word */
  stiff = 0; known = 0; goal_right = 0; up = 0; fresh = 0; bit_seen = 0; looked = 0; limp_for = 0
}

#include "events.pml"
#include "guard.pml"

inline deliver() {
  up = quiet == 0 && (wire == W_FINE || wire == W_WRITE_LOST || wire == W_WRONG_BIT);
  delivered = wire == W_FINE || wire == W_REPLY_LOST || wire == W_WRONG_BIT;
  if :: wire != W_FINE -> since_wire = 0 :: wire == W_FINE && since_wire < WIRE_GAP -> since_wire++ :: else -> skip fi;
  /* what it does */
  if
  :: delivered && ever && missed <= PATIENCE && !board_power && !withheld && (lost || !had_power) ->
     board_power = 1; boot = 2; s_shut = 0; s_reset = 1; s_placed = 0; s_goal_right = 1
  :: else -> skip
  fi;
  if
  :: delivered && board_power && boot == 0 ->
     if :: write_off -> servo_off() :: else -> skip fi;
     if :: write_on -> s_shut = 0; s_reset = 0; by_supply = 0; servo_on() :: else -> skip fi;
     if
     :: write_goal ->
        /* The goal of a joint that is seen to have torque moves on: away from one that has none. */
        s_goal_right = goal_right && (s_on || phase == PLACED || !on_seen);
        /* The first writes of a goal carry all settings, as do those in which another joint enters: a torque limit
           that is not 0 arms a servo again that has shut itself off. */
        if :: phase == PLACED || rearm -> s_reset = 0; by_supply = 0; s_shut = 0 :: else -> skip fi;
        if :: phase == PLACED -> s_placed = 1 :: else -> skip fi;
        if :: !s_shut -> servo_on() :: else -> skip fi   /* a goal write enables torque */
     :: else -> skip
     fi
  :: else -> skip
  fi
}

inline answer() {
  bit_seen = board_power;
  fresh = up && board_power && boot == 0;
  looked = 0; flicker = 0; reset_seen = 0; shut_seen = 0; placed_seen = 0;
  if
  :: fresh ->
     age = 0; ref_right = 1;
     looked = look_age >= LOOK || uncertain || !known || phase == PLACED || (phase == MOVING && !on_seen);  /* one in doubt is looked at as soon as it answers */
     if :: looked -> look_age = 0; stiff = s_on; known = 1; reset_seen = s_reset; shut_seen = s_shut;
        /* A goal of before may be the one that was placed. */
        placed_seen = (s_placed || s_goal_right) && !s_reset
     :: else -> look_age++
     fi;
     flicker = s_shut || wire == W_WRONG_BIT
  :: !fresh && up && age <= PATIENCE -> age++       /* the board answered, the servo did not */
  :: !fresh && !up && age <= PATIENCE -> age++
  :: else -> skip
  fi;
  kept = 0;
  if :: boot > 0 -> boot-- :: else -> skip fi;
  if :: quiet > 0 -> quiet-- :: else -> skip fi;
  if :: !s_on && off_for < 4 -> off_for++ :: else -> skip fi
}

inline judge() {
  c_code { now.fact = keeps_limp(now.faults); };
  if :: process != DOWN -> remembered = fact :: else -> skip fi;           /* ReleaseNote */
  if :: process != DOWN && ever -> held = DRIVES(state) || state == ST_found_stiff || (held && (state != ST_limp || perhaps_held))
  :: else -> skip fi;
  printf("%d came %d act %d broke %d wire %d | state %d event %d faults %x session %d ended %d silence %d | phase %d has goal %d conf %d age %d suspected %d off %d/%d stiff %d | write off %d on %d goal %d delivered %d up %d | servo power %d boot %d on %d shut %d right %d off for %d released %d missed %d\n",
    process, came, act, broken, wire, state, ev, faults, session, ended, silence, phase, has_goal, conf, age, suspected, off_due, off_ordered, stiff, write_off, write_on, write_goal, delivered, up, board_power, boot, s_on, s_shut, s_goal_right, off_for, released, missed);
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
  has_goal = 0;
  if :: phase != PLACED -> s_placed = 0 :: else -> skip fi;
  if :: phase != CONFIRMING -> conf = 0 :: else -> skip fi;
  if :: phase == OUT || phase == CONFIRMING -> goal_right = 0 :: else -> skip fi;
  if :: phase != MOVING -> on_seen = 0; armed = 0; early = 0; was_on = 0; off_look = 0 :: else -> skip fi;
  if :: !board_power -> s_shut = 0; s_reset = 0; s_goal_right = 0; look_age = 0; boot = 0; ref_right = 0 :: else -> skip fi;
  if :: !released -> by_reset = 0 :: else -> skip fi;
  if :: process != RUNNING -> automatic = 0 :: else -> skip fi
}

active proctype robot() {
  forget_guard();
  if
  :: BOARD -> board_power = 0
  :: board_power = 1; if :: s_on = 1; s_goal_right = 1 :: skip fi  /* found limp or stiff */
  :: !BOARD -> board_power = 1; s_reset = 1; by_supply = 1; s_goal_right = 1  /* just supplied */
  fi;
  do
  :: atomic {
#ifdef WAY_OUT
       if :: calm = 1 :: skip fi;
#endif
       c_code { now.fact = any_latched(now.faults); };
#ifdef CHARGE
       c_code { now.possible = to_try(now.faults); };
#endif
       choose_who_acts();
       choose_what_breaks();
       choose_wire();
       /* A kneel takes a second at least: lost power, and what a look shows, is noticed before it ends. */
       if
       :: !calm && (state == ST_starting || (state == ST_kneeling && (board_power || lost) && (BOARD || (fresh && !uncertain)))) -> if :: arrived = 0 :: arrived = 1 fi
       :: else -> arrived = calm
       fi;
       /* Only where a fault is or may come that ends the controller. */
       if
       :: session && !ended && (faults != 0 || act == A_MODE || act == A_RELEASE || broken == B_EMPTY ||
                                broken == B_OVERHEAT || bit_once || off_look || shut_at_once || off_once) -> if :: obeys = 1 :: obeys = 2 :: !calm -> obeys = 0 fi
       :: else -> obeys = 1
       fi;
       /* The grace in which an overload bit is not a fact yet ends at any time; another joint enters in any cycle. */
       if :: phase == MOVING && !armed -> if :: !calm -> armed_now = 0 :: armed_now = 1 fi :: else -> armed_now = 0 fi;
       if :: s_shut && phase == MOVING && !calm -> if :: rearm = 0 :: rearm = 1 fi :: else -> rearm = 0 fi;
       d_step {
         carry_out();
         if
         :: process == DOWN -> something_breaks()
         :: else ->
            take_commands();
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
         c_code { now.faults = remember(now.faults); };
         forget_the_dead();
         act = 0; broken = 0; wire = 0; boot_now = 0; before_write = 0; in_place_now = 0; obeys = 0; arrived = 0;
         came = 0; ev = 0; demand = 0; write_off = 0; write_on = 0; write_goal = 0; delivered = 0; wanted = 0; received = 0;
         lost_now = 0; under_torque = 0; was_suspected = 0; offline_now = 0; fact = 0; cause = 0; kept = 0;
         rearm = 0; armed_now = 0; restart = 0; verdict = 0; possible = 0
       }
     }
  od
}

/* Every state has a way out: when nothing breaks any more and a person does what docs/faults.md says, the robot drives
   again (1) or becomes limp (2), and stays so. */
#if WAY_OUT == 2
#define HOME (state == ST_limp && !s_on && mode_pressed)
#else
#define HOME (state == ST_driven && phase == MOVING && s_on && s_goal_right)
#endif
#ifdef WAY_OUT
ltl way_out { [] (calm -> <> [] HOME) }
#endif
