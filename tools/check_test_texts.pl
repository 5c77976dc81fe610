#!/usr/bin/env perl
# Checks that no test repeats the words of a message, so that wording can change without breaking tests: it asserts a code, the
# facts in the message (file, line, key, value, command), or the constant that the program itself uses.
#
# A finding is a literal in a *_test.cpp with two words or more that is part of a literal of the program; with FILE: in
# that file. Names of tests, comments, commands and what a test says when it fails (after <<) do not count, nor what only
# reads like one: its line says "// no message".
use strict;
use warnings;
use Cwd qw(abs_path);
use FindBin;

my @given = map { abs_path($_) } @ARGV;
chdir "$FindBin::Bin/..";

my $quoted = qr/"((?:[^"\\\n]|\\.)*)"/;
my $command = qr/^(?:darwinop|\.\/dev|--\w+|\w+::\w+\(\))/;
my $words = qr/[a-z]{2,}[ ,:]+[a-z]{2,}/;

my (@tests, $messages);
for my $file (split /\n/, `git ls-files --cached --others --exclude-standard --deduplicate -- '*.cpp' '*.hpp' '*.h'`) {
  if ($file =~ m{^tests/}) {
    push @tests, $file if $file =~ /_test\.cpp$/;
    next;
  }
  open my $in, '<', $file or next;
  local $/;
  my $text = <$in>;
  $text =~ s/^\s*(?:#|\/\/).*$//mg;
  $text =~ s/"\s*\n\s*"//g;  # one literal over several lines
  $messages .= "\n$_" for $text =~ /$quoted/g;
}

my $failed = 0;
for my $file (@given ? @given : @tests) {
  open my $in, '<', $file or die "cannot read $file: $!\n";
  while (my $line = <$in>) {
    next if $line =~ /^\s*(?:TEST|#include|\/\/)|\/\/ no message/;
    $line =~ s/\/\/ .*//;
    $line =~ s/<<.*//;
    for my $text ($line =~ /$quoted/g) {
      next if $text !~ $words || $text =~ $command || index($messages, $text) < 0;
      print STDERR "$file:$.: repeats words of a message: $text\n";
      $failed = 1;
    }
  }
}
exit $failed;
