#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Each check of the sources fails on a tiny tree that breaks its rule, and passes on one that only just keeps it."""
import os
import unittest

import classes
import clang_free
import ctags
import cycles
import includes
import modules
import package_xml
import parameters
import public_headers
from check_case import CheckCase
from problem import Problem, judge, read_exceptions
from source_tree import without_comments


class Includes(CheckCase):
    def test_a_module_below_may_be_used(self):
        self.assert_clean(includes.check, {"runtime/posix/a.h": "", "runtime/segment/b.cpp": '#include "posix/a.h"\n'})

    def test_a_module_above_must_not_be_used(self):
        self.assert_problem(includes.check,
                            {"runtime/segment/b.h": "", "runtime/posix/a.cpp": '// a\n#include "segment/b.h"\n'},
                            "runtime/posix/a.cpp:2", "runtime/posix must not use runtime/segment")

    def test_a_public_header_counts_as_its_module(self):
        self.assert_problem(includes.check, {"runtime/roscpp/include/tzc/ros.h": "",
                                             "runtime/message/a.cpp": "#include <tzc/ros.h>\n"},
                            "runtime/message must not use runtime/roscpp")

    def test_a_path_relative_to_the_file_is_followed(self):
        self.assert_problem(includes.check, {"runtime/segment/b.h": "", "runtime/posix/a.h": '#include "../segment/b.h"\n'},
                            "runtime/posix must not use runtime/segment")

    def test_products_do_not_use_each_other(self):
        self.assert_problem(includes.check, {"msggen/model/m.h": "", "rewriter/tool/t.cpp": '#include "model/m.h"\n'},
                            "rewriter/tool must not use msggen/model")

    def test_a_file_in_the_root_of_a_product_is_checked(self):
        self.assert_problem(includes.check, {"runtime/loose.cpp": ""}, "runtime/loose.cpp", "lies in no module")
        self.assert_problem(includes.check, {"runtime/loose.cpp": "#include <vector>\n"}, "lies in no module")

    def test_a_file_in_the_root_of_the_rewriter_is_checked(self):
        self.assert_problem(includes.check, {"rewriter/loose.h": '#include "solve/solve.h"\n', "rewriter/solve/solve.h": ""},
                            "rewriter/loose.h", "lies in no module")

    def test_an_unknown_folder_is_no_module(self):
        self.assert_problem(includes.check, {"rewriter/new_thing/x.h": ""}, "lies in no module")

    def test_foreign_headers(self):
        self.assert_problem(includes.check, {"runtime/channel/a.h": "#include <ros/ros.h>\n"}, "must not know ROS's nodes")

    def test_the_message_module_knows_messages_but_no_nodes(self):
        self.assert_clean(includes.check, {"runtime/message/a.h": "#include <ros/serialization.h>\n"})
        self.assert_problem(includes.check, {"runtime/message/a.h": "#include <ros/node_handle.h>\n"}, "must not know ROS's nodes")

    def test_boost_and_clang(self):
        self.assert_problem(includes.check, {"runtime/posix/a.h": "#include <boost/any.hpp>\n"}, "must not know Boost")
        os.remove(os.path.join(self.root, "runtime/posix/a.h"))
        self.assert_problem(includes.check, {"rewriter/report/a.h": '#include "llvm/ADT/Any.h"\n'}, "must not know Clang")

    def test_an_include_in_a_comment_does_not_count(self):
        self.assert_clean(includes.check, {"runtime/posix/a.h": '// see\n/*\n#include <ros/ros.h>\n*/\n'})


class Cycles(CheckCase):
    def test_two_headers(self):
        self.assert_problem(cycles.check, {"runtime/posix/a.h": '#include "posix/b.h"\n',
                                           "runtime/posix/b.h": '#include "posix/a.h"\n'},
                            "2 units", "runtime/posix/a, runtime/posix/b")

    def test_through_source_files_and_three_units(self):
        self.assert_problem(cycles.check, {
            "msggen/parse/a.h": "", "msggen/parse/a.cpp": '#include "parse/b.h"\n',
            "msggen/parse/b.h": "", "msggen/parse/b.cpp": '#include "parse/c.h"\n',
            "msggen/parse/c.h": '#include "a.h"\n'}, "3 units")

    def test_a_unit_includes_its_own_header(self):
        self.assert_clean(cycles.check, {"bench/a.h": "", "bench/a.cpp": '#include "a.h"\n#include "b.h"\n', "bench/b.h": ""})

    def test_modules(self):
        self.assertEqual(cycles.cycles({"a": ["b"], "b": ["c"], "c": ["a"], "d": ["a"]}), [("a", "b", "c")])


