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
  /// Why no test measures the cycles from cause to reaction; empty: one does.
  std::string_view untimed = {};
};

// 1xx: a joint moves otherwise than intended. 2xx: bus and board. 3xx: servos and supply. 4xx: a person. 5xx: programs.
// 6xx: start-up. 7xx: access.
inline constexpr auto kHazards = std::to_array<Hazard>({
    {"H101", "A joint jumps when a controller takes over", "the servo's goal register holds an old pose",
     "torque on only at the present position", "confirmed position written as goal, read back, then torque on",
     "safety_test:TakeOver.ANewSessionStartsFromTheConfirmedPresentPoseWithoutAJump "
     "safety_test:TakeOver.GoalIsThePresentPositionAndTorqueComesWhenTheServosAreSeenToHaveIt "
     "hazard_reaction_test:ReactionAtStart.ATakeoverIgnoresTheGoalOfAnEarlierProgram"},
    {"H102", "A joint moves to a position that was never measured", "a corrupted reading passes the checksum",
     "two agreeing readings before a position becomes a goal", "waits for a second reading",
     "safety_test:TakeOver.ACorruptedReadingNeverBecomesAGoal "
     "safety_test:PositionConfirmer.DoesNotBelieveACorruptedReadingNorTheOneAfterIt "
     "hazard_reaction_test:ReactionAtStart.AReadingThatASecondOneContradictsBecomesNoGoal"},
    {"H103", "A joint hits its mechanical stop", "a goal outside the range", "no such goal reaches the bus",
     "goal clamped and counted",
     "safety_test:Driving.GoalsOutsideTheLimitsAreClampedAndCounted "
     "safety_property_test:GuardProperty.WhateverHappensTheLimitsHold "
     "hazard_reaction_test:Reaction.AGoalOutsideTheRangeIsClampedAndCounted"},
    {"H104", "A joint moves at full speed", "a distant goal", "no goal moves faster than max_joint_speed",
     "one step per cycle",
     "hazard_reaction_test:Reaction.AFarGoalMovesByOneStepACycle "
     "safety_test:Driving.AFarGoalIsApproachedAtTheGreatestSpeedPerNominalPeriod"},
    {"H105", "A joint makes a long step", "a cycle was late or skipped", "a step is bounded by the nominal period",
     "ordinary step after an overrun",
     "safety_test:Driving.AnOverrunDoesNotMakeTheNextStepLonger "
     "hazard_reaction_test:Reaction.TheStepAfterAnOverrunIsNoLonger"},
    {"H106", "A joint moves to an undefined goal", "NaN or infinity", "only finite numbers reach the bus",
     "previous value kept and counted",
     "hazard_reaction_test:Reaction.AGoalThatIsNotFiniteMovesNothing "
     "safety_test:Driving.NotANumberKeepsThePreviousGoalAndIsCounted"},
    {"H107", "A joint has no speed limit", "speed register 0 means unlimited", "the speed register is never 0",
     "0 becomes the lowest speed",
     "safety_test:JointLimiter.SpeedNeverBecomesNoLimit "
     "core_test:Speed.ALimitIsNeverZeroBecauseZeroMeansUnlimited "
     "hazard_reaction_test:Reaction.ASpeedLimitOfZeroBecomesTheLowestSpeed"},
    {"H108", "The start move hits something or falls over", "the robot is not in its start pose",
     "start and kneel use the gentle speed; joints arrive together", "slow whatever the controller requests",
     "safety_test:TakeOver.TheStartMoveIsAsSlowWhateverTheControllerAsks "
     "safety_test:Kneel.AllJointsArriveTogetherSoThatTheFeetStayFlatOnTheWayDown "
     "hazard_reaction_test:ReactionAtStart.TheStartMoveIsGentleWhateverTheControllerAsks"},
    {"H109", "A joint blocks in the start move", "an obstacle or a weak joint", "bounded wait, reported",
     "timeout names the joint",
     "safety_test:TakeOver.AJointThatDoesNotGetToTheStartPoseIsReportedAndNotWaitedForForever "
     "hazard_reaction_test:ReactionAtStart.AJointThatBlocksInTheStartMoveIsReported"},
    {"H201", "The robot continues on outdated goals", "the board does not answer",
     "nothing is sent after more than five missed cycles", "offline, then takeover",
     "hazard_reaction_test:Reaction.ASilentBoardEndsSending "
     "safety_test:Recovery.NothingIsSentFromSixCyclesOfSilenceOn"},
    {"H202", "A joint jumps after reconnection", "it was moved meanwhile", "torque on only at the present position",
     "gentle takeover",
     "safety_test:Recovery.AfterALostLinkJointsRestartWhereTheyAreAndCatchUpGently "
     "hazard_reaction_test:Reaction.AJointThatWasMovedDuringAnOutageRestartsWhereItIs"},
    {"H203", "A servo keeps its torque after torque off", "the broadcast is lost",
     "repeated until a reading confirms it", "torque enable read every 20 cycles",
     "safety_test:Driving.ALostTorqueOffIsSentAgain "
     "hazard_reaction_test:Reaction.ALostTorqueOffIsRepeated"},
    {"H204", "A joint stays limp in a stance", "torque on is lost", "a lost torque on is repeated", "taken over again",
     "safety_test:TakeOver.ALostTorqueOnIsSentAgain "
     "hazard_reaction_test:ReactionAtStart.ALostTorqueOnIsRepeated"},
    {"H205", "Torque comes on at a goal that no servo received", "any number of goal frames is lost",
     "torque on only after the goal was read back", "registers 30..33 read back; fault 12 after 20",
     "servo_hazards_test:TakeOver/LostGoals.LeaveTheJointLimpUntilOneHasArrived/5 "
     "safety_test:TakeOver.NoTorqueFindsAnOlderGoalWhateverIsLostOnTheWire "
     "safety_test:TakeOver.TorqueComesOnOnlyAfterAGoalThatTheBoardReceived "
     "safety_test:Driving.GoalsWaitForABoardThatDoesNotAnswer "
     "hazard_reaction_test:ReactionAtStart.TorqueWaitsForAGoalThatArrives"},
    {"H206", "The loop misses its deadline", "bytes arrive without end", "a cycle ends at its deadline",
     "reading ends after wire time plus twice the margin",
     "bus_test:BusOnABadLine.GarbageDoesNotBlockTheLoop "
     "serial_test:Transactions.EndOnContinuousGarbage",
     "always"},
    {"H207", "The loop misses its deadline", "memory allocation", "the loop allocates nothing", "allocation at start",
     "cycle_allocation_test:Cycle.AllocatesNothingInTenThousandCyclesUnderFaults "
     "safety_allocation_test:GuardAllocation.NothingIsAllocatedInAnyState",
     "always"},
    {"H208", "Nineteen servos are not read", "one silent servo blocks the chain of answers",
     "a silent servo costs the others one cycle", "asked last, then left out and asked again",
     "bus_test:AnywhereInTheChain/DeadServoOnTheBus.AllOthersAreReadFromThreeCyclesLaterAndItIsBackWithinASecond/12 "
     "hazard_reaction_test:Reaction.ASilentServoHidesTheOthersForThreeCyclesAtMost"},
    {"H209", "A stale value passes for a measurement", "a missing answer",
     "a value not received is absent, with an age", "ages count up",
     "bus_test:Decoder.AMissingReplyIsAbsentNotZero "
     "campaign_test:Campaign.NothingStalePassesForFreshAndNoPromiseIsBroken "
     "hazard_reaction_test:Reaction.AMissingAnswerShowsInTheAgeOfItsValues"},
    {"H210", "Servo power is cut", "corrupted board write", "the runtime never switches servo power off",
     "only power-on is written",
     "bus_test:Bus.NeverSwitchesServoPowerOff "
     "safety_test:Recovery.OneCorruptedPowerBitIsNotAReset",
     "always"},
    {"H211", "A servo's settings change for good", "a corrupted frame writes to EEPROM", "servo EEPROM is locked",
     "locked after power-on",
     "bus_test:Bus.LocksTheEepromOfEveryServo hazard_reaction_test:ReactionAtStart.EveryEepromIsLockedAfterPowerOn"},
    {"H301", "A restarted servo jumps", "brief loss of plug or supply",
     "torque on only at the present position, with a speed limit", "taken over again",
     "hazard_reaction_test:Reaction.AServoThatRestartsIsTakenOverWhereItIs "
     "safety_test:Recovery.AServoThatTheBusHasGivenUpGetsNoGoalsUntilItsPositionIsConfirmed "
     "servo_hazards_test:Stall/StalledLoop.AServoThatRestartedMeanwhileGetsNoTorqueWithoutASpeedLimit/2"},
    {"H302", "A motor burns", "a servo pushes against a stop until overload shutdown",
     "routine writes do not switch it on again", "left out; other joints kneel",
     "hazard_reaction_test:Reaction.AnOverloadShutdownMakesItKneel "
     "safety_test:Trip.ATrippedServoIsNeverDrivenUntilAsked"},
    {"H303", "A shutdown stays unseen", "the overload bit is lost", "the torque registers also show it",
     "torque limit 0 counts as shutdown",
     "safety_test:Trip.ThePollFindsATorqueLimitOfZeroWithoutAnyErrorBit "
     "hazard_reaction_test:Reaction.AShutdownWithoutItsErrorBitMakesItKneel"},
    {"H304", "A servo overheats", "long work near its limit", "joints slow down before the shutdown",
     "gentle speed from 65 deg C", "hazard_reaction_test:Reaction.HotServosSlowAllJointsDown"},
    {"H305", "A servo shuts itself off in a stance", "it reaches 80 deg C", "the robot sits earlier",
     "kneel from 75 deg C", "hazard_reaction_test:Reaction.AnOverheatedServoMakesItKneel"},
    {"H306", "The battery is damaged or the robot drops", "supply under 10 V", "the robot sits while it can",
     "kneel, then limp", "hazard_reaction_test:Reaction.EmptyBatteryMakesItKneel"},
    {"H307", "A low battery is not reported", "supply under 11 V", "reported", "fault 20",
     "hazard_reaction_test:Reaction.LowBatteryIsReported"},
    {"H308", "A limb is dead unnoticed", "a servo does not answer", "reported by name", "fault 12",
     "hazard_reaction_test:Reaction.ASilentServoIsReported"},
    {"H309", "One damaged error byte stops the robot", "a bit error", "two readings are required",
     "left out for one cycle, then taken over",
     "safety_test:Trip.OneCorruptedErrorByteIsNotAFaultAndTheJointRestartsWhereItIs "
     "hazard_reaction_test:Reaction.OneDamagedErrorByteLeavesAJointOutForMoments"},
    {"H401", "A person cannot stop the robot", "it moves towards somebody", "MODE switches all torque off",
     "limp, latched",
     "hazard_reaction_test:Reaction.ModeSwitchesAllTorqueOff "
     "safety_test:Kneel.TheButtonReleasesAllJointsAtOnceAndStaysReleased"},
    {"H402", "The robot moves again under a hand", "servo power returns by itself", "no torque without a person's act",
     "limp until START or a person's session", "hazard_reaction_test:Reaction.LostServoPowerLeavesEveryJointLimp"},
    {"H403", "A brief touch drops the robot", "MODE is touched", "a press under 0.25 s has no effect", "debounced",
     "safety_test:Kneel.AShortPressOrTheOtherButtonReleasesNothing", "always"},
    {"H404", "An operator's release is ignored", "the controller continues", "a release holds",
     "all torque off; step() returns -1",
     "runtime_test:Operator.ReleaseTakesAllTorqueAwayAndHoldsWhateverTheControllerDoes "
     "hazard_reaction_test:Reaction.AReleaseByAnOperatorSwitchesAllTorqueOff"},
    {"H405", "A fallen robot damages itself", "it falls", "reported within half a second",
     "fault 30; limp with on_fall = limp",
     "hazard_reaction_test:Reaction.AFallIsReported "
     "safety_test:Faults.AFallCanBeMadeToReleaseTheJoints"},
    {"H501", "The robot repeats its last motion", "the controller hangs", "goals stop within half a second", "hold",
     "hazard_reaction_test:Reaction.AStalledControllerIsHeld"},
    {"H502", "The robot stands stiff for ever", "the controller was killed", "the robot sits down", "kneel, then limp",
     "hazard_reaction_test:Reaction.AControllerThatIsGoneMakesItKneel"},
    {"H503", "The robot drops when a controller ends", "it ends in a stance", "it sits before torque off",
     "kneel, one second, limp", "hazard_reaction_test:Reaction.TheEndOfAControllerMakesItKneelAndReleaseTorque"},
    {"H504", "Two programs drive at once", "a second controller starts", "one driving lease",
     "the second is refused by name", "runtime_process_test:DaemonTest.RefusesASecondControllerAndNamesTheFirst",
     "process"},
    {"H505", "The robot is stiff and unwatched", "the runtime dies", "the supervisor brings it to rest",
     "hold, kneel, limp; LEDs red",
     "supervisor_test:RescueWatch.ARobotUnderTorqueIsAtRestOnlyWhenEveryServoIsLimp "
     "supervisor_test:Heartbeat.HalfASecondWithoutACycleIsTooLong",
     "process"},
    {"H506", "A crashing controller restarts for ever", "it crashes at start",
     "no restart after three crashes a minute", "robot held, LEDs red",
     "supervisor_test:RestartPolicy.TheThirdCrashWithinAMinuteIsTheLast", "process"},
    {"H507", "A dead controller drives after reconnection", "it died during the outage",
     "only a growing sequence number counts as alive", "kneel",
     "safety_test:Recovery.AControllerThatDiedWhileTheLinkWasLostDoesNotDriveAgain "
     "hazard_reaction_test:Reaction.AControllerThatDiedDuringAnOutageMakesItKneel"},
    {"H110", "A joint exceeds the servo's own limits", "registers 6 and 8 are narrower than the joint table",
     "goals respect robot, controller and servo limits", "ranges intersected, one warning per joint",
     "link_pty_test:ServoLimits.NarrowTheLoopsLimitsOnEveryWayToARobot", "start-up"},
    {"H111", "A controller's stricter limits are ignored", "the daemon has its own settings",
     "a session's stricter [Safety] and [Limits] apply", "settings are sent and intersected",
     "safety_test:SessionSettings.HoldForTheirSessionAndNotForTheNext "
     "safety_test:SessionSettings.WhateverNumbersComeTheRobotsGuardsHold "
     "session_limits_test:SessionLimits.UnderTheDaemonTheServosGetTheControllersStricterGoalsInItsSessionOnly "
     "hazard_reaction_test:Reaction.StricterSettingsOfASessionHoldFromItsFirstGoalOn"},
    {"H112", "A limp arm runs to an old goal at full speed", "error bit and two lost replies in a takeover",
     "no torque before the goal was sent", "a suspected joint stays off",
     "servo_hazards_test:Restart.ASuspectedServoGetsNoTorqueOnBeforeItsGoalHasGoneOut "
     "servo_hazards_test:Restart.AJointThatIsAskedToStayStaysWhateverHappensToItsReplies "
     "hazard_reaction_test:ReactionAtStart.AnErrorBitAndTwoLostRepliesInATakeoverLetNoJointJump"},
    {"H212", "A walk ends without need", "three to five lost board answers", "up to five are tolerated",
     "goals pause, no takeover",
     "campaign_test:CorrelatedFaults.FiveLostAnswersInARowNeverInterruptDriving "
     "hazard_reaction_test:Reaction.FiveLostAnswersOnlyDelayTheNextGoal"},
    {"H213", "The robot counts as driven without effect", "BULK_READ or SYNC_WRITE is missing",
     "both are tested at start", "refused with a message",
     "serial_test:StartPolicy.ARobotIsReportedDrivableExactlyWhenALoopDrivesIt "
     "link_pty_test:OtherHardware.ABoardWithoutAnInstructionOfTheLoopIsRefusedByItsName "
     "link_pty_test:OtherHardware.ABoardWithOneBlockLengthIsDriven",
     "start-up"},
    {"H214", "Servo data stop without visible reason", "the port was left with XON/XOFF",
     "the port starts from a known state", "all flags are set",
     "serial_test:OpenSerial.ClearsEveryFlagOfThePreviousOwner", "start-up"},
    {"H215", "Nothing is read", "without a board the servo that is read first is silent",
     "the next cycle begins with a servo of another chain", "read in another order",
     "servo_hazards_test:OfAnyChain/SilentServo.OnlyCostsTheOthersMoments/0 "
     "bus_test:FirstServoOfTheList.ComesToEveryServoWhenAllButOneAreDead "
     "hazard_reaction_test:ReactionWithoutBoard.ASilentFirstServoHidesTheOthersForThreeCyclesAtMost"},
    {"H216", "A stale value passes for a measurement", "without a board a servo's late reply looks like the first one",
     "the first reply has a length that no other servo is read with, and it changes", "late replies are discarded",
     "bus_test:FirstServo.LateRepliesOfAnyServoOpenNothing "
     "campaign_test:Campaign.WithoutABoardNothingStalePassesForFreshEither",
     "always"},
    {"H217", "Servos are driven on outdated evidence", "without a board no servo answers",
     "nothing is sent after more than five missed cycles", "offline, then takeover",
     "servo_hazards_test:WithoutBoard.AnUnpluggedAdapterDoesNotCountAsAnInterruptedSupply "
     "hazard_reaction_test:ReactionWithoutBoard.SilentServosEndSending"},
    {"H310", "Many joints jump after a brown-out", "brief supply loss of a chain or all servos",
     "torque on only at the present position, with a speed limit", "held after one missed answer, then taken over",
     "campaign_test:CorrelatedFaults.ServosThatLoseTheirSupplyTogetherComeBackWithoutAJump "
     "servo_hazards_test:BoardMiss.AServoThatRestartsWhileTheBoardIsSilentIsPlacedAgain "
     "hazard_reaction_test:Reaction.ServosThatRestartTogetherAreTakenOverWhereTheyAre"},
    {"H311", "A stalled motor is switched on repeatedly", "a stream of speeds, gains or torque limits",
     "the first shutdown counts", "torque limits do not go with goals while a servo works at its limit",
     "servo_hazards_test:Shutdown.IsBelievedAtOnceWhenTheSpeedOfTheJointChangesInEveryStep "
     "campaign_test:CorrelatedFaults.AStreamOfTorqueLimitsHidesNoShutdown "
     "hazard_reaction_test:ReactionAtStart.AStreamOfTorqueLimitsHidesNoShutdown"},
    {"H312", "A joint is driven without feedback", "its encoder is stuck",
     "a constant position while the servo pushes both ways is reported", "fault 26",
     "safety_test:Encoder.APositionThatStaysTheSameWhileTheServoPushesBothWaysIsReported "
     "hazard_reaction_test:ReactionAtStart.AnEncoderThatIsStuckIsReported"},
    {"H313", "Servo power switches on and off repeatedly", "repeated power loss", "at most 3 power-ons in 60 s",
     "off until a person acts", "safety_on_board_test:ReleaseOnTheBoard.ThirtyResetsInARowSwitchPowerOnAgainThreeTimes",
     "always"},
    {"H314", "A restarted servo runs to an old goal without a speed limit", "a stalled board executes a goal late",
     "at most one such goal, one step away; torque off at the next poll", "torque off, then takeover",
     "servo_hazards_test:BoardStall/LateGoal.TorqueThatALateGoalSwitchedOnAtARestartedServoIsTakenBackAtOnce/2 "
     "servo_hazards_test:LateGoal.OneIsOnItsWayAtMostAndItIsOneStepAwayFromTheLast "
     "hazard_reaction_test:ReactionAtStart.TorqueOfALateGoalIsTakenBack"},
    {"H315", "A motor is switched on repeatedly in a takeover", "overload shutdown at torque on",
     "two attempts at most", "left out; other joints kneel",
     "safety_test:TakeOver.AServoThatShutsItselfOffAtOnceIsTriedTwiceAndThenBelieved "
     "hazard_reaction_test:ReactionAtStart.AServoThatShutsItselfOffInATakeoverIsTriedTwiceAtMost"},
    {"H316", "The battery is damaged or the robot drops", "without a board the supply is under 10 V",
     "the servos measure it", "kneel, then limp",
     "hazard_reaction_test:ReactionWithoutBoard.AnEmptyBatteryMakesItKneel"},
    {"H406", "A released robot moves again by itself", "a crashed default controller restarts",
     "a program's session clears no latched fault", "limp until START, reset or a person's session",
     "safety_on_board_test:ReleaseOnTheBoard.AfterModeNoServoGetsTorqueUntilStart "
     "supervisor_test:Begin.ALatchedFaultBlocksTheStartAndStatusReportsIt",
     "always"},
    {"H407", "A released robot moves again by itself", "a killed runtime restarts", "a release outlives the runtime",
     "NAME.released and NAME.held in /dev/shm",
     "runtime_process_test:DaemonTest.ARobotThatWasReleasedStaysSoOverAKilledDaemonUntilAPersonActs "
     "runtime_process_test:DaemonTest.AFifoInThePlaceOfItsRecordMeansAReleaseUntilAPersonActs "
     "runtime_process_test:DaemonTest.ServoPowerThatIsFoundOffAfterADaemonThatDroveIsARelease "
     "supervisor_system_test:Home.AfterAResetWhileNoLoopRanItWaitsForAPerson "
     "safety_on_board_test:ReleaseOnTheBoard.AResetBeforeOrAfterTheDeathOfALoopThatHeldTheRobotIsARelease",
     "process"},
    {"H408", "The robot rises after RESET", "power returns during a kneel", "no torque without a person's act",
     "limp, latched",
     "campaign_test:CorrelatedFaults.ResetInTheMiddleOfAKneelLeavesTheRobotLimp "
     "campaign_test:CorrelatedFaults.ModeAndResetEndTorqueAtAnyMomentAndOnlyAPersonBringsItBack "
     "hazard_reaction_test:Reaction.ResetInAKneelLeavesTheRobotLimp"},
    {"H409", "A stiff robot is reported limp", "servos kept torque after a reboot or crash",
     "only servos that were read are reported limp", "state found_stiff",
     "safety_test:FoundStiff.ARobotThatSomebodyElseLeftStiffIsNeverCalledLimp "
     "hazard_reaction_test:ReactionAtStart.AStiffRobotIsReportedStiff"},
    {"H410", "The robot stays stiff after all programs end", "found stiff, never driven", "the loop brings it to rest",
     "kneel, limp",
     "safety_test:FoundStiff.WhenTheLoopClosesItKneelsAndReleasesTorque "
     "hazard_reaction_test:ReactionAtStart.ARobotFoundStiffIsBroughtToRestWhenTheLoopCloses"},
    {"H411", "The robot moves again under a hand", "without a board the supply of the servos returns by itself",
     "no torque without a person's act", "restarted servos are polled first; limp, latched",
     "servo_hazards_test:WithoutBoard/Outage.NoServoGetsTorqueAfterItBeforeAPersonActs/7 "
     "servo_hazards_test:WithoutBoard.AnInterruptionAfterTheDeathOfALoopThatHeldTheRobotIsARelease "
     "servo_hazards_test:Stall/StalledLoopWithoutBoard.ASupplyThatWasInterruptedMeanwhileLeavesEveryJointLimp/0 "
     "hazard_reaction_test:ReactionWithoutBoard.AnInterruptedSupplyLeavesEveryJointLimp "
     "hazard_reaction_test:ReactionWithoutBoard.AnInterruptedSupplyInAKneelLeavesEveryJointLimp"},
    {"H412", "A person cannot stop the robot", "without a board there is no MODE button", "an operator can release it",
     "all torque off; step() returns -1",
     "hazard_reaction_test:ReactionWithoutBoard.AReleaseByAnOperatorSwitchesAllTorqueOff"},
    {"H415", "A robot left stiff is reported at rest", "a stuck servo, or a silent board",
     "success only if every servo was seen limp", "exit code, joints named",
     "runtime_test:TorqueLeft.AServoThatWasNotPolledForTwoRoundsIsUnknown "
     "supervisor_system_test:UnderTorque.AServoThatIgnoresTorqueOffIsNamedByStopAndSupervisor "
     "supervisor_system_test:UnderTorque.ABoardThatIsSilentAtTheEndLeavesAllJointsUnknown "
     "runtime_process_test:Run.NamesAServoThatIsSilentAtTheEndForItMayBeStiff",
     "process"},
    {"H416", "A robot that sits limp rises in somebody's hands",
     "a controller that hung for gone_s resumes, or power returns after it died",
     "a session that was given up never drives again", "limp; step() returns -1",
     "safety_test:Kneel.AControllerThatWasGivenUpDoesNotDriveAgainAndANewSessionDoes "
     "safety_test:GivenUp.AControllerThatDiesWhileItWaitsForPowerRaisesNoRobotWhenItReturns",
     "always"},
    {"H417", "A limp robot gets torque without a controller", "a session ends while it takes the robot over",
     "without torque nothing is sat down or held", "limp",
     "safety_test:TakeOver.ALimpRobotStaysLimpIfTheSessionEndsBeforeTorqueIsOn "
     "safety_test:Hold.ARobotWithoutTorqueStaysLimpWheneverItIsStopped "
     "window_test:WindowDriveThread.AStopBeforeTorqueLeavesTheRobotLimp",
     "always"},
    {"H418", "The robot stands with nothing to watch it", "the daemon ends a session that holds at its end",
     "the end of the loop follows the robot's own on_exit", "kneel, limp",
     "safety_test:Kneel.AtTheEndOfTheLoopTheRobotsOwnExitHolds "
     "runtime_process_test:DaemonTest.ASessionThatHoldsAtItsEndDoesNotKeepTheRobotUpWhenTheDaemonEnds",
     "process"},
    {"H419", "The robot rises when its cable is plugged in", "a restart waits for a rescue and is then stopped",
     "a stop cancels what waits", "stays limp",
     "supervisor_system_test:Home.AStopOfTheControllerCancelsARestartThatWaitsForARescue", "process"},
    {"H420", "The robot gets up by itself", "the supervisor was killed and is started again",
     "after that only a person starts the controller", "runtime starts, robot limp",
     "supervisor_system_test:Home.AfterAKilledSupervisorTheNextStartsNoController", "process"},
    {"H421", "The robot gets up during an upgrade", "its controller was stopped before",
     "a stop holds until the next boot or a person's restart", "runtime starts, robot limp",
     "supervisor_system_test:Home.AControllerThatWasStoppedStaysSoWithTheNextSupervisor", "process"},
    {"H422", "A person cannot stop the robot", "the page lost it, and it completes its steps",
     "STOP works from every page until the robot holds", "all joints hold at once",
     "window_test:WindowSteeringSession.StopWorksWhileTheLastStepsAreCompleted "
     "window_test:WindowSteeringSession.EveryPageCanStopTheRobot",
     "always"},
    {"H423", "A person stops the robot, and it moves", "it is being taken over, starts, or its cable is out",
     "a stopped session takes nothing over and moves nothing", "held as it is",
     "safety_test:Hold.AMoveToTheStartPoseEndsWhereItIs "
     "safety_test:Hold.ARobotThatAnotherProgramLeftStiffIsLeftAsItIs "
     "safety_test:Hold.ARobotHeldByTheSessionBeforeIsHeldOn safety_test:Hold.AStopDuringAnOutageHoldsAfterIt",
     "always"},
    {"H508", "Daemon dies with all joints stiff", "its output pipe is closed (SIGPIPE)",
     "messages never end or block the process", "ignored; text dropped",
     "hal_test:Diagnostics.WritingToAClosedPipeFailsEachTime "
     "process_fate_test:Fate.ADaemonWithUnreadOutputContinuesThroughAFault",
     "signal"},
    {"H509", "Ctrl-Z or Ctrl-\\ stops the loop", "job control reaches an embedded controller",
     "all 31 signals have a documented effect", "none, or a normal end",
     "hal_test:Signals.EachHasTheEffectInTheTable "
     "process_fate_test:Fate.SignalsWithoutEffectLeaveAnEmbeddedControllerDriving",
     "signal"},
    {"H510", "All processes die together", "a shared file is truncated",
     "each survives, or ends with the robot at rest", "zero pages replace the file; the loop closes",
     "hal_test:ShortenedFile.ReadsAsZeroAndIsReportedAsLost "
     "runtime_test:Exchange.LostToSomebodyWhoShortensItsFilesTheLoopBringsTheRobotToRest",
     "process"},
    {"H511", "Every later controller hangs in step()", "a controller corrupts shared memory",
     "controllers write commands only", "commands copied whole each cycle",
     "runtime_test:Exchange.NoStrayWriteToTheCommandsKeepsTheNextControllerFromDriving "
     "runtime_test:Exchange.OnlyTheLoopsProcessCanWriteTheLoopsMemory",
     "always"},
    {"H512", "An incompatible controller misreads the exchange", "equal size, different fields",
     "layouts must be equal", "hash of all fields",
     "runtime_test:LayoutHash.DistinguishesOrderTypeNumberAndNestedFields", "start-up"},
    {"H513", "Random bytes pass as commands", "overwritten command file", "any bytes stay within the limits",
     "any byte is a valid boolean; numbers are checked",
     "safety_property_test:GuardProperty.RandomBytesInPlaceOfCommandsStayWithinTheLimits", "always"},
    {"H601", "A knee turns into its stop", "wheel mode", "no loop starts", "refused with a message",
     "link_pty_test:StartUp.WhatAPersonHasToPutRightIsNotWaitedFor "
     "serial_test:StartPolicy.TheMostSevereFindingDecides",
     "start-up"},
    {"H602", "The robot falls at the first step", "a leg servo is silent", "no start without legs",
     "wait, or `absent` in robot.ini", "link_pty_test:StartUp.ASilentLegServoIsWaitedForUnlessRobotIniNamesIt",
     "start-up"},
    {"H603", "A replaced servo is driven unchecked", "a silent servo appears later", "an unchecked servo gets no goal",
     "left out until the next start",
     "link_pty_test:StartUp.AServoThatAppearsAfterTheStartIsNotDrivenBeforeTheNext "
     "safety_test:LeftOutJoint.GetsNoGoalAndNoTorqueEvenWhenItAnswers "
     "safety_test:JointWithoutWrites.GetsNoTorqueOffEither",
     "start-up"},
    {"H604", "The doctor says FAIL and the loop drives", "two places decide", "one policy table", "same decision",
     "serial_test:StartPolicyDocs.TheDocumentationHasTheTable", "start-up"},
    {"H606", "Unknown registers are written", "a servo or board of another model, or one that was never judged",
     "model read and judged before any write", "refused; in a rescue, left as it is",
     "link_pty_test:OtherHardware.ARescueWritesNothingToAServoOfAnotherModel "
     "link_pty_test:OtherHardware.ABoardOfAnotherModelIsRefusedUnlessRobotIniPermitsIt "
     "link_test:EntryPoints.NothingWritesToASerialLineButWhatHasJudgedTheRobot "
     "serial_test:ThanAnMx28/AnotherServo.GetsNoWriteOfAnyKindAtStart/Case0 "
     "serial_test:JudgedFirst.AServoThatAnswersPingsOnlyIsRefusedUntilTheDoctorHasFixedIt "
     "serial_test:JudgedFirst.NothingIsWrittenToABoardOfAnotherModelNorToItsServos "
     "bus_test:Bus.LocksNoServoThatMayNotBeWrittenTo "
     "safety_test:JointWithoutWrites.ThatIsStiffStaysSoAndIsReportedWhileTheOthersComeToRest",
     "start-up"},
    {"H607", "A joint pushes harder than asked for", "a servo of a stronger model",
     "a torque in N m is the same at every joint", "refused unless robot.ini permits it; its limits are scaled",
     "bus_test:StallTorques.AStrongerServoGetsTheTorqueLimitThatWasAskedForAndNotItsOwnMaximum "
     "link_pty_test:OtherHardware.AnMx64PermittedByRobotIniGetsTheTorqueLimitOfAnMx28 "
     "serial_test:Permitted/StrongerServo.IsRefusedWithItsNameAndTheSettingThatPermitsIt/Model310",
     "start-up"},
    {"H608", "Buttons and servo power are not watched", "robot.ini says that there is no board, or says nothing of it",
     "servos alone are driven only with board = none, a board only without it", "refused with a message",
     "serial_test:ProbeWithoutBoard.NothingIsDrivenThatNobodyPermitted "
     "serial_test:ProbeWithoutBoard.ABoardIsRefusedBeforeAnythingIsWritten "
     "link_pty_test:ServosAlone.ABoardThatAnswersAllTheSameIsRefused",
     "start-up"},
    {"H605", "The loop misses every deadline", "FTDI latency timer of 16 ms", "an impossible period is refused",
     "refused; the message names the fix",
     "bus_test:UsbFrame/EightMilliseconds.AreRejectedWithTheDefaultLatencyTimerOfSixteen/1 "
     "bus_test:UsbFrame/EightMilliseconds.WorkWithALatencyTimerOfOne/1",
     "start-up"},
    {"H701", "Another user ends root's processes", "a forged pid in a lock file",
     "signals go to the lock's holder only", "owner and holder checked",
     "runtime_test:FileLock.TheKernelSaysWhoHoldsItWhateverIsWrittenThere "
     "process_fate_test:Home.CommandsReachOnlyASupervisorOfTheSameUserOrRoot",
     "access"},
    {"H702", "Another user impersonates the robot", "the remote port is bound meanwhile",
     "the port belongs to one server", "a second bind fails",
     "hal_net_test:RemotePort.CannotBeBoundByAnotherUser "
     "hal_net_test:RemotePort.CannotBeBoundBetweenTwoClients",
     "access"},
    {"H703", "A controller changes the robot's system", "it runs as root", "controllers run as an unprivileged user",
     "user darwinop",
     "supervisor_test:Begin.RootIsRejectedUnlessRobotIniAllowsIt "
     "runtime_test:Users.ThereIsNoWayBackToRoot",
     "access"},
    {"H704", "STOP is not reachable", "32 silent connections", "new pages are always accepted",
     "the oldest silent connection closes",
     "remote_web_test:WebServerTest.ServesNewClientsHoweverManyConnectionsAreHeldOpen", "access"},
    {"H705", "Remote text controls the terminal", "escape sequences in a server's message",
     "remote text is never interpreted", "control characters escaped",
     "remote_client_test:TcpLinkTest.EscapesControlCharactersInTextOfAServer", "access"},
    {"H706", "The start waits for ever", "settings in a pipe or endless device",
     "only regular files up to 1 MB are read", "refused with a message",
     "hal_test:TextFile.APipeWithoutAWriterIsRefusedAtOnce", "start-up"},
});

}  // namespace darwinop
