# shellcheck shell=sh disable=SC2154  # variables are shared with the other files
# Questions to the robot about the programs it runs: ./dev build --robot=ARCHITECTURE makes them.

# What the robot runs, the best first.
ask_architectures() { # -> fitting
  fitting=$(robot_run report_architectures </dev/null) || end_unless_well $?
}

# What was built for the robot's installed version.
ask_installed_architecture() { # -> installed
  installed=$(robot_run installed_architecture </dev/null) || end_unless_well $?
}