class ClangFree(CheckCase):
    def test_directly(self):
        self.assert_problem(clang_free.check, {"rewriter/solve/a.cpp": '#include "clang/AST/Decl.h"\n'}, "reaches Clang")

    def test_through_another_module(self):
        self.assert_problem(clang_free.check, {"rewriter/facts/f.h": "#include <clang/AST/Decl.h>\n",
                                               "rewriter/rules/r.h": '#include "facts/f.h"\n'},
                            "rewriter/rules/r.h -> rewriter/facts/f.h -> clang/AST/Decl.h")

    def test_solve_and_rules_are_among_the_modules_that_must_not(self):
        self.assertLessEqual({"rewriter/solve", "rewriter/rules", "rewriter/model"}, set(modules.CLANG_FREE))

    def test_facts_may(self):
        self.assert_clean(clang_free.check, {"rewriter/facts/f.h": "#include <clang/AST/Decl.h>\n"})


def class_with(count, member):
    return "namespace tzc {\nclass Big : public Base {\n" + "".join(member.format(n) for n in range(count)) + "};\n}\n"


class Classes(CheckCase):
    def test_methods(self):
        method = "  template <class T> int f{0}(const T& t, int n = 3) const {{ return n; }}\n"
        self.assert_problem(classes.check, {"bench/a.h": class_with(21, method)}, "tzc::Big has 21 methods")
        self.assert_clean(classes.check, {"bench/a.h": class_with(20, method)})

    def test_overloads_count_but_constructors_and_deleted_functions_do_not(self):
        self.assert_problem(classes.check, {"bench/a.h": class_with(21, "  void f(int (&)[{0}]);\n")}, "21 methods")
        self.assert_clean(classes.check, {"bench/a.h": class_with(21, "  Big(int (&)[{0}]);\n")})
        self.assert_clean(classes.check, {"bench/a.h": class_with(21, "  void f(int (&)[{0}]) = delete;\n")})

    def test_data_members(self):
        self.assert_problem(classes.check, {"bench/a.h": class_with(13, "  std::map<int, int> m{0}_{{}};\n")},
                            "tzc::Big has 13 data members")
        self.assert_clean(classes.check, {"bench/a.h": class_with(12, "  int m{0}_ = 1;\n")})
        self.assert_clean(classes.check, {"bench/a.h": class_with(13, "  static int m{0}_;\n")})

    def test_declarators_of_one_line_count_each(self):
        self.assert_problem(classes.check, {"bench/a.h": class_with(7, "  int a{0}_, *b{0}_ = nullptr;\n")}, "14 data members")

    def test_a_nested_class_counts_for_itself(self):
        nested = class_with(13, "  struct N{0} {{ int a, b, c; void f(); }};\n")
        self.assert_clean(classes.check, {"bench/a.h": nested})

    def test_in_a_source_file_and_an_anonymous_namespace(self):
        self.assert_problem(classes.check, {"rewriter/facts/a.cpp": "namespace {\n" + class_with(21, "  void f{0}();\n") + "}\n"},
                            "tzc::Big has 21 methods")

    def test_what_a_source_file_defines_is_not_counted_again(self):
        self.assert_clean(classes.check, {
            "bench/a.h": class_with(20, "  void f{0}();\n"),
            "bench/a.cpp": "namespace tzc {\n" + "".join(f"void Big::f{n}() {{}}\n" for n in range(20)) + "}\n"})


