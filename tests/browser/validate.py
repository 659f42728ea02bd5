"""Reads an HTML report with a strict HTML5 parser and a JUnit report with a JUnit parser."""

import sys

import html5lib
import junitparser

page, suites = sys.argv[1:]
with open(page, "rb") as file:
    tree = html5lib.HTMLParser(strict=True, namespaceHTMLElements=False).parse(file, transport_encoding="utf-8")
articles = tree.findall(".//article")
assert len(tree.findall(".//script")) == 1, "one script"
assert not tree.findall(".//img"), "no picture"

xml = junitparser.JUnitXml.fromfile(suites)
cases = [case for suite in xml for case in suite]
failed = sum(bool(case.result) for case in cases)
assert len(cases) == xml.tests == len(articles) + 1, (len(cases), xml.tests, len(articles))
assert failed == xml.failures, (failed, xml.failures)
print(f"{page}: {len(articles)} findings, well formed; {suites}: {len(cases)} cases, {failed} failed")
