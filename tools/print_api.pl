#!/usr/bin/env perl
# Prints the tables of docs/api.md: the public members of the installed headers, each with what it is here, by the header's
# comment ("Absent here: ...", or an abstract class) and by the simulator's API in tools/simulator_api.txt.
# Exit status 1: the headers lack a member of the simulator's API.
use strict;
use warnings;
use FindBin;
chdir "$FindBin::Bin/.." or die "cannot enter the source folder: $!\n";

my (%class, @order);  # name: file, base, members [{name, arguments, text, pure}], constants

# Rows of the table of absent devices.
sub absent_devices {
  my $text = read_file('webots/include/webots/absent_devices.hpp');
  return $text =~ /ROW\((\w+)\)/g;
}

sub read_file {
  my ($file) = @_;
  open my $in, '<', $file or die "cannot read $file: $!\n";
  local $/;
  return scalar <$in>;
}

# Names of the arguments of a declaration.
sub arguments {
  my ($list) = @_;
  $list =~ s{/\*|\*/}{}g;  # names of arguments that are not used
  $list =~ s/\s*=\s*(?:"[^"]*"|[^,]+)//g;
  return join ', ', map { /(\w+)\s*(?:\[\d*\])?\s*$/ ? $1 : () } grep { !/^\s*(?:void)?\s*$/ } split /,/, $list;
}

sub add_member {
  my ($name, $declared, $comment) = @_;
  my ($head) = $declared =~ /^(.*?)(?:\s:\s.*|\{.*)?$/s;  # before initialisers and body
  if ($declared =~ /^\s*enum\b/) {
    my ($kind, $names) = $declared =~ /enum\s*(\w*)\s*\{(.*)\}/s or return;
    push @{$class{$name}{constants}}, [$kind, map { /(\w+)/ } split /,/, $names];
    return;
  }
  return if $head =~ /^\s*(?:using|friend|typedef)\b|operator|~/;
  $head =~ /([\w]+)\s*\((.*)\)[^)]*$/s or return;
  my ($member, $list) = ($1, $2);
  return if $member eq $name && $list =~ /const \Q$name\E&/;
  push @{$class{$name}{members}}, {name => $member, arguments => arguments($list), text => $comment,
    pure => scalar($declared =~ /=\s*0\s*;\s*$/)};
}

