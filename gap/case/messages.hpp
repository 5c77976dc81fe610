// Phrases that identify the errors of a case and its logs.
#pragma once

namespace darwinop::gap::messages {

// joints without a servo, or with a broken cable
inline constexpr const char* kSilentInSome =
    " never answers, but does in another log; check its cable and measure again, or leave the log out";
inline constexpr const char* kNeverAnswer =
    ": no answer in any log, so neither the limb nor the robot on the floor is tested";

// case.json
inline constexpr const char* kNoFolder = ": there is no such folder";  // after its path
inline constexpr const char* kBeyondFolder = "is outside the folder of the case";
inline constexpr const char* kDigitsBeyondDouble = "a number has more digits than any number can have";
inline constexpr const char* kEndBeforeStart = "is not after `from_s`";
inline constexpr const char* kGivenTwice = "is there twice";
inline constexpr const char* kInvalidName = "is not a valid name";
inline constexpr const char* kMissing = "is missing; give ";
inline constexpr const char* kNeverMoved = "has no effect: that number counts as exact";
inline constexpr const char* kNoFitLog = "has no log with \"role\": \"fit\"";
inline constexpr const char* kNoSide =
    ": the accelerometer does not show on which side the robot lies; write \"up\": \"left\" or \"right\", which is "
    "down";
inline constexpr const char* kNoPRegister = "the case does not have its P register";
inline constexpr const char* kNotJson = "this is not JSON";
inline constexpr const char* kNotJsonObject = "not a JSON object";
inline constexpr const char* kOtherColumn = "is an encoding of another column";
inline constexpr const char* kOtherDatasheetVoltage = "is of another voltage than ";
inline constexpr const char* kOtherGainOrPayload = "which has another kp, payload, arm or supply";
inline constexpr const char* kOtherOfBody = "is one that only a case of one servo has; take fit or held_out";
inline constexpr const char* kOfAnotherRobot =
    " is not one of a DARwIn-OP, so `add` changes all joints of a robot's model";
inline constexpr const char* kOtherJoint = "is another one than that of `logs[0]`";
inline constexpr const char* kRepeatOfAnother = "names or is a log with \"role\": \"validation\" or \"other\"";
inline constexpr const char* kRepeatOfItself = "names the log itself";
inline constexpr const char* kRepeatOfNothing = "names no log of this case";
inline constexpr const char* kSecondSigma = "stands for a number that has a sigma already";
inline constexpr const char* kTwoModels = "and `baseline` are two models";
inline constexpr const char* kUnknownKey = "is not known";
inline constexpr const char* kWholeRobot =
    "is body: a case of the whole robot, which this command does not take; docs/gap/body.md has those that do";
inline constexpr const char* kUnknownParameter = "is not a parameter of an effect";

inline constexpr const char* kManyLogs =
    " logs are searched: expect hours, as the time grows with the square of their number; without --all-logs, minutes";
inline constexpr const char* kUnusableLogs = " cannot be used:";
inline constexpr const char* kLeftOut = "a log is left out: ";

// BAM
inline constexpr const char* kKeysHaveUnits = " (in a CSV; keys of BAM are in rad and s, so convert the numbers)";
inline constexpr const char* kNoBamLogs = "has no *.json; give the folder with the logs of BAM";
inline constexpr const char* kNoTorqueEnable = " rows have no torque_enable and count as torque on";
inline constexpr const char* kNotBamRow =
    "has rows without timestamp or goal_position, more than a tenth; is this a raw log of BAM?";
inline constexpr const char* kKeepsAll = ": --keep holds all logs out; leave some to be fitted";
inline constexpr const char* kNotLogOfFolder = " is none of the usable logs of ";
inline constexpr const char* kReplacesVin = ", counts in place of another `vin` in ";
inline constexpr const char* kSupplyMeasured = " logs have no `vin`: their supply is what they read without load, ";
inline constexpr const char* kSeveralMotors = "logs of several motors; take one with --declare motor=...: ";
inline constexpr const char* kOtherMotors = "logs of other motors are left aside: ";

// folders of raw logs
inline constexpr const char* kArmatureAssumed =
    "armature_kgm2 is not declared and is that of an MX-28 or of --model; a larger servo has a larger one, which fast "
    "motion shows: --declare armature_kgm2=...";
inline constexpr const char* kLeftAside = " is not understood and left aside";
inline constexpr const char* kNotDeclared = ": the logs do not contain all that is needed; declare";
inline constexpr const char* kNotDeclarable = "cannot be declared";  // then a suggestion, or all keys
inline constexpr const char* kNoGoalOfJoint = "there is no goal of joint ";
inline constexpr const char* kOfCsv = "is for CSVs: BAM's logs contain their own; correct those";
inline constexpr const char* kDecimalComma = "has a comma; write the number with a decimal point, as in 2.4";
inline constexpr const char* kNotOnSheet = "not on the data sheet: assumed, by the run-up time of an MX-28";
inline constexpr const char* kSheetNumber = "; --declare replaces it";
inline constexpr const char* kNoCsvs = "has no *.csv; give the folder with the logs";
inline constexpr const char* kOfBam = "is for BAM's logs; declare the numbers of its data sheet";
inline constexpr const char* kNotKeyValue = "is not KEY=VALUE, as in --declare kp=32";
inline constexpr const char* kSeveralValues = "has several values; cut the log where it changes";
inline constexpr const char* kBamOrder =
    "BAM's logs do not say when a goal was written between two reads: every fit finds the time; if it is known, 3 ms "
    "before the read: --declare written_before_s=0.003";
inline constexpr const char* kHasWriteTimes = "has written_s and read_s itself; take the declaration away";
inline constexpr const char* kBeyondItsRow = "rows are %.1f ms apart; give seconds, more than 0 and less than that";
inline constexpr const char* kOfBeforeRead =
    " is for goals that are written before the read of their row; add --declare goal_order=before_read";
inline constexpr const char* kUnitLeftOut = "has a unit that is not known, and is left out";

// logs
inline constexpr const char* kHalfSchedule = "written_s and read_s come together; add the other one";
inline constexpr const char* kScheduleOrder =
    "written_s and read_s are seconds after t_s, first the one and then the other";
inline constexpr const char* kJointNotGiven = "a recording has twenty joints; give the joint of the log";
inline constexpr const char* kLoadIsZero = "load is 0 in every row";
inline constexpr const char* kNotMeasured = ", and counts as not measured";
inline constexpr const char* kLoadHasOtherScale =
    " times the duty that gain and error ask for: its unit is another, or the gain; it counts as not measured";
inline constexpr const char* kLoadsMasked = " readings are masked, of another unit or none: ";
inline constexpr const char* kLoadIsMirrored =
    "the load pushes away from the goal, so that it is taken with the other sign";
inline constexpr const char* kOtherUnit = " has another unit";
inline constexpr const char* kZeroAsNotRead = " is 0, as where it was not read";
inline constexpr const char* kColumnLeftOut = ", and is left out";
inline constexpr const char* kClockWasSet =
    "is not later than the entries before; split the log where the clock was set";
inline constexpr const char* kLoadNotRecognized = " has a unit that was not recognized, and is left out";
inline constexpr const char* kLoadHasOppositeSign = ", but the opposite sign, in ";
inline constexpr const char* kManyMasked = " has no usable reading in ";
inline constexpr const char* kMaskedHeat = "no servo warms or cools so fast";
inline constexpr const char* kMaskedJump = "they jump and come back faster than servo and arm can";
inline constexpr const char* kMaskedMissing = "they are empty";
inline constexpr const char* kMaskedRange = "they are outside the range of a servo";
inline constexpr const char* kMaskedLoad = "they jump and come back while the goal stays";
inline constexpr const char* kMaskedStale = "registers are those of the row before, though the joint moves on";
inline constexpr const char* kMaskedSupply = "no current brings the supply there";
inline constexpr const char* kNoEncoding = "has raw counts and no encoding";
inline constexpr const char* kNoEncodingOf = "is not the name of an encoding";
inline constexpr const char* kNotCount = " is a number that the register cannot hold";
inline constexpr const char* kNotRegular = "it is not a regular file";
inline constexpr const char* kOneInDegrees = "; one is in degrees, so name the column ";
inline constexpr const char* kOtherSteps =
    ": a share of the joint's range is not an angle, so multiply goals and positions by the range in rad; another "
    "encoder needs its ticks_per_rev";
inline constexpr const char* kOutsideServoRange = ", outside the range of a servo (";
inline constexpr const char* kRawCounts = "are these raw counts?";
inline constexpr const char* kStepsOfTurns =
    ", which are the encoder's in turns; multiply goals and positions by 360 and name the columns goal_deg and pos_deg";
inline constexpr const char* kStuckDespiteLoad = "though the servo pushes hard both ways";
inline constexpr const char* kStuckDespiteSpeed = "though the joint moves according to speed";
inline constexpr const char* kStuckLikeLoad = "and so does load, though the goals require torque both ways";
inline constexpr const char* kTooFastForServo = " rad/s, and this servo without load reaches ";

// the data check
inline constexpr const char* kContradicted = "; correct it before anything is fitted";
inline constexpr const char* kContradictions = "The logs contradict numbers of the model:";
inline constexpr const char* kCanReveal = "These data can reveal:";
inline constexpr const char* kMaskedReadings = "Masked readings, which count nowhere:";
inline constexpr const char* kCannotReveal = "These data cannot reveal:";

}  // namespace darwinop::gap::messages
