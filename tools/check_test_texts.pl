#!/usr/bin/env perl
# Checks that no test repeats the words of a message, so that wording can change without breaking tests: it asserts a code,
# the facts in the message (file, line, key, value, command), or the constant that the program itself uses.
#
# A finding is a literal with two words or more that is part of a literal of the program: in a *_test.cpp, or in a line
# of a test in shell, JavaScript or Python that looks for a text (grep, expect_said, assert, getByText and the like); with
# FILE: in that file. Names of tests, comments, commands and what a test says when it fails (after << and fail) do not
# count, nor what only reads like one: its line says "no message" in a comment. Of a regular expression its parts
# between operators count.
use strict;
use warnings;
use Cwd qw(abs_path);
use FindBin;

my @given = map { abs_path($_) } @ARGV;
chdir "$FindBin::Bin/..";

my $quoted = qr/"((?:[^"\\\n]|\\.)*)"/;
my $single = qr/'([^'\n]*)'/;
my $template = qr/`([^`]*)`/;
my $regex = qr{[(, ]/((?:[^/\\\n]|\\.)+)/[a-z]*[,)]};
my $operator = qr/\.[*+?]|\[[^\]]*\][*+?]?|\\.|\$\{?\w+\}?|[\^\$()|]/;
my $looks_for = qr/\b(?:grep|said|expect_\w*(?:said|line)|await\w*)\b/;
my $asserts = qr/\bassert\w*\b|\b(?:getByText|says|includes|reads|becomes|\w+Is)\(|\bhasText\b/;
my $command = qr/^(?:darwinop|\.\/dev|--\w+|\w+::\w+\(\))/;
my $words = qr/[a-z]{2,}[ ,:]+[a-z]{2,}/;

my (@tests, $messages);
my @kinds = map { "'*.$_'" } qw(cpp hpp h sh js mjs py);
for my $file (split /\n/, `git ls-files --cached --others --exclude-standard --deduplicate -- @kinds`) {
  if ($file =~ m{^tests/}) {
    push @tests, $file if $file =~ /_test\.cpp$|\.(?:sh|mjs|py)$/;
    next;
  }
  next if $file =~ m{^tools/};
  open my $in, '<', $file or next;
  local $/;
  my $text = <$in>;
  $text =~ s/^\s*(?:#|\/\/).*$//mg;
  $text =~ s/"\s*\n\s*"//g;  # one literal over several lines
  $messages .= "\n$_" for $text =~ /$quoted/g;
  $messages .= "\n$_" for $file =~ /\.(?:sh|js)$/ ? ($text =~ /$single/g, $text =~ /$template/g) : ();
}

# The texts that a line of a test compares with what a program prints.
sub texts_of_cpp {
  my ($line) = @_;
  return if $line =~ /^\s*(?:TEST|#include|\/\/)|\/\/ no message/;
  $line =~ s/\/\/ .*//;
  $line =~ s/<<.*//;
  return $line =~ /$quoted/g;
}
sub texts_of_shell {
  my ($line) = @_;
  return if $line !~ $looks_for || $line =~ /^\s*#|# no message/;
  $line =~ s/\bfail .*//;
  return map { split $operator } $line =~ /$quoted/g, $line =~ /$single/g;
}
sub texts_of_script {
  my ($line) = @_;
  return if $line !~ $asserts || $line =~ m{^\s*(?://|#)|(?://|#) no message};
  $line =~ s/\w\['[^']*'\]//g;                              # keys
  $line =~ s/\bgetByText\('[^']*'\)\.(?:click|check)\(//g;  # labels of controls
  return map { split $operator } $line =~ /$quoted/g, $line =~ /$single/g, $line =~ /$regex/g;
}
sub texts_of {
  my ($file, $line) = @_;
  return texts_of_cpp($line) if $file !~ /\.(?:sh|mjs|py)$/;
  return map { s/^\s+|\s+$//gr } $file =~ /\.sh$/ ? texts_of_shell($line) : texts_of_script($line);
}

my $failed = 0;
for my $file (@given ? @given : @tests) {
  open my $in, '<', $file or die "cannot read $file: $!\n";
  while (my $line = <$in>) {
    for my $text (texts_of($file, $line)) {
      next if $text !~ $words || $text =~ $command || index($messages, $text) < 0;
      print STDERR "$file:$.: repeats words of a message: $text\n";
      $failed = 1;
    }
  }
}
exit $failed;