sub parse {
  my ($file) = @_;
  my ($name, $public, $protected, $statement, @comment) = ('', 0, 0, '');
  for my $line (split /\n/, read_file($file)) {
    if ($line =~ m{^\s*///\s?(.*)}) {
      push @comment, $1;
    } elsif ($line =~ /DARWINOP_ABSENT_DEVICES\(DARWINOP_GETTER\)/) {
      add_member($name, "get$_(const std::string& name) const;", 'Absent here: NULL, with one warning per name.') for absent_devices();
    } elsif ($line =~ /DARWINOP_ABSENT_DEVICES\(DARWINOP_MAKER\)/) {
      add_member($name, "create$_(const std::string& name) const;", 'Absent here: NULL.') for absent_devices();
    } elsif ($line =~ /^\s*(public|protected|private):/) {
      ($public, @comment) = $1 ne 'private';
      $protected = $1 eq 'protected';
    } elsif ($statement eq '' && $line =~ /^(?:class|struct)\s+(\w+)(?:\s*:\s*public\s+([\w:]+))?\s*\{\s*(\};)?$/) {
      ($name, $public, $protected, @comment) = ($1, 0, 0);
      $class{$name} = {file => $file, base => $2 // '', members => [], constants => [], struct => $line =~ /^struct/ ? 1 : 0};
      push @order, $name;
    } elsif ($line =~ /^};/) {
      $public = 0;
    } elsif ($name ne '' && $public) {
      $line =~ s{\s*//.*}{};
      if ($line =~ /^\s*$/) {
        @comment = () if $statement eq '';
        next;
      }
      next if $line =~ /^#/;
      $statement .= "$line ";
      next if ($statement =~ tr/{//) != ($statement =~ tr/}//) || $statement !~ /[;}]\s*$/;
      # Of protected members controllers override makers of devices.
      add_member($name, $statement, join ' ', @comment) unless $protected && $statement !~ /^\s*virtual .*\bcreate[A-Z]\w*\(/;
      ($statement, @comment) = ('');
    }
  }
}

# The first sentence of a comment, without its mark.
sub summary {
  my ($text) = @_;
  my $absent = $text =~ s/^Absent here:\s*//;
  $text =~ s/(?<=[.])\s(?=[A-Z\d"`*\[-]).*//s unless $text =~ /^.{0,12}[.]\s/;
  $text =~ s/[|]/\\|/g;
  return $absent ? ucfirst $text : $text;
}

# Members of a class and of its bases, once each; those of Device and Robot belong to their own tables.
sub members {
  my ($name) = @_;
  my $base = $class{$name}{base};
  my @all = ($base ne '' && $base !~ /^(?:Device|Robot|Motor)$|Manager$/ ? members($base) : (), @{$class{$name}{members}});
  my %seen;
  return grep { !$seen{"$_->{name}($_->{arguments})"}++ } @all;
}

parse($_) for split /\n/, `git ls-files --cached --others --exclude-standard -- 'webots/include/*.hpp' 'managers/include/*.hpp'`;

my (%today, %earlier);
for (grep { !/^#/ } split /\n/, read_file('tools/simulator_api.txt')) {
  my ($name, @lists) = split /\s*[|]\s*/, $_, -1;
  $today{$name} = {map { $_ => 1 } split ' ', $lists[0] // ''};
  $earlier{$name} = {map { $_ => 1 } split ' ', $lists[1] // ''};
}

my @missing;
for my $name (sort keys %today) {
  my %has = exists $class{$name} ? map { $_->{name} => 1 } members($name) : ();
  push @missing, "$name: no such class" unless exists $class{$name};
  push @missing, map { "$name\::$_" } grep { !$has{$_} } sort keys %{$today{$name}}, keys %{$earlier{$name}};
}
if (@missing) {
  print STDERR "the installed headers lack $_\n" for @missing;
  exit 1;
}

sub mark {
  my ($name, $member) = @_;
  return 'absent' if $member->{pure} || $member->{text} =~ /^Absent here/;
  return 'works, earlier name' if $earlier{$name}{$member->{name}};
  return $today{$name}{$member->{name}} ? 'works' : 'addition';
}

my (%count, $tables, @absent);
$count{$_} = 0 for 'works', 'works, earlier name', 'absent', 'addition';
for my $name (sort { lc $a cmp lc $b } grep { !$class{$_}{struct} && $_ ne 'AbsentSensor' } @order) {
  my @members = members($name);
  my %by_mark;
  for my $member (@members) {
    my $mark = mark($name, $member);
    $count{$mark}++;
    push @{$by_mark{$mark}}, $member;
  }
  (my $link = $class{$name}{file}) =~ s{^}{../};
  my $title = "[`$name`]($link)";
  my $absent = @{$by_mark{absent} // []};
  if ($absent > 0 && @members - $absent < 5) {  # one row is enough
    my %seen;
    my $names = join ' ', map { "`$_`" } grep { !$seen{$_}++ } map { $_->{name} } @{$by_mark{absent}};
    my $works = join ' ', map { "`$_->{name}`" } grep { mark($name, $_) ne 'absent' } @members;
    push @absent, "| $title | $names | $works |\n";
    next;
  }
  my $base = $class{$name}{base};
  $tables .= "\n### $name\n\n$title" . ($base ne '' ? ", with the members of `$base`" : '') . "\n";
  $tables .= "\n| Member | Here | |\n|---|---|---|\n" if @members;
  $tables .= "| `$_->{name}($_->{arguments})` | " . mark($name, $_) . ' | ' . summary($_->{text}) . " |\n" for @members;
  for my $enum (@{$class{$name}{constants}}) {
    my ($kind, @names) = @$enum;
    $tables .= "\nConstants" . ($kind ? " of `$kind`" : '') . ': ' . join(' ', map { "`$_`" } @names) . "\n";
  }
}

printf "%d members work, %d of them under a name of an earlier version, %d are absent here, %d are additions of this library.\n",
  $count{works} + $count{'works, earlier name'}, $count{'works, earlier name'}, $count{absent}, $count{addition};
print $tables;
print "\n### Absent here\n\n| Class | Absent members | Members that work |\n|---|---|---|\n", @absent;
