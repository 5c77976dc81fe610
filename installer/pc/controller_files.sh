# shellcheck shell=sh
# Selects files of a controller's folder: build inputs, and files to send.

# Files that are not sent. Sources and build files:
controller_sources='*.cpp *.cc *.cxx *.c *.h *.hpp *.hh *.hxx *.inl *.ipp *.o *.obj *.a *.d *.gch
  Makefile Makefile.* makefile GNUmakefile *.mk CMakeLists.txt CMakeCache.txt CMakePresets.json *.cmake *.ninja
  compile_commands.json *.pro *.vcxproj* *.sln'
# files of editors and the simulator (names starting with a dot, such as .git and .vscode, are never sent),
controller_leftovers='*~ *.bak *.orig *.rej *.swp #*# *.kate-swp *.core core.[0-9]* *.pyc runtime.ini *.exe *.dll *.so *.dylib'
# and folders with their contents.
controller_left_out_folders='build build-* cmake-build-* CMakeFiles __pycache__ CVS'

# Prints find's condition for "none of these names": not_named PATTERN...
not_named() {
  # Patterns are expanded by find, not by the shell.
  set -f
  # shellcheck disable=SC2048,SC2086  # the lists are words
  for pattern in $*; do printf ' ! -name %s' "'$pattern'"; done
  set +f
}

# Prints find's arguments that skip hidden files and folders unrelated to the controller.
pruned_folders() {
  set -f
  printf '%s' "\\( -name '.?*'"
  for pattern in $controller_left_out_folders; do printf " -o -type d -name '%s'" "$pattern"; done
  set +f
  printf '%s' ' \) -prune -o'
}

# Possible build inputs, including data: a source may include any file. One name per line, sorted.
list_build_files() { # FOLDER
  (cd "$1" && eval "find -L . $(pruned_folders) -type f $(not_named '*.o *.obj *.d *.gch') -print") | LC_ALL=C sort
}

# Files to send besides the program. One name per line, sorted.
list_data_files() { # FOLDER NAME
  (cd "$1" && eval "find -L . $(pruned_folders) -type f $(not_named "$controller_sources" "$controller_leftovers") -print") |
    LC_ALL=C grep -Fvx -- "./$2" | LC_ALL=C sort
}

# A downloaded folder may contain a link to a private file of the user. Sources may be links to anywhere: they are not sent.
refuse_links_outside() { # FOLDER
  root=$(cd "$1" && pwd -P) || die "cannot enter $1"
  # Only if there are links: this starts one process per file.
  [ -n "$(cd "$1" && eval "find . $(pruned_folders) -type l -print" | head -n 1)" ] || return 0
  odd=$(list_data_files "$1" "${1##*/}" | while IFS= read -r file; do
    place=$(readlink -f "$root/$file")
    case $place in "$root"/*) ;; *) printf '%s\n' "$1/${file#./} $msg_link_out, to $place" ;; esac
  done | head -n 1)
  [ -z "$odd" ] || die "$odd: replace the link by the file. Links within the folder are followed"
}

# Rejects files that cannot be sent, before the build.
check_controller_files() { # FOLDER
  looped=$(cd "$1" && eval "find -L . $(pruned_folders) -type f -name .never" 2>&1 >/dev/null) ||
    die "cannot read all of $1: $looped"
  odd=$(cd "$1" && eval "find -L . $(pruned_folders) -type l -print" | head -n 1)
  [ -z "$odd" ] || die "$1/${odd#./} is a link that leads nowhere: remove it, or put the file there"
  odd=$(cd "$1" && eval "find -L . $(pruned_folders) ! -type f ! -type d ! -type l -print" | head -n 1)
  [ -z "$odd" ] || die "$1/${odd#./} $msg_not_file (a pipe, socket or device) and cannot be sent: remove it"
  odd=$(cd "$1" && eval "find -L . $(pruned_folders) -name '*
*' -print" | head -n 1)
  [ -z "$odd" ] || die "$1 contains a name with a line break ($odd): rename it"
  refuse_links_outside "$1"
}
