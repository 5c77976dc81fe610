// Falls of a robot whose controller ends or dies while it walks, in the twin: the table of docs/gait.md. No test.
//   walk_falls [MOMENTS]     moments of one gait period, default 12
#include <cstdio>
#include <cstdlib>

#include "twin_ground.hpp"

namespace managers {
namespace {

constexpr double kPeriod = 0.6;      // s
constexpr int kCyclesToRest = 1000;  // 16 s: a dead controller is given up after 10 s

enum class End { kAtOnce, kFinished, kKilled };

bool falls(Ground ground, End end, double moment_s) {
  TwinWalk walk;
  walkOn(walk, ground, moment_s);
  if (walk.lowest() < kFallen) return true;
  // Behaviour before walks finished their step: without its joints, the gait manager cannot finish it.
  if (end == End::kAtOnce) darwinop::webots_api::currentRobot()->joints_taken_by = nullptr;
  if (end != End::kKilled) walk.end();
  runToRest(walk, kCyclesToRest);
  return walk.lowest() < kFallen;
}

int run(int moments) {
  std::printf("Falls at %d moments of a period of %.1f s, X = 1\n\n", moments, kPeriod);
  std::printf("| | ends, kneels at once | ends, finishes the step | kill -9 under the daemon |\n|---|---|---|---|\n");
  for (const auto& [ground, name] : {std::pair{Ground::kLevel, "level floor"},
                                     {Ground::kPush, "push of 5 N for 0.1 s from behind"},
                                     {Ground::kSlope, "slope of 3 degrees downhill"}}) {
    std::printf("| %s |", name);
    for (const End end : {End::kAtOnce, End::kFinished, End::kKilled}) {
      int fallen = 0;
      for (int i = 0; i < moments; ++i) fallen += falls(ground, end, i * kPeriod / moments) ? 1 : 0;
      std::printf(" %d |", fallen);
      std::fflush(stdout);
    }
    std::printf("\n");
  }
  return 0;
}

}  // namespace
}  // namespace managers

int main(int argc, char** argv) {
  return managers::run(argc > 1 ? std::max(1, std::atoi(argv[1])) : 12);
}
