/* What safety/guard.cpp, safety/joint_guard.cpp and their parts do in one cycle, in their order. Part of robot.pml. */

/* A reset: a person has acted. The guard forgets before it looks at this cycle's reading. */
inline clear_faults() {
  faults = 0; withheld = 0; losses = 0; tripped = 0; bit_once = 0; off_look = 0; was_on = 0; early = 0
}

/* Guard::take */
inline take_commands() {
  if
  :: came != NOBODY -> session = 1; ended = 0; silence = 0; started = 0;
     in_place = in_place_now
  :: else -> skip
  fi;
  if :: came == PERSON || act == A_RESET || act == A_START -> clear_faults() :: else -> skip fi;
  if :: act == A_RELEASE -> ended = 1 :: else -> skip fi
}

inline restart_joint() {
  if :: phase != OUT -> phase = CONFIRMING; conf = 0 :: else -> skip fi
}

/* JointGuard::observe, in its order. */
inline observe() {
  /* notePlaced */
  has_goal = 0;
  if
  :: looked && phase == PLACED && placed_seen && !shut_seen -> has_goal = 1; shut_at_once = 0
  :: looked && phase == PLACED && placed_seen && shut_seen ->
     if :: shut_at_once -> tripped = 1 :: else -> skip fi;
     shut_at_once = !shut_at_once; restart_joint()
  :: looked && phase == PLACED && !placed_seen -> shut_at_once = 0; restart_joint()
  :: else -> skip
  fi;
  /* noteRestart */
  restart = looked && (reset_seen || (!stiff && !shut_seen && (uncertain || !on_seen) && phase == MOVING));
  if :: looked && stiff -> on_seen = 1 :: else -> skip fi;
  if :: looked && !BOARD -> polled = 1 :: else -> skip fi;
  if :: looked && uncertain && had_limit && reset_seen && stiff -> off_due = 1 :: else -> skip fi;
  if :: looked -> had_limit = !reset_seen :: else -> skip fi;
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
  was_suspected = suspected;
  suspected = verdict == 1;
  if :: verdict == 2 -> tripped = 1 :: else -> skip fi;
  if :: (was_suspected && !suspected) || verdict == 3 || age > PATIENCE -> restart_joint() :: else -> skip fi;
  if :: age > PATIENCE -> known = 0; if :: !off_ordered -> stiff = 0 :: else -> skip fi :: else -> skip fi;
  if :: off_ordered && looked && stiff -> off_due = 1 :: else -> skip fi;
  /* JointChannel::observe */
  if
  :: phase == CONFIRMING && fresh && conf < 2 -> conf++
  :: phase == CONFIRMING && !fresh && conf == 2 -> conf = 1  /* the last reading is remembered */
  :: else -> skip
  fi
}

/* SupplyWatch: a restart of this joint alone is a matter of its guard. */
inline watch_supply() {
  if
  :: !fresh -> missed_since = 1
  :: fresh && looked && (stiff || !reset_seen) -> limited = 1; missed_since = 0
  :: fresh && looked && !stiff && reset_seen && limited -> limited = 0; lost_now = missed_since && by_supply
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
  :: !BOARD -> powered = ever && missed <= PATIENCE; watch_supply()
  :: BOARD && up && bit_seen -> off_once = 0; off_seen = 0; powered = 1; had_power = 1; lost = 0
  :: BOARD && up && !bit_seen && !off_once -> off_once = 1
  :: BOARD && up && !bit_seen && off_once ->
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
  if
  :: off_seen || (powered && ((known && !stiff) || (age > PATIENCE && (BOARD || state != ST_offline)))) -> perhaps_held = 0
  :: else -> skip
  fi;
  if :: lost -> holding_up = 0; stiff = 0; known = 0 :: else -> skip fi;
  if :: !BOARD && !powered -> stiff = 0; known = 0 :: else -> skip fi  /* only looks show who has torque now */
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
  if
  :: broken == B_EMPTY -> cause = cause | (1 << FA_battery_low) | (1 << FA_battery_empty)
  :: broken == B_OVERHEAT -> cause = cause | (1 << FA_servo_hot) | (1 << FA_servo_overheat)
  :: broken == B_MINOR -> c_code { now.cause |= MINOR; }
  :: broken == B_TURNS -> lies = !lies
  :: else -> skip
  fi;
  if :: calm -> lies = 0 :: else -> skip fi;  /* stood up */
  if :: lies && up -> cause = cause | (1 << FA_fell) :: else -> skip fi;
  if :: up && powered && age > PATIENCE -> cause = cause | (1 << FA_servo_silent) :: else -> skip fi;
  if :: fresh && flicker -> cause = cause | (1 << FA_servo_voltage) :: else -> skip fi;  /* any bit of the error byte */
  if :: state == ST_starting && arrived && phase != MOVING -> cause = cause | (1 << FA_start_missed) :: else -> skip fi;
  c_code { now.faults = noted(now.faults, now.cause); };
  cause = 0;
  /* A controller whose step() returns -1 ends; without that its process goes on asking. */
  c_code { now.fact = ends_controller(now.faults); };
  if :: session && !ended && fact && obeys != 0 -> ended = 1; automatic = (obeys == 2)
  :: else -> skip fi
}

