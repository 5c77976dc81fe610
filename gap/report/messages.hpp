// Message texts of reports that more than one place needs: terminal, page, model file and tests.
#pragma once

namespace darwinop::gap::messages {

// Why an effect that improves the fit is not named: after its id, and after its title.
inline constexpr const char* kPredictsAsWell = "predicts other logs as well";
inline constexpr const char* kMayPredictBetter = "may predict other logs better";
inline constexpr const char* kVoltage = "fits, but the measured voltage does not drop as this effect requires";
inline constexpr const char* kUndecided = "possible; the report names the experiment that decides";
inline constexpr const char* kNoPredictiveGain = "fits these logs, but does not predict others better";
inline constexpr const char* kWorsensHeldOut = "fits these logs and worsens the held-out logs";
inline constexpr const char* kSmallShare = "gains more than chance, and hardly reduces the gap";
inline constexpr const char* kVoltageInFull =
    " would improve the fit, but the measured voltage does not drop as this effect requires.";
inline constexpr const char* kNoPredictiveGainInFull =
    " would improve the fit, but does not predict other logs better.";
inline constexpr const char* kWorsensHeldOutInFull =
    " would improve the fit, but increases the error on the held-out logs.";
inline constexpr const char* kSmallShareInFull =
    " gains more than chance would, but removes less than a twentieth of what is unexplained.";

// The sentence of a verdict.
inline constexpr const char* kOnlyNoise = "The model explains these logs: what is left is noise.";
inline constexpr const char* kAgreement = "The recordings agree with the model, and everything is tested.";
inline constexpr const char* kNotAllTested = "What was tested agrees with the model; not everything is tested.";
inline constexpr const char* kOpenSignals = "Signals that are not explained: ";
inline constexpr const char* kNotIdentified = "something that these logs do not identify: ";
inline constexpr const char* kPerhaps = ", and these logs do not decide whether also ";
inline constexpr const char* kOutsideCatalogue = " known effects explains";
inline constexpr const char* kTooLittle =
    "These logs differ from the model, but by too little, or in too few ways, to say why.";
inline constexpr const char* kTooFewLogs =
    "These logs differ from the model, but a roughly known motor needs three logs that are not held out, "
    "repeats counted once, to say why.";
inline constexpr const char* kRemainder = "; a remainder is left that no further effect was found to explain.";
inline constexpr const char* kWriteTime =
    "Goals were written %s ms before the read of their row: fitted, since no log says it. A delay below one row looks "
    "the same.";
inline constexpr const char* kWidened = "The intervals are widened by the remainder.";
inline constexpr const char* kExplained =
    "Fitted to these logs, which it explains down to the noise; the others have the remainder: ";
inline constexpr const char* kTried = "The best effects that were tried, not named and not in the changed model: ";
inline constexpr const char* kMissingThere = ": something is missing there.";  // of the held-out logs
inline constexpr const char* kUnchanged = "is within noise of what it was, ";
inline constexpr const char* kGrowsSlightly = "grows slightly, from ";
inline constexpr const char* kNotIdentifiable = "not identifiable from these data";
inline constexpr const char* kHeldOutLogs = "held-out logs";
inline constexpr const char* kOtherLogs = "other logs of the folder";
/// What held-out logs decide: they are a validation set, not a test set.
inline constexpr const char* kHeldOutUse =
    "An effect that makes these logs worse is dropped: they are not independent of the choice of names, but no number "
    "is fitted to them.";
inline constexpr const char* kOtherUse =
    "No number is fitted to these logs. Those with \"role\": \"validation\", one of each motion and bench, show which "
    "effects of a servo from a data sheet predict better: alone, if they are at least as many as the fitted logs; "
    "else together with those, each left out. Those with \"role\": \"other\" decide nothing.";
inline constexpr const char* kNoHeldOutLog = "No log of this case is held out.";
inline constexpr const char* kWorse = "do not use the changed model";
inline constexpr const char* kBelowFloorFlag = "below the floor";
inline constexpr const char* kBelowFloor =
    "Below the floor: closer to these data than noise lets any model come. Either the servo is quieter than assumed, "
    "or the log is not a measurement of its own: a copy, or a simulation. Do not count it as a success.";

// Effects that cannot be added, and a comment in the model file.
inline constexpr const char* kNamesNoEffect = "names no effect";
inline constexpr const char* kOtherModel =
    ": the search was on another model than this one; what it adds to numbers counts twice where this one has it "
    "already. Give the model of the search with --model";
inline constexpr const char* kOtherData =
    ": the search was on other recordings than these: is it the report of another case of this name?";
inline constexpr const char* kNoRivals =
    "has no rivals; give the report.json that `darwinop gap run` writes beside its page";
inline constexpr const char* kNotAResult = "not a result of darwinop gap";
inline constexpr const char* kNumberGivenTwice = "this number is given twice";
inline constexpr const char* kTypicalValue = "not given, the typical value";
inline constexpr const char* kShiftNeedsMass =
    ": the links of a robot have no common centre of mass; a shift is written as a mass of equal moment. Give also ";
inline constexpr const char* kTogether = " of this joint, moved by the fit, together with the effect: ";
inline constexpr const char* kEqualMoment = ": of each link, with the moment that the load has by ";
inline constexpr const char* kBeyondModel =
    " would be needed for the equal moment, which is more than a model may have";
inline constexpr const char* kUnitNotAllowed = "the value is a number without unit";

}  // namespace darwinop::gap::messages
