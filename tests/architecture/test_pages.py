#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Each check of pages and tables fails on a tiny tree that breaks its rule, and passes on one that only just keeps it."""
import unittest

import codes
import coverage_table
import docs
import modules
import settings
from check_case import CheckCase


class Codes(CheckCase):
    GOOD = {
        "rewriter/model/codes.def": '// Retired, never used again: TZC1003\nX(TZC1001, "a", "b")\n',
        "rewriter/solve/a.cpp": "auto code = codes::TZC1001;\n",
        "docs/diagnostics/TZC1001.md": "",
        "tests/rewriter/golden/cases/plain/a.cpp": "// TZC1002\n//--- expected\n// publish TZC1001\n",
    }

    def test_good(self):
        self.assert_clean(codes.check, self.GOOD)

    def test_raised_by_nothing(self):
        self.assert_problem(codes.check, {**self.GOOD, "rewriter/solve/a.cpp": "// codes::TZC1001\n"}, "TZC1001: nothing")

    def test_the_report_does_not_raise(self):
        self.assert_problem(codes.check, {**self.GOOD, "rewriter/solve/a.cpp": "",
                                          "rewriter/report/text.cpp": "auto code = codes::TZC1001;\n"}, "TZC1001: nothing")

    def test_without_a_case(self):
        self.assert_problem(codes.check, {**self.GOOD, "tests/rewriter/golden/cases/plain/a.cpp": "// TZC1001\n//--- expected\n"},
                            "TZC1001: no test case")

    def test_another_test_is_a_case_unless_it_only_mentions_the_code(self):
        without = {**self.GOOD, "tests/rewriter/golden/cases/plain/a.cpp": ""}
        self.assert_problem(codes.check, {**without, "tests/rewriter/tool/a_test.cpp": "// TZC1001\n"}, "no test case")
        self.assert_clean(codes.check, {**without, "tests/rewriter/tool/a_test.cpp": 'EXPECT_EQ(code, "TZC1001");\n'})

    def test_without_a_page(self):
        good = {path: text for path, text in self.GOOD.items() if not path.startswith("docs/")}
        self.assert_problem(codes.check, good, "docs/diagnostics/TZC1001.md is missing")

    def test_a_page_without_a_code(self):
        self.assert_problem(codes.check, {**self.GOOD, "docs/diagnostics/TZC9999.md": ""}, "TZC9999: it is not in")

    def test_a_retired_code_with_a_page(self):
        self.assert_problem(codes.check, {**self.GOOD, "docs/diagnostics/TZC1003.md": ""}, "TZC1003: it is retired")


class Docs(CheckCase):
    DECISION = "# 001: A\n\nStatus: accepted\n\n## Context\n\nc\n\n## Decision\n\nd\n\n## Consequences\n\ne\n"
    GOOD = {"README.md": "[a](docs/a.md), [d](docs/decisions/) [web](https://example.org/x.md)\n", "docs/a.md": "a",
            "docs/decisions/README.md": "[1](001-a.md)", "docs/decisions/001-a.md": DECISION}

    def test_good(self):
        self.assert_clean(docs.check, self.GOOD)

    def test_a_link_to_nothing(self):
        self.assert_problem(docs.check, {**self.GOOD, "docs/a.md": "[b](b.md#part)"}, "docs/a.md: links to b.md")

    def test_a_path_that_does_not_exist(self):
        self.assert_clean(docs.check, {**self.GOOD, "docs/a.md": "`runtime/posix/x.{h,cpp}` `msggen`", "runtime/posix/x.h": "",
                                       "runtime/posix/x.cpp": ""})
        self.assert_problem(docs.check, {**self.GOOD, "docs/a.md": "`runtime/posix/y.h`"}, "names runtime/posix/y.h")

    def test_a_page_that_nothing_links_to(self):
        self.assert_problem(docs.check, {**self.GOOD, "docs/b.md": ""}, "docs/b.md: no page links to it")

    def test_a_decision_that_the_index_lacks(self):
        self.assert_problem(docs.check, {**self.GOOD, "docs/decisions/002-b.md": self.DECISION}, "002-b.md: no page links")

    def test_a_decision_of_another_form(self):
        self.assert_problem(docs.check, {**self.GOOD, "docs/decisions/001-a.md": "# 001: A\n\nBecause.\n"}, "has not the form")

    def test_a_diagnostics_page_of_another_form(self):
        page = "# TZC1001 a-b: c\n\n## Cause\n\nx\n\n## Why it matters\n\ny\n\n## Fix\n\nz\n"
        files = {**self.GOOD, "docs/diagnostics/README.md": "[1](TZC1001.md)", "docs/a.md": "[x](diagnostics/README.md)"}
        self.assert_clean(docs.check, {**files, "docs/diagnostics/TZC1001.md": page})
        self.assert_problem(docs.check, {**files, "docs/diagnostics/TZC1001.md": page.replace("Fix", "Remedy")}, "has not the form")


