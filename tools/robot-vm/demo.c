// Stands for the ROBOTIS demo on the virtual robot: leaves a trace that it ran, and like the demo it holds the serial
// port and does not end by itself.
#include <fcntl.h>
#include <unistd.h>

int main(void) {
  const int trace = open("/darwin/demo-has-run", O_WRONLY | O_CREAT | O_APPEND, 0644);
  if (trace < 0 || write(trace, "run\n", 4) != 4 || fsync(trace) != 0) return 1;
  open("/dev/ttyUSB0", O_RDWR | O_NOCTTY);
  for (;;) pause();
}
