// A controller that includes <webots/Robot.hpp> only and uses what came with it.
#include <webots/Robot.hpp>

using namespace webots;

class Timed : public Robot {
  public:
    Timed() : mBeats(0) {
      gettimeofday(&mStart, NULL);
      pthread_mutex_init(&mMutex, NULL);
      pthread_create(&mThread, NULL, beat, this);
    }
    virtual ~Timed() { pthread_join(mThread, NULL); }
    void run() {
      std::map<std::string, std::vector<double> > log;
      while (step(16) != -1 && log["time"].size() < 100)
        log["time"].push_back(getTime());
      timeval now;
      gettimeofday(&now, NULL);
      std::cout << getName() << ": " << log["time"].size() << " steps, " << mBeats << " beats, "
                << now.tv_sec - mStart.tv_sec << " s" << std::endl;
    }

  private:
    static void *beat(void *self) {
      Timed *timed = static_cast<Timed *>(self);
      pthread_mutex_lock(&timed->mMutex);
      ++timed->mBeats;
      pthread_mutex_unlock(&timed->mMutex);
      return NULL;
    }
    timeval mStart;
    pthread_t mThread;
    pthread_mutex_t mMutex;
    int mBeats;
};

int main() {
  Timed controller;
  controller.run();
  return 0;
}
