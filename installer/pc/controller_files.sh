# shellcheck shell=sh
# Which files of a controller's folder count: the ones to compile from, and the ones the robot gets.

# The one list of what the robot does not get. Sources and build files:
controller_sources='*.cpp *.cc *.cxx *.c *.h *.hpp *.hh *.hxx *.inl *.ipp *.o *.obj *.a *.d *.gch
  Makefile Makefile.* makefile GNUmakefile *.mk CMakeLists.txt CMakeCache.txt CMakePresets.json *.cmake *.ninja
  compile_commands.json *.pro *.vcxproj* *.sln'
# what editors and the simulator leave (names that begin with a dot, .git and .vscode among them, never travel),
controller_leftovers='*~ *.bak *.orig *.rej *.swp #*# *.kate-swp *.core core.[0-9]* *.pyc runtime.ini *.exe *.dll *.so *.dylib'
# and folders with everything in them.
controller_left_out_folders='build build-* cmake-build-* CMakeFiles __pycache__ CVS'

# Prints find's condition for "none of these names": not_named PATTERN...
not_named() {
  # Patterns are for find, not for the shell.
  set -f
  # shellcheck disable=SC2048,SC2086  # the lists are words
  for pattern in $*; do printf ' ! -name %s' "'$pattern'"; done
  set +f
}

# Prints find's words that skip what begins with a dot and folders that hold nothing of the controller.
pruned_folders() {
  set -f
  printf '%s' "\\( -name '.?*'"
  for pattern in $controller_left_out_folders; do printf " -o -type d -name '%s'" "$pattern"; done
  set +f
  printf '%s' ' \) -prune -o'
}

# All a build may need, data included: a source may include any of it. One name a line, sorted.
list_build_files() { # FOLDER
  (cd "$1" && eval "find -L . $(pruned_folders) -type f $(not_named '*.o *.obj *.d *.gch') -print") | LC_ALL=C sort
}

# What the robot gets besides the program. One name a line, sorted.
list_data_files() { # FOLDER NAME
  (cd "$1" && eval "find -L . $(pruned_folders) -type f $(not_named "$controller_sources" "$controller_leftovers") -print") |
    LC_ALL=C grep -Fvx -- "./$2" | LC_ALL=C sort
}

# A folder of somebody else's may hold a link to a private file of yours. Sources may be links to anywhere: they are not sent.
refuse_links_outside() { # FOLDER
  root=$(cd "$1" && pwd -P) || die "cannot enter $1"
  # Only where there is a link at all: this takes a process a file.
  [ -n "$(cd "$1" && eval "find . $(pruned_folders) -type l -print" | head -n 1)" ] || return 0
  odd=$(list_data_files "$1" "${1##*/}" | while IFS= read -r file; do
    place=$(readlink -f "$root/$file")
    case $place in "$root"/*) ;; *) printf '%s\n' "$1/${file#./} leads out of the folder, to $place" ;; esac
  done | head -n 1)
  [ -z "$odd" ] || die "$odd: put the file itself there. A link within the folder is followed"
}

# Everything that could not be sent as it is, said before anything is built.
check_controller_files() { # FOLDER
  looped=$(cd "$1" && eval "find -L . $(pruned_folders) -type f -name .never" 2>&1 >/dev/null) ||
    die "cannot read all of $1: $looped"
  odd=$(cd "$1" && eval "find -L . $(pruned_folders) -type l -print" | head -n 1)
  [ -z "$odd" ] || die "$1/${odd#./} is a link that leads nowhere: remove it, or put the file there"
  odd=$(cd "$1" && eval "find -L . $(pruned_folders) ! -type f ! -type d ! -type l -print" | head -n 1)
  [ -z "$odd" ] || die "$1/${odd#./} is no file and no folder (a pipe, socket or device): it cannot be sent, remove it"
  odd=$(cd "$1" && eval "find -L . $(pruned_folders) -name '*
*' -print" | head -n 1)
  [ -z "$odd" ] || die "$1 holds a name with a line break in it ($odd): rename it"
  refuse_links_outside "$1"
}
