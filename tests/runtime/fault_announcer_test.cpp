// Which faults are reported to a person, and how often.
#include "runtime/fault_announcer.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

namespace darwinop::runtime {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// Images 0.1 s apart and what was reported of each.
struct Listener {
  std::ostringstream out;
  FaultAnnouncer announcer{out};
  Sensors seen;

  std::string look() {
    ++seen.cycle;
    seen.time_ns += 100'000'000;
    out.str("");
    announcer.update(seen);
    return out.str();
  }
  void set(Fault fault, bool active) {
    for (std::size_t i = 0; i < kFaults; ++i)
      if (kFaultTable[i].fault == fault) seen.safety.active[i] = active;
  }
  std::string look(Fault fault, bool active) {
    set(fault, active);
    return look();
  }
};

TEST(FaultAnnouncer, ReportsTheBeginOnceWithJointMeaningAndRemedyAndThenTheEnd) {
  Listener l;
  l.seen.safety.worst = Fault::kServoOverload;
  l.seen.safety.worst_joint = 19;
  const FaultRow& fault = row(Fault::kServoOverload);
  EXPECT_EQ(l.look(Fault::kServoOverload, true),
            "darwinop: fault 24 servo_overload (Neck, id 19): " + std::string{fault.meaning} + "; " +
                std::string{fault.remedy} + "\n");
  for (int i = 0; i < 100; ++i) EXPECT_THAT(l.look(), IsEmpty());
  EXPECT_EQ(l.look(Fault::kServoOverload, false),
            std::string{"darwinop: fault 24 servo_overload"} + FaultAnnouncer::kIsOver);
  EXPECT_THAT(l.look(), IsEmpty());
}

TEST(FaultAnnouncer, NamesTheJointOfTheWorstFaultOnly) {
  Listener l;
  l.seen.safety.worst = Fault::kBatteryEmpty;
  l.seen.safety.worst_joint = 0;
  EXPECT_THAT(l.look(Fault::kBatteryEmpty, true), StartsWith("darwinop: fault 21 battery_empty: "));
  l.seen.safety.worst_joint = 3;
  EXPECT_THAT(l.look(Fault::kServoHot, true), StartsWith("darwinop: fault 22 servo_hot: "));
}

TEST(FaultAnnouncer, CountsWhatComesAndGoesWithinFiveSeconds) {
  Listener l;
  std::string text;
  for (int i = 0; i < 20; ++i) text += l.look(Fault::kServoSilent, i % 2 == 0);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
  text.clear();
  for (int i = 0; i < 50; ++i) text += l.look();
  EXPECT_THAT(text, StartsWith(std::string{"darwinop: fault 12 servo_silent"} + FaultAnnouncer::kCameAndWent + "9 "));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
  EXPECT_THAT(l.look(Fault::kServoSilent, true), HasSubstr(row(Fault::kServoSilent).meaning)) << "as new again";
}

TEST(FaultAnnouncer, ReportsAfterFiveSecondsOfOneThatBeganMeanwhileAndLasts) {
  Listener l;
  l.look(Fault::kFell, true);
  l.look(Fault::kFell, false);
  EXPECT_THAT(l.look(Fault::kFell, true), IsEmpty());
  std::string text;
  for (int i = 0; i < 50; ++i) text += l.look();
  EXPECT_THAT(text, StartsWith("darwinop: fault 30 fell: "));
  EXPECT_EQ(l.look(Fault::kFell, false), std::string{"darwinop: fault 30 fell"} + FaultAnnouncer::kIsOver);
}

TEST(FaultAnnouncer, AFallOfATrunkThatIsHeldIsExpectedAndOtherFaultsKeepTheirRemedy) {
  Listener free, held;
  FaultAnnouncer expecting{held.out, true};
  const auto look = [&](Fault fault) {
    held.set(fault, true);
    ++held.seen.cycle;
    held.out.str("");
    expecting.update(held.seen);
    return held.out.str();
  };
  const std::string remedy{row(Fault::kFell).remedy};
  EXPECT_THAT(free.look(Fault::kFell, true), HasSubstr(remedy));
  EXPECT_THAT(look(Fault::kFell), testing::AllOf(HasSubstr(FaultAnnouncer::kExpected), Not(HasSubstr(remedy))));
  EXPECT_THAT(look(Fault::kBatteryLow), HasSubstr(row(Fault::kBatteryLow).remedy));
  Listener limp;
  FaultAnnouncer of_limp{limp.out, true};
  limp.set(Fault::kFell, true);
  limp.seen.cycle = 1;
  limp.seen.safety.reaction = Reaction::kLimp;  // on_fall = limp
  of_limp.update(limp.seen);
  EXPECT_THAT(limp.out.str(), HasSubstr(remedy));
}

TEST(FaultAnnouncer, OneFaultDoesNotSilenceAnother) {
  Listener l;
  l.look(Fault::kFell, true);
  EXPECT_THAT(l.look(Fault::kBatteryLow, true), StartsWith("darwinop: fault 20 battery_low: "));
}

TEST(FaultAnnouncer, SaysNothingBeforeTheFirstCycle) {
  Listener l;
  l.set(Fault::kBusSilent, true);
  l.announcer.update(l.seen);
  EXPECT_THAT(l.out.str(), IsEmpty());
}

}  // namespace
}  // namespace darwinop::runtime