class ModuleTable(CheckCase):
    def tree(self, row):
        rows = [f"| `{module}` | job | {', '.join(_short(module, used) for used in uses)} |" for module, uses in modules.USES.items()]
        page = "\n".join(rows).replace("| `runtime/segment` | job | posix, sync_point |", row)
        return {"README.md": "[a](docs/architecture.md)", "docs/architecture.md": page + "\n"}

    def test_good(self):
        self.assert_clean(docs.check, self.tree("| `runtime/segment` | allocates | posix, sync_point |"))

    def test_a_row_that_allows_something_else(self):
        self.assert_problem(docs.check, self.tree("| `runtime/segment` | job | posix |"), "may use: posix, sync_point")

    def test_a_module_without_a_row(self):
        self.assert_problem(docs.check, self.tree(""), "the row of runtime/segment")

    def test_a_row_without_a_module(self):
        self.assert_problem(docs.check, self.tree("| `runtime/segment` | job | posix, sync_point |\n| `runtime/rooms` | job |  |"),
                            "the row of runtime/rooms")


def _short(module, used):
    product = module.split("/")[0] + "/"
    return used[len(product):] if used.startswith(product) else used


class CoverageTable(CheckCase):
    TESTS = "class Upgrade(TopicCase):\n    def test_twin(self): pass\n    def test_late(self): pass\nclass Helper: pass\n"
    PAGE = "tests/runtime/roscpp/README.md"

    def tree(self, row):
        return {"tests/runtime/roscpp/test_upgrade.py": self.TESTS,
                self.PAGE: f"| | test |\n| --- | --- |\n| as `ros::Publisher` or `Nobody` | {row} |\n"}

    def test_names_of_tests_and_classes(self):
        for row in ("`Upgrade.test_twin` (`shared`)", "`Upgrade`", "`test_late`", "`Upgrade.test_tw...`"):
            self.assert_clean(coverage_table.check, self.tree(row))

    def test_a_test_that_does_not_exist(self):
        self.assert_problem(coverage_table.check, self.tree("`Upgrade`, `Upgrade.test_gone`"), "no test Upgrade.test_gone")
        self.assert_problem(coverage_table.check, self.tree("`Upgrade`, `test_gone`"), "no test test_gone")
        self.assert_problem(coverage_table.check, self.tree("`Upgrade`, `Gone`"), "no test Gone")

    def test_a_class_that_no_row_names(self):
        self.assert_problem(coverage_table.check, self.tree("nothing"), "class Upgrade")


class Settings(CheckCase):
    CODE = 'constexpr Setting kSettings[] = {\n    {"policy", nullptr, read},\n    {"tries", "attempts",\n     read},\n};\n'
    PAGE = "| parameter | environment |\n| `policy` | `TZC_POLICY` | x |\n| `tries` | `TZC_TRIES` | y |\n| | `TZC_STATISTICS` | z |\n"

    def tree(self, code=CODE, page=PAGE, bench=None):
        return {"runtime/roscpp/settings.cpp": code, "docs/configuration.md": page,
                "bench/environment.cpp": page if bench is None else bench}

    def test_a_variable_that_the_benchmark_does_not_refuse(self):
        self.assert_problem(settings.check, self.tree(bench=self.PAGE.replace("TZC_STATISTICS", "")), "TZC_STATISTICS must stand here")

    def test_a_variable_that_there_is_not(self):
        self.assert_problem(settings.check, self.tree(bench=self.PAGE + "TZC_GONE"), "TZC_GONE must stand here")

    def test_good(self):
        self.assert_clean(settings.check, self.tree())

    def test_a_setting_without_a_row(self):
        self.assert_problem(settings.check, self.tree(page=self.PAGE.replace("| `tries` | `TZC_TRIES` | y |\n", "")),
                            "no row describes the setting tries")

    def test_a_row_without_a_setting(self):
        self.assert_problem(settings.check, self.tree(page=self.PAGE + "| `size` | `TZC_SIZE` | a |\n"), "size is not a setting")

    def test_a_wrong_variable(self):
        self.assert_problem(settings.check, self.tree(page=self.PAGE.replace("TZC_TRIES", "TZC_TRY")), "is TZC_TRIES, not TZC_TRY")

    def test_a_table_of_another_form(self):
        self.assert_problem(settings.check, self.tree(code="", page=""), "no setting was found")


if __name__ == "__main__":
    unittest.main()
