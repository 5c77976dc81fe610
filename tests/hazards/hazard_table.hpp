// The hazard table: what can go wrong, what must hold all the same, and which tests show it. docs/hazards.md is made
// from it.
#pragma once

#include <array>
#include <string_view>

namespace darwinop {

struct Hazard {
  std::string_view id;      // never reused
  std::string_view hazard;  // what happens to a person or the robot
  std::string_view cause;
  std::string_view constraint;  // what must hold whatever the cause does
  std::string_view reaction;    // of the product
  std::string_view tests;       // "program:Suite.Test", separated by blanks
};

// 1xx: a joint moves otherwise than intended. 2xx: bus and board. 3xx: servos and supply. 4xx: a person. 5xx: programs.
// 6xx: start-up. 7xx: access.
inline constexpr auto kHazards = std::to_array<Hazard>({
    {"H101", "A joint jumps when a controller takes over", "the servo's goal register holds an old pose",
     "torque comes on only where the joint is", "goal written to the confirmed position, read back, then torque on",
     "safety_test:TakeOver.ANewSessionStartsFromTheConfirmedPresentPoseWithoutAJump "
     "safety_test:TakeOver.GoalIsThePresentPositionAndTorqueComesWhenTheServosAreSeenToHaveIt"},
    {"H102", "A joint moves to a position that was never measured", "one damaged reading passes the checksum",
     "two readings must agree before a position becomes a goal", "the joint waits for a second reading",
     "safety_test:TakeOver.ACorruptedReadingNeverBecomesAGoal "
     "safety_test:PositionConfirmer.DoesNotBelieveACorruptedReadingNorTheOneAfterIt"},
    {"H103", "A joint hits its mechanical stop", "a controller commands a goal outside the range",
     "no goal outside the joint's range reaches the bus", "goal clamped and counted",
     "safety_test:Driving.GoalsOutsideTheLimitsAreClampedAndCounted "
     "safety_property_test:GuardProperty.WhateverHappensTheLimitsHold"},
    {"H104", "A joint moves at full speed", "a controller commands a goal far away",
     "no goal moves faster than max_joint_speed", "goal approached in steps of one cycle",
     "hazard_reaction_test:Reaction.AFarGoalMovesByOneStepACycle "
     "safety_test:Driving.AFarGoalIsApproachedAtTheGreatestSpeedPerNominalPeriod"},
    {"H105", "A joint makes a long step", "a cycle was late or skipped", "a step is bounded by the nominal period",
     "the step after an overrun is as short as any other", "safety_test:Driving.AnOverrunDoesNotMakeTheNextStepLonger"},
    {"H106", "A joint moves to an undefined goal", "a controller commands NaN or infinity",
     "every number on the bus is finite", "previous value kept and counted",
     "hazard_reaction_test:Reaction.AGoalThatIsNotFiniteMovesNothing "
     "safety_test:Driving.NotANumberKeepsThePreviousGoalAndIsCounted"},
    {"H107", "A joint has no speed limit", "register 32 of an MX-28 is 0, which means unlimited",
     "the speed register of a driven servo is never 0", "a speed of 0 becomes the slowest one",
     "safety_test:JointLimiter.SpeedNeverBecomesNoLimit core_test:Speed.ALimitIsNeverZeroBecauseZeroMeansUnlimited"},
    {"H108", "The start move hits something or falls over", "the robot is not in its start pose",
     "start and kneel move at the gentle speed, all joints arriving together",
     "slow move, whatever the controller asks",
     "safety_test:TakeOver.TheStartMoveIsAsSlowWhateverTheControllerAsks "
     "safety_test:Kneel.AllJointsArriveTogetherSoThatTheFeetStayFlatOnTheWayDown"},
    {"H109", "A joint blocks in the start move", "an obstacle or a weak joint",
     "nobody waits for it for ever, and it is reported", "the move times out; the joint is named",
     "safety_test:TakeOver.AJointThatDoesNotGetToTheStartPoseIsReportedAndNotWaitedForForever"},
    {"H201", "The robot continues on goals that nobody corrects", "the board does not answer",
     "after more than five missed cycles nothing is sent", "offline; takeover when the board is back",
     "hazard_reaction_test:Reaction.ASilentBoardEndsSending "
     "safety_test:Recovery.NothingIsSentFromSixCyclesOfSilenceOn"},
    {"H202", "A joint jumps after the link returns", "somebody moved the joint meanwhile",
     "joints restart where they are", "takeover at the gentle speed",
     "safety_test:Recovery.AfterALostLinkJointsRestartWhereTheyAreAndCatchUpGently"},
    {"H203", "A servo keeps its torque although it was told to let go", "a broadcast is lost on the bus",
     "torque off is repeated until a reading confirms it", "each servo's torque switch is read once a second",
     "safety_test:Driving.ALostTorqueOffIsSentAgain"},
    {"H204", "A joint stays limp in a stance", "torque on is lost on the bus",
     "a lost torque on is noticed and repeated", "the joint is taken over again",
     "safety_test:TakeOver.ALostTorqueOnIsSentAgain"},
    {"H205", "Torque comes on at a goal that no servo received", "frames with goals are lost, any number in a row",
     "torque on follows only a goal that the servo was seen to have",
     "registers 30..33 are read back; fault 12 after 20",
     "servo_hazards_test:TakeOver/LostGoals.LeaveTheJointLimpUntilOneHasArrived/5 "
     "safety_test:TakeOver.NoTorqueFindsAnOlderGoalWhateverIsLostOnTheWire "
     "safety_test:TakeOver.TorqueComesOnOnlyAfterAGoalThatTheBoardHeard "
     "safety_test:Driving.GoalsWaitForABoardThatDoesNotAnswer"},
    {"H206", "The loop misses its deadline", "bytes arrive without end", "a cycle ends at its deadline",
     "reading ends after the wire time of the answer and twice the margin",
     "bus_test:BusOnABadLine.BabbleDoesNotKeepTheLoop serial_test:Transactions.EndOnALineThatBabbles"},
    {"H207", "The loop misses its deadline", "memory is allocated in the loop", "the loop allocates nothing",
     "all memory is taken at start",
     "cycle_allocation_test:Cycle.AllocatesNothingInTenThousandCyclesUnderFaults "
     "safety_allocation_test:GuardAllocation.NothingIsAllocatedInAnyState"},
    {"H208", "Nineteen servos are not read", "one servo is silent and blocks the chain of answers",
     "a silent servo costs the others one cycle", "it is asked last, then left out and polled",
     "bus_test:AnywhereInTheChain/DeadServoOnTheBus.AllOthersAreReadFromThreeCyclesLaterAndItIsBackWithinASecond/12"},
    {"H209", "A stale value is taken for a measurement", "a device did not answer in this cycle",
     "a value that was not received is absent and has an age", "ages count up",
     "bus_test:Decoder.WhatDidNotAnswerIsAbsentNotZero "
     "campaign_test:Campaign.NothingStalePassesForFreshAndNoPromiseIsBroken"},
    {"H210", "Servo power drops by a damaged byte", "a corrupted board write",
     "the runtime never switches servo power off", "the only power write is on",
     "bus_test:Bus.NeverSwitchesServoPowerOff safety_test:Recovery.OneCorruptedPowerBitIsNoReset"},
    {"H211", "A servo's settings change for good", "a damaged frame writes to EEPROM", "the EEPROM of servos is locked",
     "lock written after power on", "bus_test:Bus.LocksTheEepromOfEveryServo"},
    {"H301", "A restarted servo jumps", "its plug or supply failed for a moment",
     "torque comes on only where the joint is, with a speed limit", "joint taken over again",
     "hazard_reaction_test:Reaction.AServoThatRestartsIsTakenOverWhereItIs "
     "safety_test:Recovery.AServoThatTheBusHasGivenUpGetsNoGoalsUntilItsPositionIsConfirmed"},
    {"H302", "A motor burns", "a servo works against a stop until it shuts itself off",
     "a servo that shut itself off is not switched on by routine writes", "other joints kneel; the servo is left out",
     "hazard_reaction_test:Reaction.AnOverloadShutdownMakesItKneel "
     "safety_test:Trip.ATrippedServoIsNeverDrivenUntilAsked"},
    {"H303", "A shutdown stays unseen", "the overload bit is lost", "the torque registers are a second witness",
     "a torque limit of 0 is a shutdown", "safety_test:Trip.TheRotatingLookFindsATorqueLimitOfZeroWithoutAnyErrorBit"},
    {"H304", "A servo overheats", "long work near its limit", "joints slow down before the servo shuts itself off",
     "gentle speed from 65 deg C on", "hazard_reaction_test:Reaction.HotServosSlowAllJointsDown"},
    {"H305", "A servo shuts itself off in a stance", "it reaches 80 deg C", "the robot sits before that",
     "kneel from 75 deg C on", "hazard_reaction_test:Reaction.AnOverheatedServoMakesItKneel"},
    {"H306", "The battery is damaged or the robot drops", "the supply sinks under 10 V",
     "the robot sits while it still can", "kneel, then limp", "hazard_reaction_test:Reaction.EmptyBatteryMakesItKneel"},
    {"H307", "Nobody notices a low battery", "the supply sinks under 11 V", "it is reported",
     "fault 20 on LEDs, log and status", "hazard_reaction_test:Reaction.LowBatteryIsReported"},
    {"H308", "A limb is dead and nobody knows", "a servo does not answer", "it is reported with its name", "fault 12",
     "hazard_reaction_test:Reaction.ASilentServoIsReported"},
    {"H309", "One damaged error byte stops the robot", "a flipped bit in a reply",
     "one reading is a suspicion, two are a fact", "the joint is left out for one cycle and taken over again",
     "safety_test:Trip.OneCorruptedErrorByteIsNoFaultAndTheJointRestartsWhereItIs"},
    {"H401", "A person cannot stop the robot", "it moves towards somebody", "MODE switches all torque off",
     "limp, latched",
     "hazard_reaction_test:Reaction.ModeSwitchesAllTorqueOff "
     "safety_test:Kneel.TheButtonReleasesAllJointsAtOnceAndStaysReleased"},
    {"H402", "The robot moves again under a hand", "servo power was lost and returns by itself",
     "no torque without a person's act", "limp until START or a session that a person starts",
     "hazard_reaction_test:Reaction.LostServoPowerLeavesEveryJointLimp"},
    {"H403", "A brief touch drops the robot", "MODE is touched", "a press under 0.25 s releases nothing", "debounced",
     "safety_test:Kneel.AShortPressOrTheOtherButtonReleasesNothing"},
    {"H404", "An operator's release is ignored", "the controller continues",
     "a release holds whatever the controller does", "all torque off; step() returns -1",
     "runtime_test:Operator.ReleaseTakesAllTorqueAwayAndHoldsWhateverTheControllerDoes"},
    {"H405", "A fallen robot damages itself", "it falls", "the fall is reported within half a second",
     "fault 30; limp where on_fall = limp",
     "hazard_reaction_test:Reaction.AFallIsReported safety_test:Faults.AFallCanBeMadeToReleaseTheJoints"},
    {"H501", "The robot repeats its last motion", "the controller hangs", "goals stand still within half a second",
     "hold", "hazard_reaction_test:Reaction.AStalledControllerIsHeld"},
    {"H502", "The robot stands stiff for ever", "the controller was killed", "the robot sits down by itself",
     "kneel, then limp", "hazard_reaction_test:Reaction.AControllerThatIsGoneMakesItKneel"},
    {"H503", "The robot drops at the end of a controller", "the controller ends in a stance",
     "it sits before torque goes off", "kneel, a second of rest, limp",
     "hazard_reaction_test:Reaction.TheEndOfAControllerMakesItKneelAndLetGo"},
    {"H504", "Two programs drive at once", "a second controller starts", "one process holds the driving lease",
     "the second one is refused by name", "runtime_process_test:DaemonTest.RefusesASecondControllerAndNamesTheFirst"},
    {"H505", "The robot is stiff and unwatched", "the runtime dies", "the supervisor brings it to rest",
     "hold, kneel, limp; LEDs red",
     "supervisor_test:RescueWatch.AStiffRobotIsAtRestOnlyWhenEveryServoHasLetGo "
     "supervisor_test:Heartbeat.HalfASecondOfStillnessIsTooLong"},
    {"H506", "A crashing controller is started for ever", "it crashes at start",
     "the third crash within a minute is the last", "robot held, LEDs red",
     "supervisor_test:RestartPolicy.TheThirdCrashWithinAMinuteIsTheLast"},
    {"H507", "A dead controller drives again after a lost link", "it died while the link was lost",
     "only a sequence that grows is a sign of life", "kneel",
     "safety_test:Recovery.AControllerThatDiedWhileTheLinkWasLostDoesNotDriveAgain"},
    {"H110", "A joint turns through the servo's own limits",
     "registers 6 and 8 of a servo are narrower than the joint table",
     "goals stay within what robot, controller and servo allow", "ranges intersected at start, one warning a joint",
     "link_pty_test:ServoLimits.NarrowTheLoopsLimitsOnEveryWayToARobot"},
    {"H111", "A controller's stricter limits are ignored", "the loop runs in the daemon, which has settings of its own",
     "a session's [Safety] and [Limits] hold where they are stricter",
     "settings travel with the session and are intersected",
     "safety_test:SessionSettings.HoldForTheirSessionAndNotForTheNext "
     "safety_test:SessionSettings.WhateverNumbersComeTheRobotsGuardsHold"},
    {"H112", "A limp arm runs to an old goal at full speed",
     "a flickering error bit and two lost replies in a takeover", "no torque before the goal has gone out",
     "a suspected joint is neither placed nor switched on",
     "servo_hazards_test:Restart.ASuspectedServoIsNotToldTorqueOnBeforeItsGoalHasGoneOut "
     "servo_hazards_test:Restart.AJointThatIsAskedToStayStaysWhateverHappensToItsReplies"},
    {"H212", "A walk ends although nothing is wrong", "three to five answers of the board are lost",
     "up to five lost answers are ridden through", "goals pause and continue, no takeover",
     "campaign_test:CorrelatedFaults.FiveLostAnswersInARowNeverInterruptDriving"},
    {"H213", "The robot is called driven and no frame reaches it", "the board lacks BULK_READ or SYNC_WRITE",
     "both are tried before the loop starts", "refused with a sentence",
     "serial_test:StartPolicy.ARobotIsCalledDrivableExactlyWhenALoopDrivesIt"},
    {"H214", "Servo data stop for no visible reason", "a former program left XON/XOFF on the serial port",
     "the port starts from a known state", "every flag is set", "serial_test:OpenSerial.ClearsEveryFlagOfAFormerOwner"},
    {"H310", "Half the robot jumps after a brown-out", "a chain or the servo rail loses its supply for a moment",
     "torque comes on only where each joint is, with a speed limit",
     "joints held after one missed answer, then taken over",
     "campaign_test:CorrelatedFaults.ServosThatLoseTheirSupplyTogetherComeBackWithoutAJump "
     "servo_hazards_test:BoardMiss.AServoThatRestartsWhileTheBoardIsNotHeardIsPlacedAnew"},
    {"H311", "A stalled motor is switched on again and again", "a controller streams speeds, gains or torque limits",
     "a shutdown is believed at the first time, with streamed torque limits after a few",
     "routine writes leave the torque limit alone",
     "servo_hazards_test:Shutdown.IsBelievedAtOnceWhenTheSpeedOfTheJointChangesInEveryStep "
     "campaign_test:CorrelatedFaults.AStreamOfTorqueLimitsHidesAFewShutdownsAtMost"},
    {"H312", "A joint is driven blind", "its encoder is stuck",
     "a position that stays while the servo pushes both ways is reported", "fault 26",
     "safety_test:Encoder.APositionThatStaysTheSameWhileTheServoPushesBothWaysIsReported"},
    {"H313", "A robot without battery rattles on and off", "power is lost again and again",
     "power is switched on at most 3 times in 60 s", "then off until a person acts",
     "safety_on_board_test:ReleaseOnTheBoard.ThirtyResetsInARowSwitchPowerOnAgainThreeTimes"},
    {"H314", "A restarted servo runs to an old goal without a speed limit",
     "a stalled board carries out a goal that was on its way when it stalled",
     "one such goal at most, one step from the last; its torque is taken back at the first look",
     "torque off, then taken over where it is",
     "servo_hazards_test:BoardStall/LateGoal.TorqueThatALateGoalSwitchedOnAtARestartedServoIsTakenBackAtOnce/2 "
     "servo_hazards_test:LateGoal.OneIsOnItsWayAtMostAndItIsOneStepAwayFromTheLast"},
    {"H315", "A motor is switched on again and again in a takeover", "it shuts itself off as soon as it has torque",
     "twice is a fact", "left out; other joints kneel",
     "safety_test:TakeOver.AServoThatShutsItselfOffAtOnceIsTriedTwiceAndThenBelieved"},
    {"H406", "A released robot moves again by itself", "a crashed default controller is started again",
     "a session that a program starts clears no latched fault", "limp until START, reset or a person's session",
     "safety_on_board_test:ReleaseOnTheBoard.AfterModeNoServoGetsTorqueUntilStart "
     "supervisor_test:Begin.NothingBeginsWhileAFaultWaitsForAPersonAndStatusSaysSo"},
    {"H407", "A released robot moves again by itself", "the runtime was killed and is started again",
     "a release outlives the runtime", "NAME.released and NAME.held in /dev/shm",
     "runtime_process_test:DaemonTest.ARobotThatWasReleasedStaysSoOverAKilledDaemonUntilAPersonActs "
     "runtime_process_test:DaemonTest.ServoPowerThatIsFoundOffAfterADaemonThatDroveIsARelease "
     "safety_on_board_test:ReleaseOnTheBoard.AResetBeforeOrAfterTheDeathOfALoopThatHeldTheRobotIsARelease"},
    {"H408", "RESET is pressed in the kneel and the robot rises", "power returns in the middle of a pose move",
     "no torque without a person's act", "limp, latched",
     "campaign_test:CorrelatedFaults.ResetInTheMiddleOfAKneelLeavesTheRobotLimp "
     "campaign_test:CorrelatedFaults.ModeAndResetEndTorqueAtAnyMomentAndOnlyAPersonBringsItBack"},
    {"H409", "Somebody lifts a robot that is called limp and is stiff",
     "servos kept torque over a reboot or a dead program", "limp is said only of servos that were looked at",
     "state found_stiff", "safety_test:FoundStiff.ARobotThatSomebodyElseLeftStiffIsNeverCalledLimp"},
    {"H410", "The robot stays stiff after the programs have ended", "it was found stiff and nobody drove",
     "the end of the loop brings it to rest", "kneel, limp",
     "safety_test:FoundStiff.WhenTheLoopClosesItKneelsAndLetsGo"},
    {"H508", "Daemon dies with all joints stiff", "the reader of its messages has gone (SIGPIPE)",
     "messages never end or block the loop's process", "ignored; text dropped",
     "hal_test:Diagnostics.APipeWithoutAReaderIsWrittenToInVainAgainAndAgain "
     "process_fate_test:Fate.ADaemonWhoseMessagesNobodyReadsGoesOnThroughAFault"},
    {"H509", "Ctrl-Z or Ctrl-\\ stops the loop", "job control signals reach an embedded controller",
     "each of the 31 signals has a documented effect", "no effect, or a tidy end",
     "hal_test:Signals.EachHasTheEffectThatTheTableNames "
     "process_fate_test:Fate.SignalsWithoutEffectLeaveAnEmbeddedControllerDriving"},
    {"H510", "Runtime, supervisor and controller die together", "a shared memory file is shortened",
     "each survives or ends with a sentence, the robot at rest", "empty pages in place of the file; the loop closes",
     "hal_test:ShortenedFile.ReadsAsZeroAndIsReportedAsLost "
     "runtime_test:Exchange.LostToSomebodyWhoShortensItsFilesTheLoopBringsTheRobotToRest"},
    {"H511", "Every later controller hangs in step()", "a controller writes at random into the shared memory",
     "controllers can write commands only", "whole values each cycle",
     "runtime_test:Exchange.NoStrayWriteToTheCommandsKeepsTheNextControllerFromDriving "
     "runtime_test:Exchange.OnlyTheLoopsProcessCanWriteWhatTheLoopTells"},
    {"H512", "A controller built elsewhere writes other meanings", "two builds with equal sizes and different fields",
     "different layouts are never used together", "hash of all fields",
     "runtime_test:LayoutHash.TellsOrderTypeNumberAndNestedFieldsApart"},
    {"H513", "Random bytes pass as commands", "the command file is overwritten", "any bytes stay within the limits",
     "every byte is a truth value; numbers are checked",
     "safety_property_test:GuardProperty.RandomBytesInPlaceOfCommandsStayWithinTheLimits"},
    {"H601", "A knee turns without end into its stop", "a servo is in wheel mode", "no loop starts",
     "refused with a sentence",
     "link_pty_test:StartUp.WhatAPersonHasToPutRightIsNotWaitedFor "
     "serial_test:StartPolicy.TheMostSevereFindingDecides"},
    {"H602", "The robot falls at its first step", "a servo of a leg is silent at start",
     "no loop starts without its legs", "waited for, or named absent in robot.ini",
     "link_pty_test:StartUp.ASilentLegServoIsWaitedForUnlessRobotIniNamesIt"},
    {"H603", "A servo that was changed while the loop runs is driven unchecked", "a silent arm servo appears later",
     "a servo that was not checked gets no goal", "left out until the next start",
     "link_pty_test:StartUp.AServoThatAppearsAfterTheStartIsNotDrivenBeforeTheNext "
     "safety_test:LeftOutJoint.GetsNoGoalAndNoTorqueEvenWhenItAnswers"},
    {"H604", "The doctor says FAIL and the loop drives", "two places decide", "one table decides for both",
     "policy table", "serial_test:StartPolicyDocs.TheDoctorsPageHasTheTable"},
    {"H605", "The loop misses every deadline", "the FTDI latency timer is 16 ms",
     "a period that cannot hold is refused", "refused with the command that sets the timer",
     "bus_test:UsbFrame/EightMilliseconds.AreRefusedOnABridgeWithTheDriversDefaultOfSixteen/1 "
     "bus_test:UsbFrame/EightMilliseconds.HoldOnABridgeWhoseLatencyTimerIsOne/1"},
    {"H701", "Another user ends processes of root", "a forged pid in a lock file",
     "orders go to the holder of the lock and to nobody else", "owner and holder checked",
     "runtime_test:FileLock.TheKernelSaysWhoHoldsItWhateverIsWrittenThere "
     "process_fate_test:Home.OrdersGoToNobodyButASupervisorOfTheSameUserOrRoot"},
    {"H702", "Another user drives in the name of the robot", "the remote port is bound while a client drives",
     "the port belongs to one server", "no second bind succeeds",
     "remote_server_test:RemotePort.CannotBeBoundByAnotherUser "
     "remote_server_test:RemotePort.CannotBeBoundBetweenTwoClients"},
    {"H703", "A controller changes the robot's system", "it runs as root",
     "controllers run as a user of the runtime's group", "user darwinop",
     "supervisor_test:Begin.AsRootItIsRefusedUnlessRobotIniSaysSo runtime_test:Users.ThereIsNoWayBackToRoot"},
    {"H704", "A page holds all connections and STOP is not reachable", "32 silent connections",
     "new pages always get in", "the oldest silent connection gives way",
     "remote_web_test:WebServerTest.ServesNewClientsHoweverManyConnectionsAreHeldOpen"},
    {"H705", "Text from outside drives the terminal", "escape sequences in a server's message",
     "text of others is shown, not obeyed", "control characters escaped",
     "remote_client_test:TcpLinkTest.EscapesControlCharactersInTextOfAServer"},
    {"H706", "A settings file keeps the start waiting for ever", "a pipe or an endless device in place of a file",
     "only regular files of at most 1 MB are read", "refused with a sentence",
     "settings_test:TextFile.APipeWithoutAWriterIsRefusedAtOnce"},
});

}  // namespace darwinop
