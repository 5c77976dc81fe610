#!/usr/bin/env bash
# The installed headers bring in what upstream's did, so that a controller that includes Robot.hpp or a device only
# compiles, as C++98 and as today's C++. Without one of those includes it does not.
#   headers_bring.sh SOURCE_DIRECTORY
set -euo pipefail
cd "$1"
: "${CXX:=c++}"
lab=$(mktemp -d)
trap 'rm -rf "$lab"' EXIT

compiles() { # STANDARD HEADERS SOURCE OPTION...
  "$CXX" -std="$1" -Wall -Werror -fsyntax-only "-I$2" "tests/webots/api/includes/$3" "${@:4}"
}

for standard in c++98 c++20; do
  compiles $standard webots/include OnlyRobot.cpp
  for device in Accelerometer Camera Gyro LED PositionSensor Speaker TouchSensor Supervisor; do
    compiles $standard webots/include OnlyDevice.cpp "-DDEVICE_HEADER=<webots/$device.hpp>"
  done
  for motor in Motor Servo; do
    compiles $standard webots/include OnlyDevice.cpp "-DDEVICE_HEADER=<webots/$motor.hpp>" -DWITH_MATHEMATICS
  done
done

# One include less: HEADER INCLUDE SOURCE OPTION...
needs() {
  rm -rf "$lab/webots"
  cp -r webots/include/webots "$lab"
  grep -q "^#include <$2>$" "$lab/webots/$1" || { echo "$1 does not include <$2>"; exit 1; }
  sed -i "\\|^#include <$2>\$|d" "$lab/webots/$1"
  if compiles c++98 "$lab" "${@:3}" 2>/dev/null; then echo "$3 compiles although $1 does not include <$2>"; exit 1; fi
}
for header in sys/time.h iostream map vector; do needs Robot.hpp $header OnlyRobot.cpp; done
needs Motor.hpp math.h OnlyDevice.cpp '-DDEVICE_HEADER=<webots/Motor.hpp>' -DWITH_MATHEMATICS
for device in Accelerometer Camera Gyro LED Motor PositionSensor Speaker TouchSensor; do
  needs $device.hpp webots/Robot.hpp OnlyDevice.cpp "-DDEVICE_HEADER=<webots/$device.hpp>"
done
# The standard library at hand includes these in others.
for header in pthread.h string; do grep -q "^#include <$header>$" webots/include/webots/Robot.hpp || { echo "Robot.hpp: $header"; exit 1; }; done