class Parameters(CheckCase):
    def test_eight_are_too_many(self):
        self.assert_problem(parameters.check, {"bench/a.h": "void f(int a, int b, int c, int d, int e, int f, int g, int h);\n"},
                            "f has 8 parameters")

    def test_seven_are_not(self):
        self.assert_clean(parameters.check, {"bench/a.h": "void f(int a, int b, int c, int d, int e, int f, std::map<int, int> g);\n"})

    def test_constructors_count(self):
        self.assert_problem(parameters.check,
                            {"bench/a.h": "class A {\n A(int a, int b, int c, int d, int e, int f, int g, int h);\n};\n"}, "A::A has 8")

    def test_few_of_five_in_the_rewriter(self):
        five = "void f{0}(int a, int b, int c, int d, int e);\n"
        text = "".join(five.format(n) for n in range(9))
        self.assert_clean(parameters.check, {"bench/a.h": text, "rewriter/edits/a.h": text.partition("\n")[2]})
        self.assert_problem(parameters.check, {"rewriter/edits/a.h": text}, "9 functions have 5 parameters")

    def test_declared_and_defined_is_one_function(self):
        five = "".join(f"void f{n}(int a, int b, int c, int d, int e)" + "{0}\n" for n in range(8))
        self.assert_clean(parameters.check, {"rewriter/edits/a.h": five.replace("{0}", ";"),
                                             "rewriter/edits/a.cpp": five.replace("{0}", " {}")})

    def test_the_commas_of_types_and_defaults(self):
        split = ctags.parameters
        self.assertEqual(split("()"), [])
        self.assertEqual(split("(void)"), [])
        self.assertEqual(len(split("(std::map<int, int> a = {1, 2}, int (*f)(int, int), int b = g(1, 2)) const")), 3)
        self.assertEqual(len(split("(F f = [](int a, int b) -> int { return a; }, int c)")), 2)


class PublicHeaders(CheckCase):
    def test_in_a_module(self):
        self.assert_clean(public_headers.check, {"runtime/posix/include/tzc/a.h": "#include <tzc/b.h>\n",
                                                 "runtime/segment/include/tzc/b.h": ""})

    def test_outside_of_a_module(self):
        self.assert_problem(public_headers.check, {"runtime/include/tzc/a.h": ""}, "outside of a module")

    def test_of_two_modules(self):
        self.assert_problem(public_headers.check, {"runtime/posix/include/tzc/a.h": "", "runtime/segment/include/tzc/a.h": ""},
                            "<tzc/a.h> is a header of runtime/posix, too")

    def test_a_private_header_is_not_installed(self):
        self.assert_problem(public_headers.check, {"runtime/posix/include/tzc/a.h": '#include "posix/p.h"\n', "runtime/posix/p.h": ""},
                            "posix/p.h, which is not installed")


class PackageXml(CheckCase):
    XML = "<package>\n<build_depend>roscpp</build_depend>\n<!-- <depend>rosbag_storage</depend> -->\n</package>\n"

    @staticmethod
    def check(tree):
        return package_xml.check(tree, {"roscpp", "rosbag_storage", "cv_bridge"})

    def test_what_is_included_is_declared(self):
        self.assert_clean(self.check, {"package.xml": self.XML, "compare/a.cpp": "#include <roscpp/Empty.h>\n#include <vector>\n"})

    def test_a_package_that_is_not_declared(self):
        self.assert_problem(self.check, {"package.xml": self.XML, "compare/a.cpp": "#include <rosbag/bag.h>\n"},
                            "compare/a.cpp:1", "package.xml lacks rosbag_storage")

    def test_a_folder_of_the_repository_is_no_package(self):
        self.assert_clean(self.check, {"package.xml": self.XML, "compare/cv_bridge/a.h": "",
                                       "compare/a.cpp": '#include "cv_bridge/a.h"\n'})

    def test_the_adapters_are_the_users_choice(self):
        self.assert_clean(self.check, {"package.xml": self.XML,
                                       "runtime/adapters/include/tzc/a.h": "#include <cv_bridge/cv_bridge.h>\n"})


class Exceptions(unittest.TestCase):
    def test_only_what_is_named_is_excepted(self):
        problems = [Problem("a", "a.h:1", "bad"), Problem("b", "b.h:2", "worse")]
        self.assertEqual(list(judge(problems, {"a": "reason"})), ["b.h:2: worse"])

    def test_one_that_is_not_needed_is_a_complaint(self):
        self.assertEqual(len(list(judge([], {"a": "reason"}))), 1)

    def test_the_file(self):
        lines = ["# comment\n", "\n", "classes tzc::Array methods: has the interface of std::vector\n"]
        self.assertEqual(read_exceptions(lines), {"classes": {"tzc::Array methods": "has the interface of std::vector"}})

    def test_a_reason_is_needed(self):
        for line in ("classes tzc::Array methods\n", "classes tzc::Array methods: \n"):
            with self.assertRaises(SystemExit):
                read_exceptions([line])


class Text(unittest.TestCase):
    def test_comments_are_blanked_and_strings_stay(self):
        self.assertEqual(without_comments('a /* x\n y */ b // z\n"//c" d\n'), 'a     \n      b     \n"//c" d\n')


if __name__ == "__main__":
    unittest.main()
