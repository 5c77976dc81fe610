#!/usr/bin/env python3
"""print_test_results.py BUILD: a line for each GoogleTest test that CTest has run there:

PROGRAM SUITE.TEST passed|failed|skipped [CYCLES]

CYCLES: what the test measured (RecordProperty). A program that crashed has no line for its tests.
"""
import pathlib
import sys
import xml.etree.ElementTree

for file in sorted(pathlib.Path(sys.argv[1], "results").glob("*/*.xml")):
    for test in xml.etree.ElementTree.parse(file).iter("testcase"):
        if test.get("status") != "run":
            continue
        result = "failed" if test.find("failure") is not None else "skipped" if test.find("skipped") is not None else "passed"
        cycles = test.find("properties/property[@name='cycles']")
        print(file.parent.name, f"{test.get('classname')}.{test.get('name')}", result, cycles.get("value") if cycles is not None else "")