/* Guard::stillLimp */
#define STILL_LIMP (state == ST_taking_over && !holding_up && (known || age > PATIENCE) && !stiff)

inline find_event() {
  ev = NEVENTS;
  offline_now = !ever || missed > PATIENCE;
  c_code { now.fact = worst_reaction(now.faults); };
  demand = fact;
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
     :: !up -> if :: !BOARD -> looking = 0 :: else -> skip fi
     :: up && !BOARD && !known && looking <= ROUNDS -> looking++
     :: up && (BOARD || known || looking > ROUNDS) ->
        if
        :: stiff || holding_up -> ev = EV_stiff_seen
        :: !(stiff || holding_up) && (!powered || known || age > PATIENCE || looking > LOOK || (session && !ended)) ->
           ev = EV_board_found
        :: else -> if :: looking <= LOOK -> looking++ :: else -> skip fi
        fi
     fi
  :: else ->
     if
     :: STILL_LIMP && (demand >= RE_kneel || ended) -> ev = EV_release
     :: demand >= RE_limp && ((DRIVES(state) && !STILL_LIMP) || holding_up || (state == ST_found_stiff && stiff && !off_ordered)) ->
        ev = EV_release
     :: demand == RE_kneel && state != ST_kneeling &&
        ((DRIVES(state) && !STILL_LIMP) || holding_up || (state == ST_found_stiff && stiff && !off_ordered)) ->
        ev = EV_kneel
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
  :: ev == EV_driver_came -> if :: phase != OUT -> phase = CONFIRMING; conf = 0 :: else -> skip fi
  :: ev == EV_kneel || ev == EV_taken_over -> started = 0
  :: ev == EV_taken_over_in_place || ev == EV_start_done -> started = 1
  :: else -> skip
  fi;
  if :: ev != NEVENTS -> event = ev; c_code { now.state = next_table[now.state][now.event]; }; event = NEVENTS :: else -> skip fi;
  if :: state != ST_offline -> looking = 0 :: else -> skip fi;
  /* engage */
  if
  :: !DRIVES(state) || !powered || tripped -> phase = OUT
  :: DRIVES(state) && powered && !tripped && phase == OUT -> phase = CONFIRMING; conf = 0
  :: else -> skip
  fi
}

/* Guard::compose */
inline compose() {
  write_off = 0; write_on = 0; write_goal = 0; received = up;
  if
  :: state == ST_offline -> skip
  :: state != ST_offline && (off_due || (received && phase == PLACED && has_goal && !suspected && !uncertain)) ->
     write_off = off_due;
     if
     :: off_due -> off_due = 0; if :: !off_ordered -> stiff = 0; known = 0 :: else -> skip fi; off_ordered = 1
     :: else -> skip
     fi;
     if :: received && phase == PLACED && has_goal && !suspected && !uncertain -> write_on = 1; phase = MOVING; on_seen = 0 :: else -> skip fi
  :: else ->
     if
     :: received && phase == CONFIRMING && conf == 2 && !suspected ->
        phase = PLACED; s_placed = 0; off_ordered = 0; uncertain = 0; goal_right = ref_right
     :: else -> skip
     fi;
     write_goal = received && (phase == PLACED || phase == MOVING) && !suspected && !uncertain
  fi;
  if
  :: (phase == PLACED || phase == MOVING) && !suspected ->
     holding_up = 1;
     if :: !BOARD && !limited -> limited = 1; missed_since = 0 :: else -> skip fi  /* SupplyWatch::noteGoals */
  :: else -> skip
  fi
}
