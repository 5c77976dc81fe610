// Robot under the class name of the simulator's supervisors. A robot has no scene tree to supervise.
#ifndef SUPERVISOR_HPP
#define SUPERVISOR_HPP

#include <webots/Field.hpp>
#include <webots/Node.hpp>
#include <webots/Robot.hpp>

namespace webots {

/// Drives the robot as Robot does. The calls below have no effect and return NULL, false or an empty value, each with
/// one warning, as in simulation for an ordinary robot; Robot::getSupervisor() returns false. Threads: see
/// Robot.
class Supervisor : public Robot {
 public:
  /// Modes of the simulation.
  enum SimulationMode {
    SIMULATION_MODE_PAUSE = 0,
    SIMULATION_MODE_REAL_TIME = 1,
    SIMULATION_MODE_RUN = 2,
    SIMULATION_MODE_FAST = 2
  };

  /// States of movieGetStatus().
  enum MovieStatus {
    MOVIE_READY = 0,
    MOVIE_RECORDING,
    MOVIE_SAVING,
    MOVIE_WRITE_ERROR,
    MOVIE_ENCODING_ERROR,
    MOVIE_SIMULATION_ERROR
  };

  /// Same as Robot().
  Supervisor();
  virtual ~Supervisor();
  /// The Supervisor of this process; NULL: none.
  static Supervisor* getSupervisorInstance();

  /// Absent here: no effect; exit status 0 to 255. End the program instead.
  virtual void simulationQuit(int status);
  /// Absent here: SIMULATION_MODE_REAL_TIME.
  SimulationMode simulationGetMode() const;
  /// Absent here: no effect.
  virtual void simulationSetMode(SimulationMode mode);
  /// Absent here: no effect.
  virtual void simulationReset();
  /// Absent here: no effect.
  virtual void simulationResetPhysics();
  /// Absent here: no effect. An earlier name.
  virtual void simulationPhysicsReset();
  /// Absent here: no effect. An earlier name.
  virtual void simulationRevert();
  /// Absent here: no effect.
  virtual void worldLoad(const std::string& filename);
  /// Absent here: false.
  virtual bool worldSave();
  /// Absent here: false.
  virtual bool worldSave(const std::string& filename);
  /// Absent here: no effect.
  virtual void worldReload();
  /// Absent here: no effect. An earlier name.
  virtual void loadWorld(const std::string& filename);
  /// Absent here: false. An earlier name.
  virtual bool saveWorld();
  /// Absent here: false. An earlier name.
  virtual bool saveWorld(const std::string& filename);

  /// Absent here: no effect; `quality` 1 to 100.
  void exportImage(const std::string& filename, int quality) const;
  /// Absent here: no effect; pixels, `quality` 1 to 100.
  virtual void movieStartRecording(const std::string& filename, int width, int height, int codec, int quality,
                                   int acceleration, bool caption);
  /// Absent here: no effect.
  virtual void movieStopRecording();
  /// Absent here: true.
  bool movieIsReady() const;
  /// Absent here: true.
  bool movieFailed() const;
  /// Absent here: no effect; pixels, `quality` 1 to 100. An earlier name.
  virtual void startMovie(const std::string& filename, int width, int height, int codec, int quality,
                          int acceleration = 1, bool caption = false);
  /// Absent here: no effect. An earlier name.
  virtual void stopMovie();
  /// Absent here: MOVIE_READY. An earlier name.
  int movieGetStatus() const;
  /// Absent here: MOVIE_READY. An earlier name.
  int getMovieStatus() const;
  /// Absent here: false.
  virtual bool animationStartRecording(const std::string& filename);
  /// Absent here: false.
  virtual bool animationStopRecording();
  /// Absent here: no effect; x, y and size 0 to 1 of the window, `color` 0xRRGGBB, `transparency` 0 to 1.
  virtual void setLabel(int id, const std::string& label, double x, double y, double size, int color,
                        double transparency = 0, const std::string& font = "Arial");

  /// Absent here: NULL.
  Node* getRoot() const;
  /// Absent here: NULL.
  Node* getSelf() const;
  /// Absent here: NULL.
  Node* getFromDef(const std::string& name) const;
  /// Absent here: NULL; `id` has no unit.
  Node* getFromId(int id) const;
  /// Absent here: NULL.
  Node* getFromDevice(const Device* device) const;
  /// Absent here: NULL; as Device::getTag().
  Node* getFromDeviceTag(int tag) const;
  /// Absent here: NULL.
  Node* getSelected() const;

  /// Absent here: false.
  bool virtualRealityHeadsetIsUsed() const;
  /// Absent here: NULL. Simulator: m.
  const double* virtualRealityHeadsetGetPosition() const;
  /// Absent here: NULL. Simulator: 3 x 3 matrix, -1 to 1.
  const double* virtualRealityHeadsetGetOrientation() const;

 protected:
  /// For tests, as Robot().
  explicit Supervisor(darwinop::webots_api::RobotImpl* impl);
};

}  // namespace webots

#endif
