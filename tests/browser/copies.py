"""Reads every report of the damaged copies with readers that are not ours; all must tell the same findings.

    copies.py SCHEMA FOLDER     FOLDER holds a folder a copy, with report.* and files.txt (tests/all/damage.rs)
"""

import json
import pathlib
import re
import sys
from urllib.parse import unquote, urlsplit

import html5lib
import jsonschema
import junitparser

SEVERITIES = {"info", "minor", "major", "critical", "blocker"}
LEVELS = {"error": "error", "warning": "warning", "info": "note"}


class Known:
    """What a copy holds: files, and folders, which end in a slash."""

    def __init__(self, files):
        self.files = set(files)
        parents = (parent for path in self.files for parent in pathlib.PurePosixPath(path).parents)
        self.folders = {f"{parent}/" for parent in parents}

    def holds(self, path, rule):
        # What is missing is told where it has to be.
        return path in self.files or path in self.folders or rule == "base-missing-file"

    def is_for_files(self, path, rule):
        """Whether a reader that knows only files can show it: a folder only where it has no file."""
        return self.holds(path, rule) and path not in self.folders


def sarif(text, known, schema):
    log = json.loads(text)
    errors = [f"{error.json_path}: {error.message[:200]}" for error in schema.iter_errors(log)]
    assert not errors, errors
    (run,) = log["runs"]
    rules = run["tool"]["driver"]["rules"]
    assert len({rule["id"] for rule in rules}) == len(rules), "a rule is declared once"
    found = []
    for result in run["results"]:
        assert rules[result["ruleIndex"]]["id"] == result["ruleId"], "the index leads to the rule"
        places = result["locations"] + result.get("relatedLocations", [])
        (standing,) = result["locations"]
        path = unquoted(standing["physicalLocation"]["artifactLocation"]["uri"])
        assert known.is_for_files(path, result["ruleId"]), f"code scanning is led to {path}"
        for place in places:
            artifact = place["physicalLocation"]["artifactLocation"]
            assert artifact["uriBaseId"] in run["originalUriBaseIds"], artifact
            path = unquoted(artifact["uri"])
            assert known.holds(path, result["ruleId"]), f"SARIF leads to {path}, which is not there"
            region = place["physicalLocation"].get("region", {})
            assert all(number >= 1 for number in region.values() if isinstance(number, int)), region
        (fingerprint,) = set(result["partialFingerprints"].values())
        found.append((result["ruleId"], result["level"], fingerprint))
    return found


def unquoted(uri):
    parts = urlsplit(uri)
    assert not parts.scheme and not parts.query and not parts.fragment, uri
    return unquote(parts.path)


def gitlab(text, known):
    found = []
    for one in json.loads(text):
        assert {"description", "check_name", "fingerprint", "severity", "location"} <= one.keys(), one
        assert one["severity"] in SEVERITIES and one["description"], one
        assert isinstance(one["location"]["lines"]["begin"], int) and one["location"]["lines"]["begin"] >= 1
        path = one["location"]["path"]
        assert known.is_for_files(path, one["check_name"]) and not path.startswith("./"), f"GitLab is led to {path}"
        found.append((one["check_name"], one["fingerprint"]))
    return found


def junit(path):
    suites = junitparser.JUnitXml.fromfile(str(path))
    cases = [case for suite in suites for case in suite]
    for suite in suites:
        assert suite.tests == len(list(suite)), suite.name
    assert suites.tests == len(cases) and suites.failures == sum(bool(case.result) for case in cases)
    return cases[1:], suites.failures


def page(text):
    tree = html5lib.HTMLParser(strict=True, namespaceHTMLElements=False).parse(text, transport_encoding="utf-8")
    articles = tree.findall(".//article")
    ids = [node.get("id") for node in tree.iter() if node.get("id")]
    assert len(set(ids)) == len(ids), "ids are used once"
    return [(article.get("data-rule"), article.get("data-level")) for article in articles]


def read(folder, schema):
    text = {path.suffix[1:]: path.read_text() for path in folder.glob("report.*")}
    known = Known((folder / "files.txt").read_text().split("\n"))
    report = json.loads(text["json"])
    findings = report["findings"]
    rules = sorted((one["rule"], one["level"]) for one in findings)
    prints = [one["fingerprint"] for one in findings]
    assert len(set(prints)) == len(prints), "fingerprints are unique"
    assert all(report["summary"][level] == sum(one == level for _, one in rules) for level in LEVELS)

    results = sarif(text["sarif"], known, schema)
    wanted = sorted((one["rule"], LEVELS[one["level"]], one["fingerprint"]) for one in findings)
    assert sorted(results) == wanted, "SARIF"
    quality = gitlab(text["gitlab"], known)
    assert sorted(quality) == sorted((one["rule"], one["fingerprint"]) for one in findings), "GitLab"
    cases, failures = junit(folder / "report.junit")
    failing = sum(one["level"] == "error" for one in findings)
    assert (len(cases), failures) == (len(findings), failing), ("JUnit", len(cases), failures)
    assert sorted(page((folder / "report.html").read_bytes())) == rules, "HTML"
    lines = re.findall(r"^.*?: (error|warning|info)\[([a-z0-9-]+)\] ", text["concise"], re.M)
    assert sorted((rule, level) for level, rule in lines) == rules, "concise"
    # Blocks, and a line for each info.
    heads = re.findall(r"^  (?:\S.*?: )?(error|warning|info)\[([a-z0-9-]+)\] ", text["human"], re.M)
    assert sorted((rule, level) for level, rule in heads) == rules, "human"
    bullets = re.findall(r"^- \*\*(error|warning|info)\*\* ", text["markdown"], re.M)
    assert sorted(bullets) == sorted(level for _, level in rules), "Markdown"
    notes = re.findall(r"^::(error|warning|notice) .*?title=mhlint%3A ([a-z0-9-]+)::", text["github"], re.M)
    left = "".join(re.findall(r"^(.*) more: GitHub shows", text["github"], re.M))
    more = sum(int(number) for number in re.findall(r"\d+", left))
    assert len(notes) + more == len(rules), ("GitHub", len(notes), more)
    return len(findings)


def main():
    schema = json.loads(pathlib.Path(sys.argv[1]).read_text())
    jsonschema.validators.validator_for(schema).check_schema(schema)
    schema = jsonschema.validators.validator_for(schema)(schema)
    folders = sorted(path.parent for path in pathlib.Path(sys.argv[2]).glob("*/report.json"))
    assert folders, "there are no copies"
    total, wrong = 0, []
    for folder in folders:
        try:
            total += read(folder, schema)
        except Exception as error:
            wrong.append(f"{folder.name}: {type(error).__name__}: {error}")
    assert not wrong, "\n" + "\n".join(wrong)
    print(f"{len(folders)} damaged copies: 9 reports of each tell the same, {total} findings")


main()
