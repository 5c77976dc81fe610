// The world of the body file: all of it that is no row of a table. Looks, solver, floor, lights, ball.
#pragma once

#include <string_view>

namespace darwinop::twin {

inline constexpr std::string_view kWorld = R"(<mujoco model="darwin-op">
  <!-- Made by `make-body-xml` from the tables in data/: change those, not this file. docs/twin/body.md explains it.
       World: x forward, y left, z up. Links: x left, y up, z forward at zero, as in the model of 2013. -->
  <compiler angle="radian" inertiafromgeom="false"/>
  <option timestep="0.001" integrator="Euler" cone="elliptic" jacobian="sparse" solver="Newton" iterations="50"
          collision="predefined"/>
  <size njmax="600" nconmax="120"/>
  <statistic center="0 0 0.2" extent="0.8"/>
  <visual>
    <global offwidth="1280" offheight="960" fovy="40" azimuth="150" elevation="-18"/>
    <quality offsamples="0" shadowsize="1024"/>
    <headlight ambient="0.35 0.35 0.35" diffuse="0.25 0.25 0.25" specular="0.1 0.1 0.1"/>
    <map znear="0.02" zfar="60" haze="0.4"/>
    <rgba haze="0.78 0.85 0.92 1"/>
  </visual>
  <asset>
    <texture type="skybox" builtin="gradient" rgb1="0.82 0.89 0.96" rgb2="0.45 0.58 0.72" width="64" height="64"/>
    <texture name="floor" type="2d" builtin="checker" rgb1="0.35 0.52 0.38" rgb2="0.41 0.59 0.44" width="256" height="256"/>
    <material name="floor" texture="floor" texrepeat="5 5" texuniform="true" specular="0.1" shininess="0.1"/>
    <material name="dark" rgba="0.13 0.14 0.16 1" specular="0.5" shininess="0.6"/>
    <material name="servo" rgba="0.07 0.07 0.08 1" specular="0.2" shininess="0.2"/>
    <material name="light" rgba="0.78 0.79 0.81 1" specular="0.6" shininess="0.7"/>
    <material name="eye" rgba="0.25 0.65 1 1" emission="0.6"/>
    <material name="glow" rgba="0.3 0.8 1 1" emission="0.5"/>
    <material name="led_red" rgba="1 0.15 0.1 1" emission="0.6"/>
    <material name="led_green" rgba="0.15 1 0.25 1" emission="0.6"/>
    <material name="led_blue" rgba="0.2 0.35 1 1" emission="0.6"/>
    <material name="ball" rgba="0.85 0.1 0.08 1" specular="0.4" shininess="0.5"/>
  </asset>
  <default>
    <!-- Contacts are listed at the end: robot, floor and ball meet, the robot does not meet itself. Looking for all
         that may touch would take a third of a step. -->
    <pair condim="3" friction="1 1 0.005 0.0001 0.0001" solref="0.008 1" solimp="0.95 0.99 0.001"/>
    <!-- Friction of a joint: as stiff as a step of 1 ms allows, so that what rests does not creep. -->
    <joint type="hinge" limited="true" armature="0.003" solreffriction="0.002 1" solimpfriction="0.9999 0.9999 0.001"
           solreflimit="0.005 1" solimplimit="0.95 0.99 0.01"/>
    <!-- The motor of law speed_p: switched on by its friction, which is the greatest torque. -->
    <tendon solreffriction="0.002 1" solimpfriction="0.9999 0.9999 0.001"/>
    <default class="collision">
      <!-- The masks count with self collision only: then all meets all. Robot 2, world 1. -->
      <geom group="3" contype="2" conaffinity="1" rgba="0.9 0.5 0.2 0.5"/>
    </default>
    <default class="visual">
      <geom group="1" contype="0" conaffinity="0"/>
    </default>
  </default>
  <worldbody>
    <light name="sun" directional="true" pos="1 1 4" dir="-0.35 -0.3 -1" diffuse="0.65 0.63 0.6" specular="0.3 0.3 0.3"/>
    <light name="sky" directional="true" pos="-2 -1 3" dir="0.5 0.3 -1" diffuse="0.2 0.22 0.25" castshadow="false"/>
    <geom name="floor" type="plane" size="20 20 0.1" material="floor" priority="1" friction="1 0.005 0.0001"
          solref="0.008 1" solimp="0.95 0.99 0.001"/>
    <camera name="front" mode="targetbody" target="Body" pos="0.9 -0.45 0.5"/>
    <camera name="side" mode="targetbody" target="Body" pos="0.15 -1.0 0.35"/>
    <body name="ball" pos="0.5 0 0.04">
      <freejoint name="ball"/>
      <inertial pos="0 0 0" mass="0.045" diaginertia="4.8e-05 4.8e-05 4.8e-05"/>
      <geom name="ball" type="sphere" size="0.04" material="ball" priority="2" condim="4" friction="0.8 0.001 0.0008"/>
    </body>
)";

}  // namespace darwinop::twin
