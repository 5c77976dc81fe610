// A controller that includes the header of a device only: it brings the robot, and that of a motor mathematics.
#include DEVICE_HEADER

using namespace webots;
using namespace std;

int main() {
  Robot *robot = new Robot;
  const string names[] = {"Neck", "Head"};
  const vector<string> moved(names, names + 2);
  map<string, double> phase;
  while (robot->step(16) != -1) {
    phase["all"] = 2 * robot->getTime();
#ifdef WITH_MATHEMATICS
    phase["all"] = sin(M_PI * phase["all"]) < INFINITY ? 1 : 0;
#endif
    cout << moved.size() << " at " << phase["all"] << endl;
  }
  delete robot;
  return 0;
}
